// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/level/level_elements.hpp>

#include <cstddef>
#include <span>

namespace kith {

/// The rule by which the value that a vertex has at a corner is carried to the next level.
enum class corner_rule : unsigned char {
    of_vertex, ///< the scheme's own rule: no seam meets the vertex
    curve,     ///< that of a boundary, but a corner for as long as an element between the seams is sharp
    corner,    ///< the value stays
    dependent  ///< the value stays while an element on the other side of the seam is sharp, then as curve
};

/// The rule of the value at a corner, and whether the corner is at a seam.
struct corner_mark {
    corner_rule rule = corner_rule::of_vertex;
    bool seam = false; ///< its next edge is a seam: the two faces have different values at one of its ends
};

/// A span: consecutive faces around a vertex without a seam between them, so that all of them have one value there.
template <walkable_level Level>
struct corner_span {
    corner<Level> first, last; ///< counter-clockwise
    std::size_t faces;

    /// Calls f(corner) for each corner of the vertex in these faces.
    template <class F>
    void for_corners(const F& f) const
    {
        auto c = first;
        for (std::size_t i = 1;; ++i) {
            f(c);
            if (i == faces)
                return;
            c = c.prev().across();
        }
    }
    /// Calls f(edge) for each edge between two of the faces.
    template <class F>
    void for_inner_edges(const F& f) const
    {
        for_corners([&](const auto& c) {
            if (not(c == last))
                f(c.prev_edge());
        });
    }
};

/// Calls f(span) for each span around a vertex, counter-clockwise from its first corner or, if it is inside, from a
/// seam. An inner vertex with at most one seam has one span, all around. Cost: O(valence).
template <walkable_level Level, class F>
void for_each_span(const vertex<Level>& v, std::span<const corner_mark> marks, const F& f)
{
    const auto at_seam = [&](const corner<Level>& c) { return marks[c.index()].seam; };
    auto begin = v.first_corner();
    if (not begin.is_boundary())
        for (const auto c : v.corners())
            if (at_seam(c)) {
                begin = c;
                break;
            }
    corner_span<Level> here{begin, begin, 0};
    for (const auto c : begin.fan_from_here()) {
        if (here.faces > 0 and at_seam(c)) {
            f(here);
            here = {c, c, 0};
        }
        here.last = c;
        ++here.faces;
    }
    f(here);
}

} // namespace kith
