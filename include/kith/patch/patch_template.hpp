// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "child_numbers.hpp"
#include "face_walk.hpp"
#include "patch_numbers.hpp"
#include "refine_part.hpp"

#include <kith/lane/lane_program_maker.hpp>
#include <kith/lane/tape.hpp>
#include <kith/level/native_level.hpp>
#include <kith/step/step.hpp>
#include <kith/step/submesh.hpp>

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

/// What some steps make of a face and its neighbourhood, for all faces whose neighbourhoods are alike: where the coarse points are,
/// how they become the fine ones, and which numbers are written where. Made once, by the scheme's own text. A face owns what it,
/// its left sides of edges and the starts of fans in it give birth to: the points and starts of these vertices, the corners of
/// these faces, what lies on the half-edges at these corners, and that nothing lies across where they are at the boundary.
template <std::floating_point Scalar, std::unsigned_integral Index>
struct patch_template {
    using numbers = patch_numbers<Index>;

    /// An element of the coarse level whose number others follow from: the vertex of a corner, its edge, its face.
    struct source {
        tuple_kind kind; ///< v, e or f
        walked_corner at;
    };

    std::vector<walk_step> steps;
    std::vector<walked_corner> inputs; ///< those whose vertices fill the first slots of the program
    lane_program<Scalar> program;      ///< its outputs are the points of the owned vertices
    std::vector<source> sources;
    std::vector<typename numbers::multiple> multiples;
    std::vector<typename numbers::run> vertices, corners, halfedges; ///< the places that are written
    typename numbers::list vertex_corner, vertex_halfedge, corner_vertex, corner_halfedge,
        halfedge_corner; ///< what is written, run after run

    [[nodiscard]] std::size_t bytes() const
    {
        const auto of = [](const auto&... list) { return ((list.size() * sizeof(list[0])) + ...); };
        const auto of_numbers = [&](const auto&... list) { return (of(list.offset, list.of) + ...); };
        return program.bytes() + of(steps, inputs, sources, multiples, vertices, corners, halfedges) +
               of_numbers(vertex_corner, vertex_halfedge, corner_vertex, corner_halfedge, halfedge_corner);
    }
};

/// Makes templates of a scheme for the faces of one level.
template <scheme Scheme, class Point, std::unsigned_integral Index>
class template_maker {
    using scalar = scalar_of<Point>;
    using value = recorded<scalar>;
    using result = patch_template<scalar, Index>;
    using numbering = numbering_of<Scheme, Index>;
    static constexpr int degree = int(numbering::common_degree);
    static constexpr double cost_of_cut = 0; // what is written down costs more

public:
    /// For the level of a mesh, which has its edges and the degree of refined faces and must outlive this, and one step for
    /// each of the bases, by the scheme of the level.
    template_maker(const basic_mesh<Point, Index>& mesh, const Scheme& scheme, std::span<const column_bases> bases)
        : mesh_(mesh)
        , scheme_(scheme)
        , plain_(without_state(scheme))
        , bases_(bases)
        , rings_(rings_before_steps(scheme, bases.size()))
    {
    }

    /// Of the face that was walked around last; nothing where it is too large to be numbered.
    [[nodiscard]] std::optional<result> make(const face_walk<Index>& walk)
    {
        std::vector<Index> faces(walk.faces().begin(), walk.faces().end());
        std::ranges::sort(faces);
        if (not cutter_)
            cutter_.emplace(mesh_);
        const auto part = cutter_->cut(faces);
        const sources_of_part sources(part, walk.faces());

        auto numbers = sources.numbers();
        storage<value> points(part.mesh.vertex_count());
        for (std::size_t v = 0; v < points.size(); ++v)
            points[v] = value(std::uint32_t(v));
        tape_.restart(points.size());
        const recording<scalar> here(tape_);
        const auto refine = [&](const basic_mesh<value, Index>& mesh, const Scheme& of_level, numbering& ids) {
            const level_elements<native_level<value, Index, degree>> level(mesh);
            return refine_level<connect::everything>(level, of_level, mesh.generation(), ids);
        };
        Scheme scheme = plain_;
        take_state_of_part(scheme, scheme_, part.numbers());
        const auto before_last = refine_part(
            basic_mesh<value, Index>(std::move(points), part.mesh.topology(), mesh_.generation()),
            scheme,
            numbers,
            bases_,
            rings_,
            [&](const affine_number<Index>& face) { return face.source == sources.centre(); },
            cost_of_cut,
            refine);
        numbering ids;
        const auto fine = refine(before_last, scheme, ids);
        numbers = numbers.next(ids, bases_.back());
        return assemble(walk, sources, numbers, fine);
    }

private:
    using affine_numbers = part_of_whole<affine_number<Index>>;

    /// Elements of a part of the coarse level by corners of the walk, and which the first face owns.
    class sources_of_part {
    public:
        sources_of_part(const submesh<Point, Index>& part, std::span<const Index> walked)
            : topology_(part.mesh.topology())
            , at_(topology_.vertices + topology_.edges() + topology_.faces, nowhere)
            , centre_(position(part, walked[0]))
        {
            for (std::size_t f = 0; f < walked.size(); ++f) {
                const std::size_t face = position(part, walked[f]);
                for (std::size_t i = 0; i < std::size_t(degree); ++i) {
                    const std::size_t c = std::size_t(degree) * face + i;
                    const walked_corner corner{std::uint16_t(f), std::uint16_t(i)};
                    for (const std::size_t id :
                         {vertex(topology_.corner_vertex[c]), edge(topology_.corner_halfedge[c] / 2), of_face(face)})
                        if (at_[id].face == nowhere.face)
                            at_[id] = corner;
                }
            }
            turned_.assign(part.edge_is_turned.begin(), part.edge_is_turned.end());
        }

        [[nodiscard]] affine_numbers numbers() const
        {
            std::uint32_t id = 0;
            const auto in_turn = [&](std::size_t count) {
                storage<affine_number<Index>> result(count);
                for (auto& number : result)
                    number = {0, 1, id++};
                return result;
            };
            affine_numbers result{{}, {}, {}, std::size_t(degree)};
            result.vertices = in_turn(topology_.vertices);
            result.edges = in_turn(topology_.edges());
            result.faces = in_turn(topology_.faces);
            return result;
        }
        [[nodiscard]] typename result::source source(std::uint32_t id) const
        {
            return {id < edge(0) ? tuple_kind::v : id < of_face(0) ? tuple_kind::e : tuple_kind::f, at_[id]};
        }
        [[nodiscard]] std::size_t size() const { return at_.size(); }
        [[nodiscard]] std::uint32_t centre() const { return std::uint32_t(of_face(centre_)); }
        [[nodiscard]] bool is_owned(std::uint32_t id) const
        {
            if (id < edge(0))
                return topology_.vertex_corner[id] / degree == centre_;
            if (id < of_face(0))
                return topology_.halfedge_corner[2 * (id - edge(0))] / degree == centre_ and not turned_[id - edge(0)];
            return id == centre();
        }
        [[nodiscard]] walked_corner corner_of_vertex(std::size_t v) const { return at_[v]; }

    private:
        static constexpr walked_corner nowhere{std::numeric_limits<std::uint16_t>::max(), 0};

        static std::size_t position(const submesh<Point, Index>& part, Index face)
        {
            return std::size_t(std::ranges::lower_bound(part.face_from, face) - part.face_from.begin());
        }
        [[nodiscard]] std::size_t vertex(std::size_t v) const { return v; }
        [[nodiscard]] std::size_t edge(std::size_t e) const { return topology_.vertices + e; }
        [[nodiscard]] std::size_t of_face(std::size_t f) const { return topology_.vertices + topology_.edges() + f; }

        const connectivity<Index>& topology_;
        std::vector<walked_corner> at_;
        std::size_t centre_;
        std::vector<bool> turned_;
    };

    using number = affine_number<Index>;

    static number corner_of(const number& face, std::size_t corner) { return face.child(corner, degree); }

    static auto order_of(const number& n) { return std::tuple(n.source, n.factor, n.offset); }

    /// Those of some elements, in the order of their numbers.
    template <class IsOne>
    static std::vector<std::uint32_t> in_order(const storage<number>& numbers, const IsOne& is_one)
    {
        std::vector<std::uint32_t> result;
        for (std::uint32_t i = 0; i < numbers.size(); ++i)
            if (is_one(numbers[i]))
                result.push_back(i);
        std::ranges::sort(result, {}, [&](std::uint32_t i) { return order_of(numbers[i]); });
        return result;
    }

    std::optional<result> assemble(const face_walk<Index>& walk, const sources_of_part& sources,
                                   const affine_numbers& numbers, const basic_mesh<value, Index>& fine)
    {
        result made;
        made.steps.assign(walk.steps().begin(), walk.steps().end());
        listed_.restart(sources.size());
        const auto owned = in_order(numbers.vertices, [&](const number& n) { return sources.is_owned(n.source); });
        list_vertices(owned, numbers, fine.topology(), made);
        list_faces(in_order(numbers.faces, [&](const number& n) { return n.source == sources.centre(); }),
                   numbers,
                   fine.topology(),
                   made);
        if (listed_.is_too_long())
            return {};
        made.multiples = listed_.multiples();
        for (const std::uint32_t source : listed_.sources())
            made.sources.push_back(sources.source(source));

        std::vector<std::uint32_t> outputs;
        for (const std::uint32_t v : owned)
            outputs.push_back(fine.point(v).value);
        made.program = programs_.make(tape_, outputs);
        if (made.program.is_too_long())
            return {};
        for (const std::uint32_t v : made.program.inputs())
            made.inputs.push_back(sources.corner_of_vertex(v));
        return made;
    }

    void list_vertices(std::span<const std::uint32_t> owned, const affine_numbers& numbers,
                       const connectivity<Index>& fine, result& made)
    {
        std::vector<number> vertices, starts, leaving;
        for (const std::uint32_t v : owned) {
            const Index start = fine.vertex_corner[v];
            vertices.push_back(numbers.vertices[v]);
            const Index h = fine.corner_halfedge[start];
            leaving.push_back(numbers.edges[h / 2].child(h % 2, 2));
            starts.push_back(corner_of(numbers.faces[start / degree], start % degree));
        }
        made.vertices = listed_.runs(vertices);
        made.vertex_halfedge = listed_.all(leaving);
        made.vertex_corner = listed_.all(starts);
    }

    void list_faces(std::span<const std::uint32_t> own, const affine_numbers& numbers, const connectivity<Index>& fine,
                    result& made)
    {
        std::vector<number> corners, vertices, halfedges;
        std::vector<std::pair<number, number>> sides;
        for (const std::uint32_t f : own)
            for (std::size_t i = 0; i < degree; ++i) {
                const std::size_t c = degree * f + i;
                const Index h = fine.corner_halfedge[c];
                const number& edge = numbers.edges[h / 2];
                corners.push_back(corner_of(numbers.faces[f], i));
                vertices.push_back(numbers.vertices[fine.corner_vertex[c]]);
                halfedges.push_back(edge.child(h % 2, 2));
                sides.emplace_back(halfedges.back(), corners.back());
                if (fine.is_boundary(h / 2))
                    sides.emplace_back(edge.child(1, 2), number{fine.none, 0, edge.source});
            }
        made.corners = listed_.runs(corners);
        made.corner_vertex = listed_.all(vertices);
        made.corner_halfedge = listed_.all(halfedges);

        std::ranges::sort(sides, {}, [](const auto& side) { return order_of(side.first); });
        std::vector<number> at, across;
        for (const auto& [halfedge, corner] : sides) {
            at.push_back(halfedge);
            across.push_back(corner);
        }
        made.halfedges = listed_.runs(at);
        made.halfedge_corner = listed_.all(across);
    }

    const basic_mesh<Point, Index>& mesh_;
    const Scheme& scheme_;
    Scheme plain_; // without its state
    std::span<const column_bases> bases_;
    std::vector<int> rings_;
    std::optional<submesh_cutter<Point, Index>> cutter_; // from the first template on: often all are kept ones
    // What every template needs room for:
    tape<scalar> tape_;
    lane_program_maker<scalar> programs_;
    patch_numbers<Index> listed_;
};

} // namespace kith
