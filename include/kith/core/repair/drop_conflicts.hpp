// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mended_soup.hpp"
#include "sides_by_edge.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <numeric>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#ifdef KITH_HAS_BODIES

namespace kith::detail {

/// Leaves out faces until each edge has at most two sides; in opposite directions if `directed` is true. Faces in many
/// conflicts go first, then faces of small parts of the surface, then faces with large numbers.
inline void drop_conflicts(mended_soup& s, bool directed)
{
    const sides_by_edge sides(s.faces);
    std::vector<std::size_t> edge_of(s.faces.vertices.size()), forward, backward;
    std::vector<bool> is_forward(s.faces.vertices.size());
    sides.for_each_edge([&](std::span<const face_side> at) {
        forward.push_back(0), backward.push_back(0);
        for (const face_side& side : at) {
            edge_of[side.corner] = forward.size() - 1;
            is_forward[side.corner] = sides.is_forward(side);
            ++(is_forward[side.corner] ? forward : backward).back();
        }
    });
    const auto conflicts_at = [&](std::size_t corner) {
        const std::size_t e = edge_of[corner];
        if (directed)
            return (is_forward[corner] ? forward : backward)[e] - 1;
        return std::max<std::size_t>(forward[e] + backward[e], 2) - 2;
    };
    const auto conflicts_of = [&](std::size_t face) {
        std::size_t result = 0;
        for (std::size_t c = s.faces.first[face]; c < s.faces.first[face + 1]; ++c)
            result += conflicts_at(c);
        return result;
    };
    const std::vector<std::size_t> part = directions_of(s.faces.size(), sides.pairs()).part;
    std::vector<std::size_t> size(s.faces.size(), 0);
    for (const std::size_t p : part)
        ++size[p];
    // Conflicts, number of faces in other parts of the surface, face number; the largest tuple goes first.
    std::vector<std::tuple<std::size_t, std::size_t, std::size_t>> order;
    for (std::size_t f = 0; f < s.faces.size(); ++f)
        if (const std::size_t conflicts = conflicts_of(f); conflicts != 0)
            order.emplace_back(conflicts, s.faces.size() - size[part[f]], f);
    std::ranges::sort(order, std::greater<>());
    std::vector<bool> is_dropped(s.faces.size(), false);
    for (const auto& [conflicts, rest, f] : order) {
        std::size_t bad = s.faces.first[f];
        while (bad != s.faces.first[f + 1] and conflicts_at(bad) == 0)
            ++bad;
        if (bad == s.faces.first[f + 1])
            continue;
        is_dropped[f] = true;
        const std::size_t e = edge_of[bad];
        s.report.add_dropped_face(s.from_face[f], [&] {
            const auto [low, high] = std::minmax(
                {s.from_vertex[s.faces.vertices[bad]], s.from_vertex[s.faces.vertices[sides.next(bad)]]});
            const std::string edge = "edge " + s.report.number(low) + "-" + s.report.number(high);
            return forward[e] + backward[e] > 2
                       ? "as " + edge + " has " + std::to_string(forward[e] + backward[e]) + " faces"
                       : "as another face runs through " + edge + " in the same direction";
        });
        for (std::size_t c = s.faces.first[f]; c < s.faces.first[f + 1]; ++c)
            --(is_forward[c] ? forward : backward)[edge_of[c]];
    }
    s.drop_marked(is_dropped);
}

/// Keeps at each vertex the fan with most faces, or, of equally large fans, the one with the first face. The faces left
/// out may leave other vertices with several fans, so these vertices are checked again.
inline void drop_fans(mended_soup& s)
{
    const sides_by_edge sides(s.faces);
    const auto across = sides.across([](std::span<const face_side>) {});
    std::vector<std::size_t> first(s.from_vertex.size() + 2, 0), corners(across.size());
    for (const std::size_t v : s.faces.vertices)
        ++first[v + 2];
    for (std::size_t v = 2; v < first.size(); ++v)
        first[v] += first[v - 1];
    for (std::size_t c = 0; c < across.size(); ++c)
        corners[first[s.faces.vertices[c] + 1]++] = c;
    std::vector<bool> is_dropped(s.faces.size(), false), is_waiting(s.from_vertex.size(), true);
    std::vector<std::size_t> waiting(s.from_vertex.size()), next_waiting, fan_of(across.size(), s.none), stack;
    std::iota(waiting.begin(), waiting.end(), std::size_t(0));
    const auto is_there = [&](std::size_t c) { return c != s.none and not is_dropped[sides.face_of(c)]; };
    const auto look_at = [&](std::size_t v) {
        const auto around = std::span(corners).subspan(first[v], first[v + 1] - first[v]);
        for (const std::size_t c : around)
            fan_of[c] = s.none;
        std::vector<std::size_t> sizes;
        for (const std::size_t start : around) {
            if (not is_there(start) or fan_of[start] != s.none)
                continue;
            sizes.push_back(0);
            fan_of[start] = sizes.size() - 1;
            for (stack.assign(1, start); not stack.empty();) {
                const std::size_t c = stack.back(), before = across[sides.prev(c)];
                stack.pop_back();
                ++sizes.back();
                const auto go_to = [&](std::size_t neighbor) {
                    if (fan_of[neighbor] == s.none) {
                        fan_of[neighbor] = sizes.size() - 1;
                        stack.push_back(neighbor);
                    }
                };
                if (is_there(across[c]))
                    go_to(sides.next(across[c]));
                if (is_there(before))
                    go_to(before);
            }
        }
        if (sizes.size() < 2)
            return;
        const auto kept = std::size_t(std::ranges::max_element(sizes) - sizes.begin());
        for (const std::size_t c : around) {
            const std::size_t f = sides.face_of(c);
            if (not is_there(c) or fan_of[c] == kept)
                continue;
            is_dropped[f] = true;
            s.report.add_dropped_face(
                s.from_face[f], [&] { return "as it does not join the larger fan of faces at vertex " + s.number(v); });
            for (const std::size_t w : s.faces[f])
                if (not is_waiting[w]) {
                    is_waiting[w] = true;
                    next_waiting.push_back(w);
                }
        }
    };
    for (; not waiting.empty(); waiting = std::exchange(next_waiting, {})) {
        std::ranges::sort(waiting);
        for (const std::size_t v : waiting) {
            is_waiting[v] = false;
            look_at(v);
        }
    }
    s.drop_marked(is_dropped);
}

} // namespace kith::detail

#endif
