// SPDX-License-Identifier: BSD-3-Clause
// Refines some faces only, in tiles.
#include <kith/catmull_clark.hpp>
#include <kith/refine_in_tiles.hpp>
#include <kith/selected.hpp>

void refine(const kith::basic_mesh<>& mesh, const kith::partition& parts)
{
    kith::tiled_refinement tiles(mesh, kith::selected(kith::catmull_clark{}), 1, parts);
    tiles.refine(0);
}
