// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/level/level_elements.hpp>

#include <cstddef>
#include <span>

namespace kith {

/// By which rule the value that a vertex has at a corner goes to the next level.
enum class corner_rule : unsigned char {
    of_vertex, ///< the scheme's own: no seam meets the vertex
    curve,     ///< that of a boundary; what is sharp between the seams makes it a corner for so long
    corner,    ///< it stays
    dependent  ///< it stays for as long as what is sharp on the other side of the seam, then that of a boundary
};

/// What is known of a corner beside its value.
struct corner_mark {
    corner_rule rule = corner_rule::of_vertex;
    bool seam = false; ///< on both sides of its next edge: the faces there say different things at one of the ends
};

/// Faces that follow one another around a vertex without a seam between, so that all of them have one value there.
template <walkable_level Level>
struct corner_span {
    corner<Level> first, last; ///< counter-clockwise
    std::size_t faces;

    /// Calls f(corner) for those of the vertex in these faces.
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
    /// Calls f(edge) for those that lie between two of the faces.
    template <class F>
    void for_inner_edges(const F& f) const
    {
        for_corners([&](const auto& c) {
            if (not(c == last))
                f(c.prev_edge());
        });
    }
};

/// Calls f(span) for those around a vertex, counter-clockwise from its first corner or, inside, from a seam. A vertex
/// inside with one seam has one span, all around; so has one without. Cost: O(valence).
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
