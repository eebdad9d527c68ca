// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "association.hpp"
#include "basic_mesh.hpp"
#include "for_parts.hpp"
#include "large_blocks.hpp"
#include "match.hpp"

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <ranges>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith {

/// A mesh that is made in bulk and can be written by several threads; `mesh_traits` says what each line means.
template <class M, class T = mesh_traits<M>>
concept fillable_mesh = mesh<M> and std::default_initializable<M> and
                        requires(M& m, const connectivity<std::uint32_t>& level, std::size_t n, typename T::vertex v,
                                 typename T::face f, typename T::halfedge h) {
                            T::make_room(m, level, n);
                            { T::points(m) } -> std::same_as<typename T::point*>;
                            { T::template at<typename T::vertex>(n) } -> std::same_as<typename T::vertex>;
                            { T::template at<typename T::face>(n) } -> std::same_as<typename T::face>;
                            { T::template at<typename T::halfedge>(n) } -> std::same_as<typename T::halfedge>;
                            T::set_side(m, h, f, v, h);
                            T::set_boundary_side(m, h, v, h);
                            T::set_start(m, f, h);
                            T::set_start(m, v, h);
                            { T::target(m, h) } -> std::same_as<typename T::vertex>;
                            T::mark_odd_generation(m);
                        };

/// A level written straight into a mesh of another library: half-edge 2e+s of the numbering is half-edge 2e+s of the
/// mesh. Of its connectivity only what the faces start at is kept, until all of them are there.
template <fillable_mesh M>
class foreign_level : public connectivity<std::uint32_t> {
    using traits = mesh_traits<M>;
    using index = std::uint32_t;
    using vertex = typename traits::vertex;
    using face = typename traits::face;
    using halfedge = typename traits::halfedge;

public:
    /// `numbers` says how many vertices and faces there are and where the corners of the faces start.
    foreign_level(M& mesh, connectivity<index> numbers, std::size_t edge_count, bool is_closed)
        : connectivity<index>(std::move(numbers)), mesh_(&mesh), edge_count_(edge_count), is_closed_(is_closed)
    {
        shared_blocks.give_back(); // the other library takes its memory elsewhere
        traits::make_room(mesh, *this, edge_count);
        if (vertex_corner.empty()) // schemes need not say where fans at the boundary start
            vertex_corner = is_closed ? storage<index>(vertices) : storage<index>(vertices, none);
    }

    /// Its points, to be assigned.
    [[nodiscard]] auto* points() const { return traits::points(*mesh_); }

    /// Makes a face of its lines. Safe for different faces on several threads.
    template <class Lines>
    void set_face(index id, const Lines& lines)
    {
        const auto here = at<face>(id);
        const index first = first_corner(id);
        index corner = first;
        face_line<index> start{}, before{};
        for (const face_line<index>& line : lines) {
            if (corner == first)
                start = line;
            else
                traits::set_side(
                    *mesh_, at<halfedge>(before.halfedge), here, at<vertex>(line.vertex), at<halfedge>(line.halfedge));
            before = line;
            if (degree == 0)
                corner_face[corner] = id;
            ++corner;
        }
        traits::set_side(
            *mesh_, at<halfedge>(before.halfedge), here, at<vertex>(start.vertex), at<halfedge>(start.halfedge));
        traits::set_start(*mesh_, here, at<halfedge>(start.halfedge));
    }

    /// When all faces are there: lets the vertices begin where their fans start and joins the sides that have no face.
    void finish(int generation)
    {
        detail::for_parts(vertices, true, [this](std::size_t begin, std::size_t end) {
            for (std::size_t v = begin; v < end; ++v) {
                const index corner = vertex_corner[v];
                if (corner == none)
                    continue;
                const index f = detail::face_of_corner(*this, corner);
                halfedge h = traits::halfedge_of(*mesh_, at<face>(f));
                for (index c = first_corner(f); c < corner; ++c)
                    h = traits::next(*mesh_, h);
                traits::set_start(*mesh_, at<vertex>(v), h);
            }
        });
        if (is_closed_)
            return;
        close_boundary();
        // Only a boundary between two steps of sqrt(3) or 4-8 needs this to be remembered.
        if (generation % 2 != 0)
            traits::mark_odd_generation(*mesh_);
    }

private:
    template <class Handle>
    static Handle at(std::size_t number)
    {
        return traits::template at<Handle>(number);
    }
    /// Half-edges without a face run along the boundary the other way. Fans start where nothing lies clockwise: behind
    /// the boundary edge that leaves the vertex.
    void close_boundary()
    {
        std::vector<std::pair<halfedge, vertex>> boundary; // with where it leads to
        std::vector<halfedge> leaving(vertices);
        for (std::size_t e = 0; e < edge_count_; ++e) {
            const auto inner = at<halfedge>(2 * e), outer = at<halfedge>(2 * e + 1);
            if (not traits::is_boundary(*mesh_, outer))
                continue;
            const vertex to = traits::target(*mesh_, traits::prev(*mesh_, inner));
            traits::set_start(*mesh_, to, inner);
            leaving[traits::index(*mesh_, traits::target(*mesh_, inner))] = outer;
            boundary.emplace_back(outer, to);
        }
        for (const auto& [h, to] : boundary)
            traits::set_boundary_side(*mesh_, h, to, leaving[traits::index(*mesh_, to)]);
    }

    M* mesh_;
    std::size_t edge_count_;
    bool is_closed_;
};

/// The mesh of another library with the elements of a native one, in the same order and direction.
/// Precondition: the native mesh has its edges. Errors: those of `make_room`. Cost: O(elements).
template <fillable_mesh M>
M fill(basic_mesh<typename mesh_traits<M>::point, std::uint32_t>&& fine)
{
    using point = typename mesh_traits<M>::point;
    const connectivity<std::uint32_t>& t = fine.topology();
    connectivity<std::uint32_t> numbers;
    numbers.vertices = t.vertices;
    numbers.faces = t.faces;
    numbers.degree = t.degree;
    numbers.vertex_corner = t.vertex_corner;
    numbers.face_corner = t.face_corner;
    numbers.corner_face = t.corner_face;
    M result; // not moved from here on: meshes of OpenMesh copy instead
    foreign_level<M> level(result, std::move(numbers), t.edges(), t.corners() == 2 * t.edges());
    detail::for_parts(t.vertices, std::is_trivially_copyable_v<point>, [&](std::size_t begin, std::size_t end) {
        std::copy(fine.points().data() + begin, fine.points().data() + end, level.points() + begin);
    });
    detail::for_parts(t.faces, true, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f)
            level.set_face(std::uint32_t(f),
                           std::views::iota(t.first_corner(f), t.first_corner(f + 1)) |
                               std::views::transform([&t](std::uint32_t c) {
                                   return face_line<std::uint32_t>{t.corner_vertex[c], t.corner_halfedge[c]};
                               }));
    });
    level.finish(fine.generation());
    return result;
}

} // namespace kith
