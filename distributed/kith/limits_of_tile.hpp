// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/tiles/part/tile_like.hpp>

#include <kith/limits/limit_surface.hpp>
#include <kith/tiles/number/tuple_facts.hpp>

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace kith {

/// Marks the vertices of a tile for which the tile has all faces within `rings` rings around the faces at the vertex.
/// Precondition: the tile has its edges. Cost: O(corners) per ring.
template <tile_like Tile>
std::vector<unsigned char> vertices_with_rings(const Tile& part, int rings)
{
    const auto& mesh = part.mesh;
    auto lacks_faces = incomplete_vertices(part);
    for (int ring = 0; ring < rings; ++ring) {
        auto farther = lacks_faces;
        for (std::size_t f = 0; f < mesh.face_count(); ++f)
            if (const auto face = mesh.face(f); std::ranges::any_of(face, [&](auto v) { return lacks_faces[v] != 0; }))
                for (const auto v : face)
                    farther[v] = 1;
        lacks_faces = std::move(farther);
    }
    for (unsigned char& mark : lacks_faces)
        mark = mark == 0;
    return lacks_faces;
}

namespace detail {

/// Removes the limits that masks have formed without all of their points.
template <tile_like Tile, scheme Scheme, class Limits>
Limits with_all_points(const Tile& part, const Scheme& scheme, Limits limits)
{
    const auto has_rings = vertices_with_rings(part, limit_rules<Scheme>::rings(scheme));
    for (std::size_t v = 0; v < limits.size(); ++v)
        if (has_rings[v] == 0)
            limits[v].reset();
    return limits;
}

template <tile_like Tile>
auto level_of_tile(const Tile& part)
{
    require_edges(part.mesh);
    return level_of<basic_mesh<typename Tile::point_type, typename Tile::index_type>>(part.mesh);
}

} // namespace detail

/// Returns the limit positions of the vertices of a tile by closed masks, with the bits that limit_positions gives for
/// the whole level. `scheme` is the scheme of the tile. A vertex has no limit where the whole level has none, or where
/// the mask needs faces that are not in the tile. A tile with one ring of ghosts more than limit_rules::rings has the
/// limits of all its own faces. Errors: mesh_error for a tile without edges.
template <tile_like Tile, scheme Scheme>
auto limit_positions(const Tile& part, const Scheme& scheme)
{
    return detail::with_all_points(part, scheme, limit_positions(detail::level_of_tile(part), scheme));
}
/// Returns the limit normals of the vertices of a tile, of unit length, under the conditions of limit_positions.
template <tile_like Tile, scheme Scheme>
auto limit_normals(const Tile& part, const Scheme& scheme)
{
    return detail::with_all_points(part, scheme, limit_normals(detail::level_of_tile(part), scheme));
}
/// Returns the limits of values at the vertices of a tile, under the conditions of limit_positions.
template <tile_like Tile, scheme Scheme, affine_value T>
auto limit_values(const Tile& part, const Scheme& scheme, std::span<const T> values)
{
    return detail::with_all_points(part, scheme, limit_values(detail::level_of_tile(part), scheme, values));
}

/// The limits of the vertices of the faces that a tile owns.
template <class Point>
struct tile_limits {
    limit_surface<Point> surface;        ///< other vertices are unchanged and have no normals
    std::vector<unsigned char> is_known; ///< per vertex: 1 if it belongs to an owned face, else 0
};

/// Returns the limits of the vertices of the faces that a tile owns, with the bits that limit_surface_of gives for the
/// whole level. Errors: mesh_error for a tile with fewer rings of ghosts than rings_for_limits says, and the errors of
/// limit_surface_of for a mesh.
template <tile_like Tile, searchable_scheme Scheme>
tile_limits<typename Tile::point_type> limit_surface_of(const Tile& part, const Scheme& scheme)
{
    require_edges(part.mesh);
    const int rings = rings_for_limits(scheme);
    const auto has_rings = vertices_with_rings(part, rings - 1); // the first ring is at the vertex
    std::vector<unsigned char> marks(part.mesh.vertex_count(), 0);
    for (std::size_t f = 0; f < part.mesh.face_count(); ++f)
        if (part.owns_face(f))
            for (const auto v : part.mesh.face(f)) {
                if (has_rings[v] == 0)
                    throw mesh_error(
                        std::string(scheme_name<Scheme>()) + ": vertex " + std::to_string(part.vertex_ids[v]) +
                        " of a tile lacks neighbours that its limit depends on; refine or keep tiles with " +
                        std::to_string(rings) + " rings of ghosts, as rings_for_limits says");
                marks[v] = 1;
            }
    auto surface = limit_surface_around(part.mesh, scheme, std::span<const unsigned char>(marks));
    return {std::move(surface), std::move(marks)};
}

} // namespace kith
