// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/level/to_native.hpp>
#include <kith/tiles/part/tile_like.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace kith {

/// The number of face corners at the vertices before a vertex, for schemes whose new faces have as many corners as a
/// vertex has faces. Inner vertices that these schemes make have four faces; boundary vertices are listed.
class corners_at_vertices {
public:
    corners_at_vertices() = default;
    /// A vertex at the boundary of the whole mesh, and its number of faces.
    struct boundary_vertex {
        global_id id, faces;
    };

    /// Takes the boundary from a tile that owns all vertices there.
    template <tile_like Tile>
    explicit corners_at_vertices(const Tile& rim) : corners_at_vertices(owned_at_boundary(rim))
    {
    }
    /// Takes all vertices at the boundary, in any order.
    explicit corners_at_vertices(std::vector<boundary_vertex> all)
    {
        std::ranges::sort(all, {}, &boundary_vertex::id);
        std::int64_t fewer = 0;
        for (const auto& [id, faces] : all) {
            vertices_.push_back(id);
            fewer_.push_back(fewer += 4 - std::int64_t(faces));
        }
    }
    /// Returns the vertices at the boundary that a tile owns.
    template <tile_like Tile>
    static std::vector<boundary_vertex> owned_at_boundary(const Tile& part)
    {
        const level_of<basic_mesh<typename Tile::point_type, typename Tile::index_type>> level(part.mesh);
        std::vector<boundary_vertex> result;
        for (const auto v : level.vertices())
            if (v.is_boundary() and part.owns_vertex(v.index()))
                result.push_back({part.vertex_ids[v.index()], v.face_count()});
        return result;
    }

    [[nodiscard]] global_id before(global_id vertex) const
    {
        const auto n = std::lower_bound(vertices_.begin(), vertices_.end(), vertex) - vertices_.begin();
        return 4 * vertex - global_id(n == 0 ? 0 : fewer_[std::size_t(n - 1)]);
    }
    /// Sets `corners_before` of all vertices of a tile.
    template <tile_like Tile>
    void number(Tile& tile) const
    {
        tile.corners_before = storage<global_id>(tile.vertex_ids.size());
        for (std::size_t v = 0; v < tile.vertex_ids.size(); ++v)
            tile.corners_before[v] = before(tile.vertex_ids[v]);
    }

private:
    std::vector<global_id> vertices_;
    std::vector<std::int64_t> fewer_; // sums of four minus the number of faces
};

} // namespace kith
