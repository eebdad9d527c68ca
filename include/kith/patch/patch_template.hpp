// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "child_numbers.hpp"
#include "face_walk.hpp"
#include "lane_program.hpp"
#include "refine_part.hpp"
#include "tape.hpp"

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
/// how they become the fine ones, which numbers those and the new faces have. Made once, by the scheme's own text. A face owns
/// what it, its left sides of edges and the starts of fans in it give birth to.
template <std::floating_point Scalar, std::unsigned_integral Index>
struct patch_template {
    /// An element of the coarse level whose number others follow from: the vertex of a corner, its edge, its face.
    struct source {
        tuple_kind kind; ///< v, e or f
        walked_corner at;
    };
    /// New elements of one kind whose numbers follow from those of one element each: offset + factor * number of the source.
    struct new_elements {
        std::vector<source> sources;
        std::vector<std::uint32_t> end; ///< those of source i come before end[i], after those of the sources before it
        std::vector<Index> offset, factor;

        [[nodiscard]] std::size_t size() const { return offset.size(); }
    };
    /// New faces whose numbers follow one another: offset + factor * that of the face itself.
    struct face_run {
        Index offset, factor;
        std::size_t count;
    };
    using place = std::uint16_t; ///< in one of the lists

    std::vector<walk_step> steps;
    std::vector<walked_corner> inputs; ///< those whose vertices fill the first slots of the program
    lane_program<Scalar> program;
    new_elements vertices;      ///< those of the owned faces
    std::vector<place> outputs; ///< the owned ones among them, which are the outputs of the program
    std::vector<face_run> runs;
    std::vector<place> corners; ///< of the faces, run after run: their vertices
};

/// Makes templates of a scheme for the faces of one level.
template <scheme Scheme, class Point, std::unsigned_integral Index>
class template_maker {
    using scalar = scalar_of<Point>;
    using value = recorded<scalar>;
    using result = patch_template<scalar, Index>;
    using numbering = numbering_of<Scheme, Index>;
    static constexpr int degree = int(numbering::common_degree);

public:
    /// For the level of a mesh, which has its edges and the degree of refined faces and must outlive this, and one step for
    /// each of the bases.
    template_maker(const basic_mesh<Point, Index>& mesh, const Scheme& scheme, std::span<const column_bases> bases)
        : mesh_(mesh), scheme_(scheme), bases_(bases), rings_(rings_before_steps(scheme, bases.size())), cutter_(mesh)
    {
    }

    /// Of the face that was walked around last; nothing where it is too large to be numbered.
    [[nodiscard]] std::optional<result> make(const face_walk<Index>& walk)
    {
        std::vector<Index> faces(walk.faces().begin(), walk.faces().end());
        std::ranges::sort(faces);
        const auto part = cutter_.cut(faces);
        const sources_of_part sources(part, walk.faces());

        tape<scalar> tape;
        const recording<scalar> here(tape);
        auto numbers = sources.numbers();
        storage<value> points(part.mesh.vertex_count());
        for (std::size_t v = 0; v < points.size(); ++v)
            points[v] = value(std::uint32_t(v));
        tape.values.assign(points.size(), tape.none);
        const auto refine = [&](const basic_mesh<value, Index>& mesh, numbering& ids) {
            const level_elements<native_level<value, Index, degree>> level(mesh);
            return refine_level<connect::everything>(level, scheme_, mesh.generation(), ids);
        };
        const auto fine = refine_part<numbering>(
            basic_mesh<value, Index>(std::move(points), part.mesh.topology(), mesh_.generation()),
            numbers,
            bases_,
            rings_,
            [&](const affine_number<Index>& face) { return face.source == sources.centre(); },
            refine,
            refine);
        return assemble(walk, sources, numbers, fine, tape);
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
            affine_numbers result{{}, {}, {}, std::size_t(degree)};
            std::uint32_t id = 0;
            const auto fill = [&](auto& list, std::size_t count) {
                for (std::size_t i = 0; i < count; ++i)
                    list.push_back({0, 1, id++});
            };
            fill(result.vertices, topology_.vertices);
            fill(result.edges, topology_.edges());
            fill(result.faces, topology_.faces);
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

    /// Lists new elements by their sources and tells the place of each; empty where places are too small for them.
    static std::vector<typename result::place> list(const sources_of_part& sources,
                                                    const std::vector<affine_number<Index>>& numbers,
                                                    const std::vector<bool>& is_listed,
                                                    typename result::new_elements& to)
    {
        std::vector<std::uint32_t> listed;
        for (std::uint32_t i = 0; i < numbers.size(); ++i)
            if (is_listed[i])
                listed.push_back(i);
        if (listed.size() > std::numeric_limits<typename result::place>::max())
            return {};
        std::ranges::sort(listed, {}, [&](std::uint32_t i) {
            return std::tuple(numbers[i].source, numbers[i].factor, numbers[i].offset);
        });
        std::vector<typename result::place> place(numbers.size());
        for (const std::uint32_t i : listed) {
            const auto& n = numbers[i];
            place[i] = typename result::place(to.size());
            if (to.size() == 0 or n.source != numbers[listed[to.size() - 1]].source) {
                to.sources.push_back(sources.source(n.source));
                to.end.push_back(std::uint32_t(to.size()));
            }
            ++to.end.back();
            to.offset.push_back(n.offset);
            to.factor.push_back(n.factor);
        }
        return place;
    }

    std::optional<result> assemble(const face_walk<Index>& walk, const sources_of_part& sources,
                                   const affine_numbers& numbers, const basic_mesh<value, Index>& fine,
                                   const tape<scalar>& tape) const
    {
        const connectivity<Index>& topology = fine.topology();
        result made;
        made.steps.assign(walk.steps().begin(), walk.steps().end());

        std::vector<std::uint32_t> own_faces;
        for (std::uint32_t f = 0; f < numbers.faces.size(); ++f)
            if (numbers.faces[f].source == sources.centre())
                own_faces.push_back(f);
        std::ranges::sort(own_faces, {}, [&](std::uint32_t f) {
            return std::pair(numbers.faces[f].factor, numbers.faces[f].offset);
        });

        std::vector<bool> has_vertex(topology.vertices);
        for (std::size_t v = 0; v < has_vertex.size(); ++v)
            has_vertex[v] = sources.is_owned(numbers.vertices[v].source);
        for (const std::uint32_t f : own_faces)
            for (const Index v : fine.face(f))
                has_vertex[v] = true;
        const auto place = list(sources, numbers.vertices, has_vertex, made.vertices);
        if (place.empty())
            return {};

        std::vector<std::pair<typename result::place, std::uint32_t>> owned;
        for (std::uint32_t v = 0; v < place.size(); ++v)
            if (sources.is_owned(numbers.vertices[v].source))
                owned.emplace_back(place[v], v);
        std::ranges::sort(owned);
        std::vector<std::uint32_t> outputs;
        for (const auto& [output, v] : owned) {
            made.outputs.push_back(output);
            outputs.push_back(fine.point(v).value);
        }
        for (const std::uint32_t f : own_faces) {
            const auto& n = numbers.faces[f];
            if (made.runs.empty() or made.runs.back().factor != n.factor or
                made.runs.back().offset + made.runs.back().count != n.offset)
                made.runs.push_back({n.offset, n.factor, 0});
            ++made.runs.back().count;
            for (const Index v : fine.face(f))
                made.corners.push_back(place[v]);
        }
        made.program = lane_program<scalar>(tape, outputs);
        if (made.program.is_too_long())
            return {};
        for (const std::uint32_t v : made.program.inputs())
            made.inputs.push_back(sources.corner_of_vertex(v));
        return made;
    }

    const basic_mesh<Point, Index>& mesh_;
    const Scheme& scheme_;
    std::span<const column_bases> bases_;
    std::vector<int> rings_;
    submesh_cutter<Point, Index> cutter_;
};

} // namespace kith
