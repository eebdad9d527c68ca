// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tile_like.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace kith {

/// The place of an element in a tile. Thesis 4.4.
enum class tile_place : unsigned char {
    inner,    ///< all faces that touch it belong to the tile
    boundary, ///< faces of the tile and of other tiles touch it
    ghost,    ///< only faces of other tiles touch it; a face that another tile owns
};

/// The places of all elements of a tile, in its numbers.
struct tile_places {
    std::vector<tile_place> vertices, edges, faces;
};

/// Returns the places of the elements of a tile. An owned face is inner if no face of another tile touches its
/// vertices. Precondition: the tile has its edges. Cost: O(elements). Local.
template <tile_like Tile>
tile_places places_of(const Tile& part)
{
    const auto& t = part.mesh.topology();
    std::vector<unsigned char> owned(part.mesh.vertex_count(), 0), foreign(owned); // true if the vertex has such faces
    for (std::size_t f = 0; f < part.mesh.face_count(); ++f)
        for (const auto v : part.mesh.face(f))
            (part.owns_face(f) ? owned : foreign)[v] = 1;
    for (std::size_t e = 0; e < part.mesh.edge_count(); ++e)
        if (part.is_cut(e))
            for (const auto v : t.ends(e))
                foreign[v] = 1; // a face that is not in the tile
    const auto place = [](bool has_owned, bool has_foreign) {
        return not has_owned ? tile_place::ghost : has_foreign ? tile_place::boundary : tile_place::inner;
    };

    tile_places result;
    for (std::size_t v = 0; v < owned.size(); ++v)
        result.vertices.push_back(place(owned[v] != 0, foreign[v] != 0));
    for (std::size_t e = 0; e < part.mesh.edge_count(); ++e) {
        const bool left = part.owns_face(t.face_of(t.halfedge_corner[2 * e]));
        const bool right = t.is_boundary(e) ? not part.is_cut(e) and left
                                            : part.owns_face(t.face_of(t.halfedge_corner[2 * e + 1]));
        result.edges.push_back(place(left or right, not left or not right));
    }
    for (std::size_t f = 0; f < part.mesh.face_count(); ++f)
        result.faces.push_back(
            place(part.owns_face(f), std::ranges::any_of(part.mesh.face(f), [&](auto v) { return foreign[v] != 0; })));
    return result;
}

} // namespace kith
