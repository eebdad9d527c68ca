// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "basic_mesh.hpp"
#include "mesh_report.hpp"

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace kith {

namespace detail {

/// Two faces at an edge, and a flag that is true if both run through it in the same direction.
struct face_pair {
    std::size_t face, other;
    bool same_direction;
};

/// The faces that would have to be reversed so that neighbours agree. The first face of each part of the surface is
/// never among them. If a part is one-sided, such as a Moebius strip, some neighbours still disagree.
struct face_directions {
    std::vector<bool> is_turned;
    std::vector<std::size_t> part;  ///< of each face, by the first face in the part
    std::vector<bool> is_one_sided; ///< by part
};

/// Returns the faces that would have to be reversed. From the first face of each part, it visits all neighbours that
/// agree, and only then those that do not. So faces that already agree keep doing so. Cost: O(faces + pairs).
face_directions directions_of(std::size_t faces, const std::vector<face_pair>& pairs);
#ifdef KITH_HAS_BODIES
KITH_IN_LIBRARY face_directions directions_of(std::size_t faces, const std::vector<face_pair>& pairs)
{
    std::vector<std::size_t> first(faces + 2, 0), pair_at(2 * pairs.size()); // the pairs of each face: a counting sort
    for (const face_pair& pair : pairs)
        ++first[pair.face + 2], ++first[pair.other + 2];
    for (std::size_t f = 2; f < first.size(); ++f)
        first[f] += first[f - 1];
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        pair_at[first[pairs[i].face + 1]++] = i;
        pair_at[first[pairs[i].other + 1]++] = i;
    }
    face_directions result{std::vector<bool>(faces), std::vector<std::size_t>(faces, faces), std::vector<bool>(faces)};
    std::vector<std::size_t> agreeing;                     // visited, with neighbours to visit
    std::vector<std::pair<std::size_t, bool>> disagreeing; // and if they are reversed, in the order they were met
    for (std::size_t start = 0; start < faces; ++start) {
        if (result.part[start] != faces)
            continue;
        disagreeing.assign(1, {start, false});
        for (std::size_t next = 0; next < disagreeing.size(); ++next) {
            const auto [seed, is_turned] = disagreeing[next];
            if (result.part[seed] != faces)
                continue;
            result.part[seed] = start;
            result.is_turned[seed] = is_turned;
            for (agreeing.assign(1, seed); not agreeing.empty();) {
                const std::size_t f = agreeing.back();
                agreeing.pop_back();
                for (std::size_t i = first[f]; i < first[f + 1]; ++i) {
                    const auto& [face, other, same_direction] = pairs[pair_at[i]];
                    const std::size_t neighbor = face == f ? other : face;
                    if (result.part[neighbor] != faces)
                        continue;
                    if (same_direction) {
                        disagreeing.emplace_back(neighbor, not is_turned);
                        continue;
                    }
                    result.part[neighbor] = start;
                    result.is_turned[neighbor] = is_turned;
                    agreeing.push_back(neighbor);
                }
            }
        }
    }
    for (const auto& [face, other, same_direction] : pairs)
        if ((result.is_turned[face] != result.is_turned[other]) != same_direction)
            result.is_one_sided[result.part[face]] = true;
    return result;
}
#endif

/// A corner, by the larger vertex of its edge: its half-edge leads to that vertex or comes from there.
template <std::unsigned_integral Index>
struct half_of_edge {
    Index to;
    Index corner;
    bool operator<(const half_of_edge& other) const
    {
        return std::pair(to, corner) < std::pair(other.to, other.corner);
    }
};

/// Reports pairs of faces that run through their edge in the same direction. `halves` holds the corners of each smaller
/// vertex from first[vertex] on, sorted.
template <std::unsigned_integral Index>
[[gnu::cold, gnu::noinline]] void report_turned_faces(const connectivity<Index>& t,
                                                      const std::vector<half_of_edge<Index>>& halves,
                                                      const std::vector<std::size_t>& first, mesh_report& report)
{
    std::vector<face_pair> pairs;
    std::vector<std::pair<std::size_t, std::size_t>> ends;
    for (std::size_t low = 0; low < t.vertices; ++low)
        for (std::size_t i = first[low]; i < first[low + 1];) {
            std::size_t end = i;
            while (end < first[low + 1] and halves[end].to == halves[i].to)
                ++end;
            if (end - i == 2) {
                const Index a = halves[i].corner, b = halves[i + 1].corner;
                pairs.push_back({t.face_of(a), t.face_of(b), t.corner_vertex[a] == t.corner_vertex[b]});
                ends.emplace_back(low, halves[i].to);
            }
            i = end;
        }
    const face_directions directions = directions_of(t.faces, pairs);
    for (std::size_t i = 0; i < pairs.size(); ++i)
        if (const auto& [face, other, same_direction] = pairs[i]; same_direction)
            report.add_turned_face(
                ends[i].first, ends[i].second, face, other, directions.is_one_sided[directions.part[face]]);
}

/// Numbers the edges in the order of (smaller vertex, larger vertex) and pairs their corners.
template <std::unsigned_integral Index>
void pair_corners(connectivity<Index>& t, mesh_report& report)
{
    using half = half_of_edge<Index>;
    const std::size_t corners = t.corners();
    std::vector<std::size_t> first(t.vertices + 2, 0); // the half-edges of each smaller vertex: a counting sort
    const auto ends = [&](Index c) { return std::minmax({t.corner_vertex[c], t.target(c)}); };
    for (std::size_t c = 0; c < corners; ++c)
        ++first[ends(Index(c)).first + 2];
    for (std::size_t v = 2; v < first.size(); ++v)
        first[v] += first[v - 1];
    std::vector<half> halves(corners);
    for (std::size_t c = 0; c < corners; ++c) {
        const auto [low, high] = ends(Index(c));
        halves[first[low + 1]++] = {high, Index(c)};
    }

    t.corner_halfedge = storage<Index>(corners);
    bool has_turned_faces = false;
    std::vector<Index> sides;
    sides.reserve(corners + corners / 16);
    for (std::size_t low = 0; low < t.vertices; ++low) {
        const auto begin = halves.begin() + std::ptrdiff_t(first[low]);
        const auto end = halves.begin() + std::ptrdiff_t(first[low + 1]);
        std::sort(begin, end);
        for (auto run = begin; run != end;) {
            const auto run_end = std::find_if(run, end, [&](const half& h) { return h.to != run->to; });
            const auto size = run_end - run;
            const auto forward = [&](const half& h) { return t.corner_vertex[h.corner] == low; };
            const auto name = [&] { return "edge " + report.number(low) + "-" + report.number(run->to); };
            if (size > 2) {
                report.add(problem::nonmanifold_edge, [&] {
                    std::string faces;
                    constexpr std::ptrdiff_t most = 8;
                    for (auto h = run; h != run + std::min(size, most); ++h)
                        faces += (h == run ? "" : ", ") + report.number(t.face_of(h->corner));
                    faces += size > most ? ", ..." : "";
                    return name() + ": " + std::to_string(size) + " faces (" + faces +
                           "); split the edge or remove faces so that at most two are left";
                });
            }
            has_turned_faces = has_turned_faces or (size == 2 and forward(run[0]) == forward(run[1]));
            // Side 0 leaves the smaller vertex, or is the only side.
            const bool swap = size == 2 and not forward(run[0]);
            const Index e = Index(sides.size());
            sides.push_back(run[swap ? 1 : 0].corner);
            sides.push_back(size == 1 ? connectivity<Index>::none : run[swap ? 0 : 1].corner);
            for (auto h = run; h != run_end; ++h)
                t.corner_halfedge[h->corner] = h->corner == sides[e] ? e : Index(e + 1);
            run = run_end;
        }
    }
    t.halfedge_corner = storage<Index>(sides);
    if (has_turned_faces)
        report_turned_faces(t, halves, first, report);
}

/// Sets for every vertex the corner at which its fan starts. At the boundary it is the corner without a neighbour
/// clockwise, inside the corner whose half-edge leads to the smallest neighbour. The choice depends on the vertex
/// numbers alone. So neither the order of the faces nor the rotation of their corners changes a bit of the result.
template <std::unsigned_integral Index>
void start_fans(connectivity<Index>& t, mesh_report& report)
{
    constexpr Index none = connectivity<Index>::none;
    std::vector<Index> size(t.vertices, 0);
    t.vertex_corner = storage<Index>(t.vertices, none);
    for (std::size_t i = 0; i < t.corners(); ++i) {
        const Index c = Index(i);
        const Index v = t.corner_vertex[c];
        Index& start = t.vertex_corner[v];
        ++size[v];
        if (start == none or t.across(c) == none or (t.across(start) != none and t.target(c) < t.target(start)))
            start = c;
    }
    for (std::size_t v = 0; v < t.vertices; ++v) {
        const Index start = t.vertex_corner[v];
        if (start == none) {
            report.add_isolated(v);
            continue;
        }
        Index fan = 0;
        Index c = start;
        do {
            ++fan;
            c = t.next_in_fan(c);
        } while (c != none and c != start and fan <= size[v]);
        if (fan != size[v])
            report.add_several_fans(v, size[v]);
    }
}

#ifdef KITH_COMPILED_SCHEMES
extern template void pair_corners(connectivity<std::uint32_t>&, mesh_report&);
extern template void pair_corners(connectivity<std::size_t>&, mesh_report&);
extern template void start_fans(connectivity<std::uint32_t>&, mesh_report&);
extern template void start_fans(connectivity<std::size_t>&, mesh_report&);
#endif

} // namespace detail

/// Finds the edges of a connectivity that has its faces only, and reports all places where it is not a manifold.
/// Cost: O(corners), and a sort of the half-edges of each vertex.
template <std::unsigned_integral Index>
void match(connectivity<Index>& topology, mesh_report& report)
{
    detail::pair_corners(topology, report);
    if (not report.has(problem::nonmanifold_edge) and not report.has(problem::turned_face))
        detail::start_fans(topology, report);
}

} // namespace kith
