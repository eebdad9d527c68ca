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

/// Numbers the edges in the order of (smaller vertex, larger vertex) and pairs their corners.
template <std::unsigned_integral Index>
void pair_corners(connectivity<Index>& t, mesh_report& report)
{
    struct half {
        Index to;
        Index corner;
        bool operator<(const half& other) const { return std::pair(to, corner) < std::pair(other.to, other.corner); }
    };
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
                    for (auto h = run; h != run_end; ++h)
                        faces += (h == run ? "" : ", ") + report.number(t.face_of(h->corner));
                    return name() + ": " + std::to_string(size) + " faces (" + faces +
                           "); split the edge or remove faces so that at most two are left";
                });
            } else if (size == 2 and forward(run[0]) == forward(run[1])) {
                report.add(problem::turned_face, [&] {
                    return name() + ": faces " + report.number(t.face_of(run[0].corner)) + " and " +
                           report.number(t.face_of(run[1].corner)) +
                           " run through it in the same direction; turn one of them round";
                });
            }
            // Side 0 leaves the smaller vertex, or is the only side there is.
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
}

/// Gives every vertex the corner at which its fan starts: at the boundary the corner without a neighbour clockwise,
/// inside the one that looks at the smallest neighbour. The choice depends on the vertex numbers alone, so that
/// neither the order of the faces nor the rotation of their corners changes a bit of the result.
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

/// Finds the edges of a connectivity that has its faces only, and reports what is not a manifold.
/// Cost: O(corners), with a sort of the half-edges of each vertex.
template <std::unsigned_integral Index>
void match(connectivity<Index>& topology, mesh_report& report)
{
    detail::pair_corners(topology, report);
    if (not report.has(problem::nonmanifold_edge) and not report.has(problem::turned_face))
        detail::start_fans(topology, report);
}

} // namespace kith
