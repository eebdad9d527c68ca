// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "basic_mesh.hpp"
#include "level_sink.hpp"
#include "mesh_traits.hpp"

#include <kith/base/for_parts.hpp>
#include <kith/base/large_blocks.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <ranges>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith {

/// A mesh that is made in bulk and can be written by several threads; `mesh_traits` says what each line means.
template <class M, class T = mesh_traits<M>>
concept fillable_mesh = mesh<M> and std::default_initializable<M> and
                        requires(M& m, std::size_t n, typename T::vertex v, typename T::face f,
                                 typename T::halfedge h) {
                            T::make_room(m, n, n, n);
                            { T::points(m) } -> std::same_as<typename T::point*>;
                            { T::template at<typename T::vertex>(n) } -> std::same_as<typename T::vertex>;
                            { T::template at<typename T::face>(n) } -> std::same_as<typename T::face>;
                            { T::template at<typename T::halfedge>(n) } -> std::same_as<typename T::halfedge>;
                            T::set_side(m, h, f, v, h);
                            T::set_boundary_side(m, h, v, h);
                            T::set_start(m, f, h, n);
                            T::set_start(m, v, h);
                            { T::target(m, h) } -> std::same_as<typename T::vertex>;
                            T::mark_odd_generation(m);
                        };

/// A level_sink that is a mesh of another library: its elements are numbered as they would be in a native mesh,
/// and half-edge 2e+s is side s of edge e. What writes into it stays out of the loops, which have all else inlined: as fast, and
/// without the assertions of the other library in every loop.
template <fillable_mesh M>
class foreign_level {
    using traits = mesh_traits<M>;
    using index = std::uint32_t;
    using vertex = typename traits::vertex;
    using face = typename traits::face;
    using halfedge = typename traits::halfedge;

public:
    using point_type = typename traits::point;
    using index_type = index;

    /// Precondition: the mesh is empty; it gets the attributes of `source`, if there is one. Errors: those of `make_room`.
    foreign_level(M& mesh, std::size_t vertex_count, std::size_t edge_count, std::size_t face_count, bool is_closed,
                  const M* source = nullptr)
        : mesh_(&mesh), vertex_count_(vertex_count), edge_count_(edge_count), is_closed_(is_closed)
    {
        shared_blocks.give_back(); // the other library takes its memory elsewhere
        if constexpr (requires { traits::request_like(mesh, *source); })
            if (source != nullptr)
                traits::request_like(mesh, *source);
        traits::make_room(mesh, vertex_count, edge_count, face_count);
    }

    /// Its points, to be assigned.
    [[nodiscard]] auto* points() const { return traits::points(*mesh_); }

    /// Makes a face of its lines. Safe for different faces on several threads. Errors: those of `set_start`.
    template <face_lines Lines>
    [[gnu::noinline]] void set_face(index id, const Lines& lines)
    {
        const auto here = at<face>(id);
        face_line<index> first{}, before{};
        std::size_t count = 0;
        for (const face_line<index>& line : lines) {
            if (count++ == 0)
                first = line;
            else
                traits::set_side(
                    *mesh_, at<halfedge>(before.halfedge), here, at<vertex>(line.vertex), at<halfedge>(line.halfedge));
            before = line;
        }
        traits::set_side(
            *mesh_, at<halfedge>(before.halfedge), here, at<vertex>(first.vertex), at<halfedge>(first.halfedge));
        traits::set_start(*mesh_, here, at<halfedge>(first.halfedge), count);
    }
    /// Lets the fan of a vertex start at a half-edge that leaves it; at the boundary `finish` turns it.
    [[gnu::noinline]] void set_start(index id, index leaving)
    {
        traits::set_start(*mesh_, at<vertex>(id), at<halfedge>(leaving));
    }

    /// When all faces are there: joins the sides that have none.
    void finish(int generation)
    {
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
        std::vector<halfedge> leaving(vertex_count_);
        std::mutex adding;
        detail::for_parts(edge_count_, true, [&](std::size_t begin, std::size_t end) {
            std::vector<std::pair<halfedge, vertex>> found;
            for (std::size_t e = begin; e < end; ++e) {
                const auto inner = at<halfedge>(2 * e), outer = at<halfedge>(2 * e + 1);
                if (not traits::is_boundary(*mesh_, outer))
                    continue;
                const vertex to = traits::target(*mesh_, traits::prev(*mesh_, inner));
                traits::set_start(*mesh_, to, inner);
                leaving[traits::index(*mesh_, traits::target(*mesh_, inner))] = outer;
                found.emplace_back(outer, to);
            }
            const std::lock_guard lock(adding);
            boundary.insert(boundary.end(), found.begin(), found.end());
        });
        for (const auto& [h, to] : boundary)
            traits::set_boundary_side(*mesh_, h, to, leaving[traits::index(*mesh_, to)]);
    }

    M* mesh_;
    std::size_t vertex_count_, edge_count_;
    bool is_closed_;
};

/// The mesh of another library with the elements of a native one, in the same order and direction, and with the attributes
/// of `source` if there is one.
/// Precondition: the native mesh has its edges. Errors: those of `make_room`. Cost: O(elements).
template <fillable_mesh M>
M fill(basic_mesh<typename mesh_traits<M>::point, std::uint32_t>&& fine, const M* source = nullptr)
{
    using point = typename mesh_traits<M>::point;
    const connectivity<std::uint32_t>& t = fine.topology();
    M result; // not moved from here on: meshes of OpenMesh copy instead
    foreign_level<M> level(result, t.vertices, t.edges(), t.faces, t.corners() == 2 * t.edges(), source);
    detail::for_parts(t.vertices, std::is_trivially_copyable_v<point>, [&](std::size_t begin, std::size_t end) {
        std::copy(fine.points().data() + begin, fine.points().data() + end, level.points() + begin);
        for (std::size_t v = begin; v < end; ++v)
            level.set_start(std::uint32_t(v), t.corner_halfedge[t.vertex_corner[v]]);
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
