// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "refine_in_tiles.hpp"

#include <kith/core/base/error.hpp>
#include <kith/refine.hpp>
#include <kith/tiles/part/require_control.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

namespace kith {

namespace detail {

/// Returns the first vertex or face of a tile that differs from the whole mesh, or an empty string.
template <tile_like Tile, class Point, std::unsigned_integral Index>
std::string difference_in_tile(const Tile& part, const basic_mesh<Point, Index>& whole)
{
    for (std::size_t v = 0; v < part.vertex_ids.size(); ++v)
        if (not(part.mesh.point(v) == whole.point(part.vertex_ids[v])))
            return "vertex " + std::to_string(part.vertex_ids[v]);
    for (std::size_t f = 0; f < part.face_ids.size(); ++f)
        if (not std::ranges::equal(
                part.mesh.face(f), whole.face(part.face_ids[f]), {}, [&](auto v) { return part.vertex_ids[v]; }))
            return "face " + std::to_string(part.face_ids[f]);
    return {};
}

} // namespace detail

/// Throws mesh_error if the reach that a scheme declares in its traits is too small on this mesh. `refine` of many
/// faces, `evaluator`, tiles and ranks rely on it. Each face is refined as a tile of its own with 0, 1 and 2 rings at
/// the end; all points and faces of the tile must equal those of the refined whole mesh. The test covers more if the
/// mesh has everything that the scheme distinguishes: a boundary, extraordinary vertices, creases.
/// Errors: mesh_error that names the element that differs; those of `validate` and `refine`. Cost: that of refining
/// each face with its rings, for each level and each number of rings.
template <class Point, std::unsigned_integral Index, reaching_scheme Scheme>
void require_reach(const basic_mesh<Point, Index>& mesh, const Scheme& scheme, int levels = 2)
{
    detail::require_control(mesh, scheme, levels);
    partition parts{std::vector<std::uint32_t>(mesh.face_count()), mesh.face_count()};
    std::iota(parts.part_of.begin(), parts.part_of.end(), 0U);
    for (int level = 1; level <= levels; ++level) {
        auto whole = mesh;
        Scheme of_level = scheme;
        make_levels(whole, of_level, level);
        for (int rings = 0; rings <= 2; ++rings) {
            tiled_refinement tiles(mesh, scheme, level, parts, rings);
            for (std::size_t face = 0; face < tiles.tiles(); ++face)
                if (const auto different = detail::difference_in_tile(tiles.refine(face, connect::everything), whole);
                    not different.empty())
                    throw mesh_error(std::string(scheme_name<Scheme>()) + ": with " + std::to_string(rings) +
                                     " rings around face " + std::to_string(face) + ", " + different + " of level " +
                                     std::to_string(level) +
                                     " differs from the whole mesh; a step reads more rings than traits().reach says, "
                                     "or uses the numbers of elements");
        }
    }
}

} // namespace kith
