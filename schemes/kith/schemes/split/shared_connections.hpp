// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/numbering/step/refinement.hpp>

namespace kith {

/// Starts the fans of the vertices that old vertices give birth to, for splits that cut the edges at a vertex. The new
/// fan starts where the old one does: with the new edge of that end, in the face of that corner.
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

/// Makes a face inside each face, for splits that make a vertex of each corner. It joins the new vertices of the
/// corners by a new edge for each side.
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
