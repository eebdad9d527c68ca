// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mended_soup.hpp"
#include "sides_by_edge.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#ifdef KITH_HAS_BODIES

namespace kith::detail {

/// Returns true if a face contains no vertex twice; otherwise reports the face as left out.
inline bool stays_unfolded(mended_soup& s, std::size_t face, const std::vector<std::size_t>& corners)
{
    std::vector<std::size_t> sorted;
    for (const std::size_t c : corners)
        sorted.push_back(s.faces.vertices[c]);
    std::ranges::sort(sorted);
    const auto twice = std::ranges::adjacent_find(sorted);
    if (twice == sorted.end())
        return true;
    s.report.add_dropped_face(s.from_face[face],
                              [&] { return "as it contains vertex " + s.number(*twice) + " twice"; });
    return false;
}

/// Leaves out faces that contain a vertex twice. Returns true if there were any.
inline bool drop_folded_faces(mended_soup& s)
{
    const std::size_t before = s.faces.size();
    s.remake([&](std::size_t face, const auto& corners) { return stays_unfolded(s, face, corners); });
    return s.faces.size() != before;
}

/// Leaves out corners that repeat the one before, then faces with fewer than three corners. With `weld` but without
/// `drop`, only those that have lost a corner are left out.
inline void clean_faces(mended_soup& s, bool is_welded)
{
    std::vector<std::size_t> kept;
    s.remake([&](std::size_t face, std::vector<std::size_t>& corners) {
        kept.clear();
        const auto at = [&](std::size_t corner) { return s.faces.vertices[corner]; };
        for (const std::size_t c : corners)
            if (kept.empty() or at(kept.back()) != at(c))
                kept.push_back(c);
            else
                s.kept_as[s.from_corner[c]] = s.from_corner[kept.back()];
        for (; kept.size() > 1 and at(kept.back()) == at(kept.front()); kept.pop_back())
            s.kept_as[s.from_corner[kept.back()]] = s.from_corner[kept.front()];
        const bool has_lost = kept.size() != corners.size();
        if (kept.size() < 3 and (s.options.drop or (s.options.weld and has_lost))) {
            s.report.add_dropped_face(s.from_face[face], [&] {
                if (is_welded)
                    return std::string("as its vertices were joined");
                return "as it has " + std::to_string(kept.size()) + (kept.size() == 1 ? " corner" : " corners");
            });
            return false;
        }
        if (has_lost and not is_welded)
            for (const std::size_t c : corners)
                if (s.kept_as[s.from_corner[c]] != s.from_corner[c]) {
                    s.report.add_removed_corner(s.from_face[face], s.from_vertex[at(c)]);
                    break;
                }
        corners = kept;
        return not s.options.drop or s.options.split or stays_unfolded(s, face, corners);
    });
}

/// Leaves out faces with the corners of an earlier face. A face and its back both stay if they form a surface of their
/// own, without other faces at their edges.
inline void drop_repeated_faces(mended_soup& s)
{
    std::vector<std::size_t> sides_at(s.faces.vertices.size()); // by corner: the number of sides of the edge after it
    sides_by_edge(s.faces).for_each_edge([&](std::span<const face_side> at) {
        for (const face_side& side : at)
            sides_at[side.corner] = at.size();
    });
    face_list cycles; // from the smallest vertex on towards its smaller neighbour
    std::vector<bool> is_reversed(s.faces.size());
    for (std::size_t f = 0; f < s.faces.size(); ++f) {
        std::vector<std::size_t> cycle(s.faces[f].begin(), s.faces[f].end());
        std::ranges::rotate(cycle, std::ranges::min_element(cycle));
        if (cycle.size() > 2 and cycle[1] > cycle.back()) {
            std::ranges::reverse(cycle.begin() + 1, cycle.end());
            is_reversed[f] = true;
        }
        cycles.push_back(cycle);
    }
    std::vector<std::size_t> order(s.faces.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
        return std::ranges::lexicographical_compare(cycles[a], cycles[b]);
    });
    std::vector<std::size_t> repeats(s.faces.size(), s.none);
    for (auto run = order.begin(); run != order.end();) {
        const auto end = std::find_if(
            run, order.end(), [&](std::size_t f) { return not std::ranges::equal(cycles[f], cycles[*run]); });
        const auto size = std::size_t(end - run);
        bool has_back = false;
        for (auto f = run + 1; f != end; ++f) {
            const auto sides = std::span(sides_at).subspan(s.faces.first[*f], s.faces[*f].size());
            const bool is_back = is_reversed[*f] != is_reversed[*run] and not has_back and
                                 std::ranges::all_of(sides, [&](std::size_t n) { return n <= size; });
            has_back = has_back or is_back;
            if (not is_back)
                repeats[*f] = *run;
        }
        run = end;
    }
    s.remake([&](std::size_t face, const auto&) {
        if (repeats[face] == s.none)
            return true;
        s.report.add_dropped_face(s.from_face[face],
                                  [&] { return "as it repeats face " + s.report.number(s.from_face[repeats[face]]); });
        return false;
    });
}

} // namespace kith::detail

#endif
