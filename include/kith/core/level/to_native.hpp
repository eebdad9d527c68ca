// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "level_elements.hpp"
#include "mesh_level.hpp"
#include "native_level.hpp"
#include "validate.hpp"

#include <kith/core/base/error.hpp>
#include <kith/core/mesh/basic_mesh.hpp>
#include <kith/core/mesh/bulk_reader.hpp>
#include <kith/core/mesh/foreign_level.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace kith {

/// The type of the level on which schemes walk: any mesh is read through its traits, a native mesh directly.
template <mesh M>
struct level_view {
    using type = level_elements<mesh_level<M>>;
};
template <class Point, std::unsigned_integral Index>
struct level_view<basic_mesh<Point, Index>> {
    using type = level_elements<native_level<Point, Index, 0>>;
};
template <mesh M>
using level_of = typename level_view<M>::type;

/// Throws mesh_error for a native mesh that consists of face-vertex lists only and has no edges.
template <mesh M>
void require_edges(const M& mesh)
{
    if constexpr (requires { mesh.topology(); })
        if (mesh.topology().faces_only())
            throw mesh_error("the mesh has face-vertex lists only and no edges; refine it with connect::everything");
}

/// Returns the number of steps since the control mesh, or 0 if the mesh type does not store it.
template <mesh M>
int generation_of(const M& mesh)
{
    if constexpr (requires { mesh_traits<M>::generation(mesh); })
        return mesh_traits<M>::generation(mesh);
    else
        return 0;
}

/// Returns a native mesh with the elements of a level. Their numbers, the directions of edges and the starts of faces
/// and fans are the same, so that refining either mesh gives the same bits. Removed elements are left out.
/// Errors: those of mesh_level. Cost: O(elements).
template <mesh M>
auto to_native(const level_elements<mesh_level<M>>& level, int generation = 0)
{
    using point = typename mesh_level<M>::point_type;
    using index = std::uint32_t;
    connectivity<index> t;
    t.vertices = level.vertex_count();
    std::size_t degree = level.face_count() == 0 ? 0 : level.faces()[0].degree();
    for (const auto f : level.faces())
        if (f.degree() != degree)
            degree = 0;
    t.allocate_faces(level.face_count(), degree == 3 or degree == 4 ? int(degree) : 0, [&](std::size_t f) {
        return level.faces()[f].degree();
    });
    t.allocate_edges(level.edge_count());
    t.vertex_corner = storage<index>(level.vertex_count());
    for (const auto c : level.corners()) {
        t.corner_vertex[c.index()] = index(c.v().index());
        t.set_side(index(c.index()), index(c.halfedge()));
    }
    storage<point> points(level.vertex_count());
    for (const auto v : level.vertices()) {
        t.vertex_corner[v.index()] = index(v.first_corner().index());
        points[v.index()] = v.point();
    }
    return basic_mesh<point, index>(std::move(points), std::move(t), generation);
}

/// Returns a native mesh with the elements of a mesh, as `to_native` of a level does. The mesh is read in bulk if
/// possible, which is faster.
template <mesh M>
auto to_native(const M& mesh)
{
    if (auto native = detail::bulk_reader<M>(mesh).read(generation_of(mesh)))
        return *std::move(native);
    return to_native(level_elements<mesh_level<M>>(mesh), generation_of(mesh));
}

namespace detail {

template <mesh M, class Point>
basic_mesh<Point, std::uint32_t> to_native_here(const M& mesh)
{
    if (auto native = bulk_reader<M, Point>(mesh).read(generation_of(mesh)))
        return *std::move(native);
    refuse_mesh(mesh);
}

/// Returns to_native_here(mesh); it is compiled in the library that `is_compiled_mesh` stands for.
template <mesh M, class Point>
basic_mesh<Point, std::uint32_t> to_native_in_library(const M& mesh);

} // namespace detail

/// Returns to_native(mesh) for a mesh that can be refined, with points that may become arrays. Errors: mesh_error with
/// everything that `validate` finds. Cost: that of `to_native`.
template <mesh M, class Point = typename lifted_point<M>::type>
basic_mesh<Point, std::uint32_t> to_native_valid(const M& mesh)
{
    constexpr bool is_usual = std::same_as<Point, typename lifted_point<M>::type>;
    if constexpr (is_compiled_mesh<M> and is_usual)
        return detail::to_native_in_library<M, Point>(mesh);
    else if constexpr (mesh_with_compiled_view<M> and is_usual)
        return to_native_valid(static_cast<const typename compiled_view<M>::type&>(compiled_view<M>::of(mesh)));
    else
        return detail::to_native_here<M, Point>(mesh);
}

/// Returns a reference to the mesh itself if it is native, else a native copy of its level.
template <mesh M>
decltype(auto) native_of(const M& mesh, const level_of<M>& level, int generation)
{
    if constexpr (requires { mesh.topology(); })
        return (mesh);
    else
        return to_native(level, generation);
}

} // namespace kith
