// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mended_soup.hpp"
#include "sides_by_edge.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <string>
#include <utility>
#include <vector>

#ifdef KITH_HAS_BODIES

namespace kith::detail {

/// Reverses the smaller number of faces of each part of the surface; if both are equal, those without the first face.
inline void turn_faces(mended_soup& s)
{
    const face_directions directions = directions_of(s.faces.size(), sides_by_edge(s.faces).pairs());
    std::vector<std::size_t> size(s.faces.size(), 0), turned(s.faces.size(), 0);
    for (std::size_t f = 0; f < s.faces.size(); ++f) {
        ++size[directions.part[f]];
        turned[directions.part[f]] += directions.is_turned[f] ? 1 : 0;
    }
    s.remake([&](std::size_t face, std::vector<std::size_t>& corners) {
        const std::size_t part = directions.part[face];
        if (directions.is_turned[face] == (2 * turned[part] > size[part]))
            return true;
        s.report.add_turned(s.from_face[face]);
        std::ranges::reverse(corners.begin() + 1, corners.end());
        return true;
    });
}

/// Reports an edge that is cut, with its sides.
inline void report_cut(mended_soup& s, const sides_by_edge& sides, std::span<const face_side> at)
{
    const auto [low, high] = std::minmax({s.from_vertex[at[0].low], s.from_vertex[at[0].high]});
    s.report.add_cut(low, high, [&] {
        const auto face = [&](std::size_t i) { return s.report.number(s.from_face[sides.face_of(at[i].corner)]); };
        if (at.size() > 2)
            return "as it has " + std::to_string(at.size()) + " faces";
        if (face(0) == face(1))
            return "as face " + face(0) + " contains it twice";
        return "as faces " + face(0) + " and " + face(1) + " run through it in the same direction" +
               (s.options.orient ? " and the surface is one-sided" : "");
    });
}

/// The fans of faces: sets of corners at a vertex that lie next to each other. The first corner of a set stands for it.
class corner_fans {
public:
    /// Joins the corners at all sides that have another side across. `across` has for each corner the one across the
    /// side after it, or `none`.
    corner_fans(const sides_by_edge& sides, const std::vector<std::size_t>& across) : fan_(across.size())
    {
        std::iota(fan_.begin(), fan_.end(), std::size_t(0));
        for (std::size_t c = 0; c < across.size(); ++c)
            if (across[c] != sides.none)
                join_sides(sides, c, across[c]);
    }
    [[nodiscard]] std::size_t of(std::size_t c)
    {
        while (fan_[c] != c)
            c = fan_[c] = fan_[fan_[c]];
        return c;
    }
    /// Joins two sides of an edge that run in opposite directions.
    void join_sides(const sides_by_edge& sides, std::size_t a, std::size_t b)
    {
        join(a, sides.next(b));
        join(b, sides.next(a));
    }

private:
    void join(std::size_t a, std::size_t b)
    {
        const auto [first, second] = std::minmax({of(a), of(b)});
        fan_[second] = first;
    }

    std::vector<std::size_t> fan_;
};

/// Joins two sides of an edge with more than two faces if both lie in one fan at an end of the edge: they belong to one
/// sheet. Joining them closes that fan, so that the other sides of the edge get another vertex there.
inline void join_sheets(const sides_by_edge& sides, std::span<const face_side> at, corner_fans& fans)
{
    std::vector<std::size_t> left;
    for (const face_side& side : at)
        left.push_back(side.corner);
    for (const std::size_t end : {at[0].low, at[0].high}) {
        std::vector<std::pair<std::size_t, std::size_t>> by_fan; // at this end
        for (const std::size_t c : left)
            by_fan.emplace_back(fans.of(sides.vertex_of(c) == end ? c : sides.next(c)), c);
        std::ranges::sort(by_fan);
        left.clear();
        for (std::size_t i = 0; i < by_fan.size(); ++i) {
            const auto [fan, a] = by_fan[i];
            const bool has_partner = i + 1 < by_fan.size() and by_fan[i + 1].first == fan;
            if (const std::size_t b = has_partner ? by_fan[i + 1].second : a;
                has_partner and (i + 2 == by_fan.size() or by_fan[i + 2].first != fan) and
                sides.vertex_of(a) != sides.vertex_of(b) and sides.face_of(a) != sides.face_of(b)) {
                fans.join_sides(sides, a, b);
                ++i;
            } else {
                left.push_back(a);
            }
        }
    }
}

/// Gives each fan of faces, between the edges that are cut, its own vertex. The first fan keeps the original vertex.
inline void split_fans(mended_soup& s)
{
    const sides_by_edge sides(s.faces);
    std::vector<std::span<const face_side>> cut;
    const auto across = sides.across([&](std::span<const face_side> at) { cut.push_back(at); });
    corner_fans fan(sides, across);
    for (const auto& at : cut) {
        report_cut(s, sides, at);
        if (at.size() > 2)
            join_sheets(sides, at, fan);
    }
    std::vector<std::size_t> vertex_of(across.size()), fans(s.from_vertex.size(), 0);
    for (std::size_t c = 0; c < across.size(); ++c) {
        const std::size_t v = s.faces.vertices[c];
        if (const std::size_t first = fan.of(c); first != c) {
            vertex_of[c] = vertex_of[first];
        } else if (fans[v]++ == 0) {
            vertex_of[c] = v;
        } else {
            vertex_of[c] = s.from_vertex.size();
            s.from_vertex.push_back(s.from_vertex[v]);
        }
    }
    for (std::size_t v = 0; v < fans.size(); ++v)
        if (fans[v] > 1)
            s.report.add_split(s.from_vertex[v], fans[v]);
    s.faces.vertices = std::move(vertex_of);
}

} // namespace kith::detail

#endif
