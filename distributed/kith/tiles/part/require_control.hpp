// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/level/to_native.hpp>
#include <kith/core/level/validate.hpp>
#include <kith/numbering/step/scheme.hpp>
#include <kith/refine.hpp>

#include <concepts>

namespace kith::detail {

/// Throws mesh_error for a control mesh that cannot be cut into tiles. Errors: mesh_error for everything that `refine`
/// refuses, and for face-vertex lists only, since tiles have the numbers of the mesh's edges.
template <scheme Scheme, class Point, std::unsigned_integral Index>
void require_control(const basic_mesh<Point, Index>& mesh, const Scheme& scheme, int levels)
{
    require_levels<Scheme>(levels);
    validate(mesh).require_ok();
    require_edges(mesh);
    require_control_level(scheme, level_of<basic_mesh<Point, Index>>(mesh), mesh.generation());
}

} // namespace kith::detail
