// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "basic_mesh.hpp"
#include "dense_numbers.hpp"
#include "make_mesh.hpp"

#include <kith/core/base/for_parts.hpp>

#include <algorithm>
#include <atomic>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <type_traits>
#include <utility>

namespace kith::detail {

/// The connectivity that is read from a mesh of another library, and the checks that it is valid.
template <std::unsigned_integral Index>
class read_connectivity {
protected:
    /// Begins with empty arrays. `parallel` says if several threads may read the mesh.
    explicit read_connectivity(bool parallel) : parallel_(parallel) {}

    /// Calls good(i) for all i below `size`, on all threads. Returns true if all calls returned true; stops early if
    /// not.
    template <class Good>
    bool all(std::size_t size, const Good& good) const
    {
        std::atomic<bool> result = true;
        for_parts(size, parallel_, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                if (not good(i)) {
                    result.store(false, std::memory_order_relaxed);
                    return;
                }
        });
        return result;
    }
    /// Allocates the arrays for these numbers of corners and edges. Returns false if no manifold has them.
    bool make_corners(std::size_t corners, std::size_t edges);
    [[nodiscard]] bool comes_to_no_vertex_twice(std::size_t first, std::size_t end) const;
    /// Returns true if every half-edge belongs to at most one corner, and every edge has a face.
    [[nodiscard]] bool sides_are_joined(std::size_t edges) const;
    /// Sets the start of each fan: at the boundary the corner without a neighbour clockwise, inside the start that was
    /// read. Returns true if each vertex has one fan. The loop is in the order of the faces, since their neighbours lie
    /// close together.
    bool each_vertex_has_one_fan();
    static void store(Index& place, Index value) { std::atomic_ref(place).store(value, std::memory_order_relaxed); }

    connectivity<Index> t_;
    bool is_closed_ = false;

private:
    bool parallel_;
};

template <std::unsigned_integral Index>
bool read_connectivity<Index>::make_corners(std::size_t corners, std::size_t edges)
{
    if (corners > 2 * edges)
        return false;
    t_.corner_vertex = storage<Index>(corners);
    t_.corner_halfedge = storage<Index>(corners);
    is_closed_ = corners == 2 * edges;
    t_.halfedge_corner = is_closed_ ? storage<Index>(corners) : storage<Index>(2 * edges, t_.none);
    t_.vertex_corner = storage<Index>(t_.vertices, t_.none);
    return true;
}

template <std::unsigned_integral Index>
bool read_connectivity<Index>::comes_to_no_vertex_twice(std::size_t first, std::size_t end) const
{
    const auto begin = t_.corner_vertex.begin();
    if (end - first > 16)
        return std::set<Index>(begin + first, begin + end).size() == end - first;
    for (std::size_t c = first + 1; c < end; ++c)
        if (std::find(begin + first, begin + c, begin[c]) != begin + c)
            return false;
    return true;
}

template <std::unsigned_integral Index>
bool read_connectivity<Index>::sides_are_joined(std::size_t edges) const
{
    return all(t_.corners(), [this](std::size_t c) { return t_.halfedge_corner[t_.corner_halfedge[c]] == c; }) and
           (is_closed_ or all(edges, [this](std::size_t e) { return t_.halfedge_corner[2 * e] != t_.none; }));
}

template <std::unsigned_integral Index>
bool read_connectivity<Index>::each_vertex_has_one_fan()
{
    std::atomic<std::size_t> fans = 0, corners_in_fans = 0;
    for_parts(t_.corners(), true, [&](std::size_t begin, std::size_t end) {
        std::size_t count = 0, size = 0;
        for (std::size_t c = begin; c < end; ++c) {
            const bool at_boundary = not is_closed_ and t_.across(Index(c)) == t_.none;
            const Index v = t_.corner_vertex[c];
            Index& start = t_.vertex_corner[v];
            if (at_boundary)
                store(start, Index(c));
            else if (std::atomic_ref(start).load(std::memory_order_relaxed) != c)
                continue;
            std::size_t met = 1;
            Index o = t_.next_in_fan(Index(c));
            for (; o != t_.none and o != c and t_.corner_vertex[o] == v; o = t_.next_in_fan(o))
                ++met;
            if (o == (at_boundary ? t_.none : Index(c))) { // else it is met from its start, or is no fan of v
                ++count;
                size += met;
            }
        }
        fans += count;
        corners_in_fans += size;
    });
    return fans == t_.vertices and corners_in_fans == t_.corners();
}

#ifdef KITH_COMPILED_SCHEMES
extern template class read_connectivity<std::uint32_t>;
#endif

/// A reader that copies a mesh of another library into native arrays in a few passes on all threads. While reading, it
/// checks if the mesh is valid. If it is not, `validate` reports what is wrong.
template <mesh M, class Point = typename mesh_traits<M>::point>
class bulk_reader : read_connectivity<std::uint32_t> {
    using traits = mesh_traits<M>;
    using index = std::uint32_t;
    using halfedge = typename traits::halfedge;

public:
    /// Takes a mesh and numbers its elements. Errors: mesh_error for more elements than can be numbered.
    explicit bulk_reader(const M& mesh)
        : read_connectivity(std::is_trivially_copyable_v<Point>)
        , mesh_(mesh)
        , vertices_(mesh, traits::vertices(mesh), traits::vertex_bound(mesh))
        , edges_(mesh, traits::edges(mesh), traits::edge_bound(mesh))
        , faces_(mesh, traits::faces(mesh), traits::face_bound(mesh))
    {
    }

    /// Returns the native mesh with the same elements, or nothing if the mesh cannot be refined. Their numbers, the
    /// directions of edges and the starts of faces and fans are the same. Cost: O(elements).
    [[nodiscard]] std::optional<basic_mesh<Point, index>> read(int generation)
    {
        t_.vertices = vertices_.size();
        t_.faces = faces_.size();
        if (not(read_faces() and sides_are_joined(edges_.size()) and boundary_is_said() and
                each_vertex_has_one_fan() and read_points()))
            return std::nullopt;
        return basic_mesh<Point, index>(std::move(points_), std::move(t_), generation);
    }

private:
    bool read_faces()
    {
        if (t_.faces == 0)
            return false;
        const std::size_t degree = degree_of(0);
        if (degree == 3 or degree == 4) {
            t_.degree = int(degree);
            if (read_corners(t_.faces * degree))
                return true;
        }
        t_.degree = 0; // another face has another degree, or something is wrong
        t_.face_corner = storage<index>(t_.faces + 1);
        all(t_.faces, [this](std::size_t f) { return t_.face_corner[f + 1] = index(degree_of(f)), true; });
        const std::size_t corners = t_.sum_degrees(2 * edges_.size() + 1);
        t_.corner_face = storage<index>(corners);
        return read_corners(corners);
    }
    /// Returns the degree of a face. For a face whose sides do not come back to the first, it is the number of
    /// half-edges plus one.
    [[nodiscard]] std::size_t degree_of(std::size_t f) const
    {
        std::size_t result = 0;
        const bool is_closed = for_each_side(mesh_, faces_[f], [&](halfedge) { ++result; });
        return is_closed ? result : 2 * edges_.size() + 1;
    }
    bool read_corners(std::size_t corners)
    {
        if (not make_corners(corners, edges_.size()))
            return false;
        return all(t_.faces, [this](std::size_t f) {
            const std::size_t first = t_.first_corner(f), end = t_.first_corner(f + 1);
            const auto start = traits::halfedge_of(mesh_, faces_[f]);
            if (not has_halfedge(mesh_, start)) // a face that was added without half-edges
                return false;
            auto h = start;
            for (std::size_t c = first; c < end; ++c) {
                if ((c != first and h == start) or not is_side_of(mesh_, h, faces_[f]))
                    return false;
                const auto along = traits::edge_of(mesh_, h);
                const std::size_t e = edges_.number(mesh_, along);
                if (e >= edges_.size()) // the edge was removed or does not exist
                    return false;
                const std::size_t number = 2 * e + side_of(h, along);
                const auto from = traits::source(mesh_, h);
                const std::size_t v = vertices_.number(mesh_, from);
                if (v >= t_.vertices)
                    return false;
                t_.corner_vertex[c] = index(v);
                t_.corner_halfedge[c] = index(number);
                store(t_.halfedge_corner[number], index(c)); // in an invalid mesh several faces may share it
                if (traits::halfedge_of(mesh_, from) == h)
                    store(t_.vertex_corner[v], index(c));
                if (t_.degree == 0)
                    t_.corner_face[c] = index(f);
                h = traits::next(mesh_, h);
            }
            return h == start and end - first >= 3 and comes_to_no_vertex_twice(first, end);
        });
    }
    /// Returns the side of an edge on which a half-edge lies. Side 0 is that of the half-edge that directs the edge, or
    /// of the only one with a face.
    [[nodiscard]] std::size_t side_of(halfedge h, typename traits::edge e) const
    {
        const auto directs = traits::halfedge_of(mesh_, e);
        const bool is_first = (directs == h) != traits::is_boundary(mesh_, directs);
        return is_first ? 0 : 1;
    }
    /// Checks what no corner shows. A side of an edge that lies in no face must be a boundary side. A vertex whose
    /// half-edge lies in no face must still start at a half-edge that leaves it.
    [[nodiscard]] bool boundary_is_said() const
    {
        if (is_closed_)
            return true;
        const auto side_is_said = [this](std::size_t e) {
            const auto h = traits::halfedge_of(mesh_, edges_[e]);
            return t_.halfedge_corner[2 * e + 1] != t_.none or traits::is_boundary(mesh_, h) or
                   traits::is_boundary(mesh_, traits::opposite(mesh_, h));
        };
        return all(edges_.size(), side_is_said) and all(t_.vertices, [this](std::size_t v) {
                   return t_.vertex_corner[v] != t_.none or
                          (not traits::is_isolated(mesh_, vertices_[v]) and starts_at_its_own(mesh_, vertices_[v]));
               });
    }
    bool read_points()
    {
        points_ = storage<Point>(t_.vertices);
        return all(t_.vertices, [this](std::size_t i) {
            const auto v = vertices_[i];
            if constexpr (std::same_as<Point, typename traits::point>)
                points_[i] = traits::point_of(mesh_, v);
            else
                points_[i] = affine<typename traits::point>::load(traits::point_of(mesh_, v));
            return t_.vertex_corner[i] != t_.none and point_is_finite(points_[i]);
        });
    }

    const M& mesh_;
    dense_numbers<M, typename traits::vertex> vertices_;
    dense_numbers<M, typename traits::edge> edges_;
    dense_numbers<M, typename traits::face> faces_;
    storage<Point> points_;
};

} // namespace kith::detail
