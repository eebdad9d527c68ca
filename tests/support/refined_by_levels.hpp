// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/numbering/step/step.hpp>

#include <concepts>

/// Returns the last level, made by single steps in the order of the given mesh.
template <class Point, std::unsigned_integral Index, class Scheme>
kith::basic_mesh<Point, Index> refined_by_levels(kith::basic_mesh<Point, Index> mesh, Scheme scheme, int levels,
                                                 kith::connect last_level = kith::connect::everything)
{
    make_levels(mesh, scheme, levels - 1);
    kith::numbering_of<Scheme, Index> ids;
    return last_level == kith::connect::faces ? kith::refine_mesh<kith::connect::faces>(mesh, scheme, ids)
                                              : kith::refine_mesh<kith::connect::everything>(mesh, scheme, ids);
}
