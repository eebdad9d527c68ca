// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/level/elements.hpp>

#include <optional>

/// The queries for elements of a level that are incident to two given elements. Thesis 4.3.1. Each query searches in
/// the order of the walk around its first argument. If several elements fit, it returns the first one.
namespace kith {

/// Returns the edge between two vertices, or nothing if there is none. Cost: O(valence of `a`).
template <walkable_level Level>
std::optional<edge<Level>> edge_between(const vertex<Level>& a, const vertex<Level>& b)
{
    for (const auto e : a.edges())
        if ((e.org() == a ? e.dst() : e.org()) == b)
            return e;
    return std::nullopt;
}

/// Returns the edge between two faces, seen from `f`, or nothing if there is none. Cost: O(degree of `f`).
template <walkable_level Level>
std::optional<edge<Level>> shared_edge(const face<Level>& f, const face<Level>& g)
{
    for (const auto c : f.corners())
        if (not c.is_boundary() and c.across().f() == g)
            return c.next_edge();
    return std::nullopt;
}

/// Returns a face that contains both vertices, or nothing if there is none. Cost: O(corners of the faces around `a`).
template <walkable_level Level>
std::optional<face<Level>> common_face(const vertex<Level>& a, const vertex<Level>& b)
{
    for (const auto f : a.faces())
        for (const auto v : f.vertices())
            if (v == b)
                return f;
    return std::nullopt;
}

/// Returns a face that contains both edges, or nothing if there is none. Cost: O(1).
template <walkable_level Level>
std::optional<face<Level>> common_face(const edge<Level>& a, const edge<Level>& b)
{
    const auto is_at_b = [&](const face<Level>& f) {
        return b.lface() == f or (not b.is_boundary() and b.rface() == f);
    };
    if (is_at_b(a.lface()))
        return a.lface();
    if (not a.is_boundary() and is_at_b(a.rface()))
        return a.rface();
    return std::nullopt;
}

/// Returns a vertex at which two edges meet, or nothing if there is none. Cost: O(1).
template <walkable_level Level>
std::optional<vertex<Level>> common_vertex(const edge<Level>& a, const edge<Level>& b)
{
    for (const auto v : {a.org(), a.dst()})
        if (v == b.org() or v == b.dst())
            return v;
    return std::nullopt;
}

} // namespace kith
