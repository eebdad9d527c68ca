// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "basic_mesh.hpp"
#include "level_sink.hpp"
#include "mesh_traits.hpp"

#include <kith/core/base/for_parts.hpp>
#include <kith/core/base/large_blocks.hpp>
#include <kith/core/base/platform.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith {

/// A mesh type that can be allocated at once and written by several threads; `mesh_traits` describes each line.
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

/// The point type of the native mesh into which a mesh is converted, and from which it can be made again.
template <class M>
struct lifted_point {
    using type = typename mesh_traits<M>::point;
};
template <fillable_mesh M>
struct lifted_point<M> : native_point<typename mesh_traits<M>::point> {};

/// A mesh of another library into which a level is written. Its elements are numbered as in a native mesh, and
/// half-edge 2e+s is side s of edge e. The writing functions are called out of line, and all other code is inlined into
/// the loops. This is as fast, and keeps the assertions of the other library out of the loops. Its points may be seen
/// as arrays.
template <fillable_mesh M, class Point>
    requires std::same_as<Point, typename mesh_traits<M>::point> or std::same_as<Point, typename lifted_point<M>::type>
class foreign_level final : public level_writer<Point, std::uint32_t> {
    using traits = mesh_traits<M>;
    using index = std::uint32_t;
    using vertex = typename traits::vertex;
    using face = typename traits::face;
    using halfedge = typename traits::halfedge;

public:
    /// Takes an empty mesh, which gets the attributes of `source` if there is one.
    explicit foreign_level(M& mesh, const M* source = nullptr) : mesh_(&mesh), source_(source) {}

    void make_room(std::size_t vertices, std::size_t edges, std::size_t faces, bool is_closed) override
    {
        vertex_count_ = vertices;
        edge_count_ = edges;
        is_closed_ = is_closed;
        shared_blocks.give_back(); // the other library takes its memory elsewhere
        if constexpr (requires { traits::request_like(*mesh_, *source_); })
            if (source_ != nullptr)
                traits::request_like(*mesh_, *source_);
        traits::make_room(*mesh_, vertices, edges, faces);
    }

    /// Returns the points of the mesh, to be assigned; as arrays only if that is their layout in memory, see
    /// array_point.
    [[nodiscard]] Point* points() const override { return reinterpret_cast<Point*>(traits::points(*mesh_)); }

    /// Sets the half-edge at which the fan of a vertex starts; it leaves the vertex. At the boundary `finish` changes
    /// it.
    void set_start(index id, index leaving) override
    {
        traits::set_start(*mesh_, at<vertex>(id), at<halfedge>(leaving));
    }

    /// Writes faces of one degree. Safe for different faces on several threads. Errors: those of `set_start`.
    void set_faces(index first, std::size_t degree, std::span<const face_line<index>> lines) override
    {
        for (; not lines.empty(); lines = lines.subspan(degree), ++first) {
            const auto here = at<face>(first);
            for (std::size_t i = 0; i < degree; ++i) {
                const face_line<index>& next = lines[i + 1 == degree ? 0 : i + 1];
                traits::set_side(*mesh_,
                                 at<halfedge>(lines[i].halfedge),
                                 here,
                                 at<vertex>(next.vertex),
                                 at<halfedge>(next.halfedge));
            }
            traits::set_start(*mesh_, here, at<halfedge>(lines[0].halfedge), degree);
        }
    }

    /// Joins the boundary sides. If there is a boundary, marks an odd generation. Precondition: all faces are written.
    void finish(int generation) override
    {
        if (is_closed_)
            return;
        close_boundary();
        // Only a boundary between two steps of sqrt(3) or 4-8 needs the parity of the generation.
        if (generation % 2 != 0)
            traits::mark_odd_generation(*mesh_);
    }

private:
    template <class Handle>
    static Handle at(std::size_t number)
    {
        return traits::template at<Handle>(number);
    }
    /// Joins the half-edges without a face, which run along the boundary in the opposite direction. Each boundary fan
    /// starts at the corner without a neighbour clockwise: at the boundary edge that leaves the vertex.
    void close_boundary()
    {
        std::vector<std::pair<halfedge, vertex>> boundary; // each with the vertex it leads to
        std::vector<halfedge> leaving(vertex_count_);
        detail::mutex adding;
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
    const M* source_;
    std::size_t vertex_count_ = 0, edge_count_ = 0;
    bool is_closed_ = false;
};

/// Writes the elements of a native mesh, in the same order and direction. Precondition: the mesh has its edges.
/// Errors: those of `make_room`. Cost: O(elements).
template <class Point, std::unsigned_integral Index>
void write_level(level_writer<Point, Index>& level, const basic_mesh<Point, Index>& mesh)
{
    const connectivity<Index>& t = mesh.topology();
    level.make_room(t.vertices, t.edges(), t.faces, t.is_closed());
    Point* const points = level.points();
    detail::for_parts(t.vertices, std::is_trivially_copyable_v<Point>, [&](std::size_t begin, std::size_t end) {
        std::copy(mesh.points().data() + begin, mesh.points().data() + end, points + begin);
        for (std::size_t v = begin; v < end; ++v)
            level.set_start(Index(v), t.corner_halfedge[t.vertex_corner[v]]);
    });
    detail::for_parts(t.faces, true, [&](std::size_t begin, std::size_t end) {
        std::vector<face_line<Index>> lines;
        for (std::size_t f = begin; f < end; ++f) {
            lines.clear();
            for (std::size_t c = t.first_corner(f); c < t.first_corner(f + 1); ++c)
                lines.push_back({t.corner_vertex[c], t.corner_halfedge[c]});
            level.set_face(Index(f), lines);
        }
    });
    level.finish(mesh.generation());
}

/// Returns a mesh of another library with the elements of a native mesh, in the same order and direction. It gets the
/// attributes of `source` if there is one.
/// Precondition: the native mesh has its edges. Errors: those of `make_room`. Cost: O(elements).
template <fillable_mesh M, class Point>
M fill(const basic_mesh<Point, std::uint32_t>& fine, const M* source = nullptr)
{
    M result; // not moved from here on: meshes of OpenMesh would be copied
    foreign_level<M, Point> level(result, source);
    write_level(level, fine);
    return result;
}

/// Returns a mesh with the elements of a native mesh that was refined from `source`, with all data of the source that
/// its type keeps.
template <refinable_mesh M, class Point>
M build_like(const M& source, basic_mesh<Point, std::uint32_t>&& fine)
{
    if constexpr (fillable_mesh<M>)
        return fill(fine, &source);
    else if constexpr (requires { mesh_traits<M>::build(std::move(fine), source); })
        return mesh_traits<M>::build(std::move(fine), source);
    else
        return mesh_traits<M>::build(std::move(fine));
}

} // namespace kith
