// SPDX-License-Identifier: BSD-3-Clause
// Tiles are cut out of a mesh that is gone by then.
#include <kith/linear.hpp>
#include <kith/refine.hpp>
#include <kith/refine_in_tiles.hpp>

void refine(const kith::basic_mesh<>& mesh, const kith::partition& parts)
{
    kith::tiled_refinement tiles(kith::refine(mesh, kith::linear{}, 1), kith::linear{}, 1, parts);
}
