// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "child_numbers.hpp"
#include "patch_numbers.hpp"
#include "patch_template.hpp"

#include <kith/core/mesh/basic_mesh.hpp>
#include <kith/engine/lane/lane_program_maker.hpp>
#include <kith/engine/lane/tape.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace kith {

/// The elements of a part of the coarse level. For each it tells the model that owns it, and the corner where a walk
/// around a model meets it. Models are the faces for which templates are made.
template <std::unsigned_integral Index>
class sources_of_part {
public:
    static constexpr std::uint32_t no_model = std::numeric_limits<std::uint32_t>::max();

    /// Takes the connectivity of a part, which must outlive this. `face_from` are the faces of the level that the part
    /// has, in increasing order; the models are among them. `degree` is that of all faces of any level, or 0 if they
    /// have several.
    sources_of_part(const connectivity<Index>& part, std::size_t degree, std::span<const Index> face_from,
                    std::span<const unsigned char> edge_is_turned, std::span<const Index> models)
        : topology_(part)
        , degree_(degree)
        , face_from_(face_from)
        , turned_(edge_is_turned)
        , model_of_(topology_.faces, no_model)
        , at_(topology_.vertices + topology_.edges() + 2 * topology_.faces)
    {
        for (std::size_t m = 0; m < models.size(); ++m)
            model_of_[position(models[m])] = std::uint32_t(m);
    }

    /// Notes where a walk by these faces has met each element. Cost: O(elements of the part).
    void walked(std::span<const Index> faces)
    {
        std::ranges::fill(at_, nowhere);
        for (std::size_t f = 0; f < faces.size(); ++f) {
            const std::size_t face = position(faces[f]);
            const Index first = topology_.first_corner(face), end = topology_.first_corner(face + 1);
            for (Index c = first; c < end; ++c) {
                const walked_corner corner{std::uint16_t(f), std::uint16_t(c - first)};
                for (const std::size_t id : {vertex(topology_.corner_vertex[c]),
                                             edge(topology_.corner_halfedge[c] / 2),
                                             of_face(face),
                                             corners_of(face)})
                    if (at_[id].face == nowhere.face)
                        at_[id] = corner;
            }
        }
    }

    /// Returns the numbers of all elements, each of which is the source of its own number.
    [[nodiscard]] part_of_whole<affine_number<Index>> numbers() const
    {
        std::uint32_t id = 0;
        const auto in_turn = [&](std::size_t count) {
            storage<affine_number<Index>> result(count);
            for (auto& number : result)
                number = {0, 1, id++};
            return result;
        };
        part_of_whole<affine_number<Index>> result{{}, {}, {}, {}, degree_};
        result.vertices = in_turn(topology_.vertices);
        result.edges = in_turn(topology_.edges());
        result.faces = in_turn(topology_.faces);
        if (degree_ == 0)
            result.first_corners = in_turn(topology_.faces);
        return result;
    }
    [[nodiscard]] bool is_walked(std::uint32_t id) const { return at_[id].face != nowhere.face; }
    /// Returns an element as a corner of the last walk. Precondition: the walk has met it.
    [[nodiscard]] walked_element source(std::uint32_t id) const
    {
        return {id < edge(0)         ? tuple_kind::v
                : id < of_face(0)    ? tuple_kind::e
                : id < corners_of(0) ? tuple_kind::f
                                     : tuple_kind::vf,
                at_[id]};
    }
    [[nodiscard]] std::size_t size() const { return at_.size(); }
    /// Returns the model that owns an element, or no_model.
    [[nodiscard]] std::uint32_t owner(std::uint32_t id) const
    {
        if (id < edge(0))
            return model_of_[topology_.face_of(topology_.vertex_corner[id])];
        if (id < of_face(0))
            return turned_[id - edge(0)] ? no_model
                                         : model_of_[topology_.face_of(topology_.halfedge_corner[2 * (id - edge(0))])];
        return model_of_[(id - of_face(0)) % topology_.faces];
    }

private:
    static constexpr walked_corner nowhere{std::numeric_limits<std::uint16_t>::max(), 0};

    [[nodiscard]] std::size_t position(Index face) const
    {
        return std::size_t(std::ranges::lower_bound(face_from_, face) - face_from_.begin());
    }
    [[nodiscard]] std::size_t vertex(std::size_t v) const { return v; }
    [[nodiscard]] std::size_t edge(std::size_t e) const { return topology_.vertices + e; }
    [[nodiscard]] std::size_t of_face(std::size_t f) const { return topology_.vertices + topology_.edges() + f; }
    [[nodiscard]] std::size_t corners_of(std::size_t f) const { return of_face(topology_.faces) + f; }

    const connectivity<Index>& topology_;
    std::size_t degree_;
    std::span<const Index> face_from_;
    std::span<const unsigned char> turned_;
    std::vector<std::uint32_t> model_of_; // by face of the part
    std::vector<walked_corner> at_;       // by source: vertices, edges, faces, their corners
};

/// An assembler of templates from what some steps have made of a neighbourhood. It does not know the scheme.
template <std::floating_point Scalar, std::unsigned_integral Index>
class template_assembler {
    using result = patch_template<Scalar, Index>;
    using number = affine_number<Index>;
    using affine_numbers = part_of_whole<number>;

public:
    /// Returns the template of the face of the last walk, which owns these vertices and faces of `fine`. `fine` is the
    /// last level of a part with the neighbourhood of that face; `numbers` and `tape` belong to it. Returns nothing if
    /// the template is too large to be numbered. Returns nothing either if it depends on elements that the walk has not
    /// met, since the scheme reaches further than it says. Cost: that of the program, and of sorting numbers.
    [[nodiscard]] std::optional<result> assemble(const face_walk<Index>& walk, std::span<std::uint32_t> vertices,
                                                 std::span<std::uint32_t> faces, const sources_of_part<Index>& sources,
                                                 const affine_numbers& numbers,
                                                 const basic_mesh<recorded<Scalar>, Index>& fine,
                                                 const tape<Scalar>& tape)
    {
        result made;
        made.steps.assign(walk.steps().begin(), walk.steps().end());
        listed_.restart(sources.size());
        put_in_order(vertices, numbers.vertices);
        put_in_order(faces, numbers.faces);
        list_vertices(vertices, numbers, fine.topology(), made);
        list_faces(faces, numbers, fine.topology(), made);
        const auto are_walked = [&](std::span<const std::uint32_t> ids) {
            return std::ranges::all_of(ids, [&](std::uint32_t id) { return sources.is_walked(id); });
        };
        if (listed_.is_too_long() or not are_walked(listed_.sources()))
            return {};
        made.multiples = listed_.multiples();
        for (const std::uint32_t source : listed_.sources())
            made.sources.push_back(sources.source(source));

        std::vector<std::uint32_t> outputs;
        for (const std::uint32_t v : vertices)
            outputs.push_back(fine.point(v).value);
        made.program = programs_.make(tape, outputs);
        if (made.program.is_too_long() or not are_walked(made.program.inputs()))
            return {};
        for (const std::uint32_t v : made.program.inputs())
            made.inputs.push_back(sources.source(v));
        leave_out_unread_faces(made);
        return made;
    }

private:
    /// Leaves out the faces of the walk that the patch does not need. The class of a face depends on more rings than
    /// those from which its patch reads points and numbers. For sqrt(3) they have 72 faces, of which half are read or
    /// lead to one that is.
    static void leave_out_unread_faces(result& made)
    {
        std::vector<bool> is_read(made.steps.size() + 1, false);
        is_read[0] = true;
        const auto for_elements = [&](const auto& f) {
            std::ranges::for_each(made.inputs, f);
            std::ranges::for_each(made.sources, f);
        };
        for_elements([&](const walked_element& element) { is_read[element.at.face] = true; });
        for (std::size_t f = made.steps.size(); f > 0; --f)
            if (is_read[f])
                is_read[made.steps[f - 1].from.face] = true;

        std::vector<std::uint16_t> new_place(is_read.size(), 0);
        std::size_t kept = 0;
        for (std::size_t f = 1; f < is_read.size(); ++f)
            if (is_read[f]) {
                walk_step step = made.steps[f - 1];
                step.from.face = new_place[step.from.face];
                made.steps[kept++] = step;
                new_place[f] = std::uint16_t(kept);
            }
        made.steps.resize(kept);
        for_elements([&](walked_element& element) { element.at.face = new_place[element.at.face]; });
    }

    static number number_of_corner(const affine_numbers& numbers, const connectivity<Index>& fine, Index corner)
    {
        const Index face = fine.face_of(corner);
        return numbers.corner(face, corner - fine.first_corner(face));
    }

    static auto order_of(const number& n) { return std::tuple(n.source, n.factor, n.path, n.offset); }

    /// Sorts elements by their numbers in the whole mesh.
    static void put_in_order(std::span<std::uint32_t> elements, const storage<number>& numbers)
    {
        std::ranges::sort(elements, {}, [&](std::uint32_t i) { return order_of(numbers[i]); });
    }

    void list_vertices(std::span<const std::uint32_t> owned, const affine_numbers& numbers,
                       const connectivity<Index>& fine, result& made)
    {
        std::vector<number> vertices, starts, leaving;
        for (const std::uint32_t v : owned) {
            const Index start = fine.vertex_corner[v];
            vertices.push_back(numbers.vertices[v]);
            const Index h = fine.corner_halfedge[start];
            leaving.push_back(numbers.edges[h / 2].of_each(h % 2, 2));
            starts.push_back(number_of_corner(numbers, fine, start));
        }
        made.vertices = listed_.runs(number_kind::vertex, vertices);
        made.vertex_halfedge = listed_.all(number_kind::side, leaving);
        made.vertex_corner = listed_.all(number_kind::corner, starts);
    }

    void list_faces(std::span<const std::uint32_t> own, const affine_numbers& numbers, const connectivity<Index>& fine,
                    result& made)
    {
        std::vector<number> corners, vertices, halfedges;
        std::vector<std::pair<number, number>> sides;
        std::vector<number> faces;
        std::vector<std::uint32_t> degrees;
        for (const std::uint32_t f : own) {
            const Index first = fine.first_corner(f), end = fine.first_corner(f + std::size_t(1));
            faces.push_back(numbers.faces[f]);
            degrees.push_back(std::uint32_t(end - first));
            for (Index c = first; c < end; ++c) {
                const Index h = fine.corner_halfedge[c];
                const number& edge = numbers.edges[h / 2];
                corners.push_back(numbers.corner(f, c - first));
                vertices.push_back(numbers.vertices[fine.corner_vertex[c]]);
                halfedges.push_back(edge.of_each(h % 2, 2));
                sides.emplace_back(halfedges.back(), corners.back());
                if (fine.is_boundary(h / 2))
                    sides.emplace_back(edge.of_each(1, 2), number{fine.none, 0, edge.source});
            }
        }
        made.corners = listed_.runs(number_kind::corner, corners);
        made.corner_vertex = listed_.all(number_kind::vertex, vertices);
        made.corner_halfedge = listed_.all(number_kind::side, halfedges);

        std::ranges::sort(sides, {}, [](const auto& side) { return order_of(side.first); });
        std::vector<number> at, across;
        for (const auto& [halfedge, corner] : sides) {
            at.push_back(halfedge);
            across.push_back(corner);
        }
        made.halfedges = listed_.runs(number_kind::side, at);
        made.halfedge_corner = listed_.all(number_kind::corner, across);
        made.multiples_of_others = listed_.multiples().size();
        made.faces = listed_.runs_of_faces(faces, degrees);
    }

    // Reused for one template after the other:
    lane_program_maker<Scalar> programs_;
    patch_numbers<Index> listed_;
};

} // namespace kith
