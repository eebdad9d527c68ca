// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/numbering/step/refinement.hpp>

namespace kith {

/// What several splits connect alike: those that cut the edges at a vertex start the fan of the vertex that it gives
/// birth to where its own fan starts, with the new edge of that end, in the face of that corner.
template <step_context R>
void start_fans_along_ends(const R& r)
{
    using namespace targets;
    const auto& [coarse, assoc, generation] = r;
    for_each_by_number(coarse.vertices(), [&](auto v) {
        const auto c = v.first_corner();
        const auto en = c.next_edge();
        assoc(v, V).starts_at(assoc(c, F).corner(0), assoc(v, en, E).along(en));
    });
}

/// Those that make a vertex of each corner make a face inside each face, between these, and a new edge of each of its
/// sides.
template <step_context R>
void make_faces_inside(const R& r)
{
    using namespace targets;
    const auto& [coarse, assoc, generation] = r;
    for_each(coarse.faces(), [&](auto f) {
        assoc(f, F) = polygon(f.corners(), [&](auto c) { return assoc(c, V) >> assoc(c.next_edge(), f, E).left(); });
    });
}

} // namespace kith
