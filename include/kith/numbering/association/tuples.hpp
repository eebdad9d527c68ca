// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "columns.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith {

/// A tuple of elements as an index; `not_incident` if its elements do not touch.
template <tuple_kind Kind>
struct tuple_index {
    static constexpr tuple_kind kind = Kind;
    static constexpr std::size_t not_incident = std::numeric_limits<std::size_t>::max();
    std::size_t value;
};

/// Returns the index of a tuple. If `Touch` is true, its elements are known to be incident, so the last possible
/// incidence is not tested. A branch that is never taken would keep the compiler from moving loads out of a loop.
template <bool Touch = false, walkable_level L>
tuple_index<tuple_kind::v> index_tuple(const vertex<L>& v)
{
    return {v.index()};
}
template <bool Touch = false, walkable_level L>
tuple_index<tuple_kind::e> index_tuple(const edge<L>& e)
{
    return {e.index()};
}
template <bool Touch = false, walkable_level L>
tuple_index<tuple_kind::f> index_tuple(const face<L>& f)
{
    return {f.index()};
}
template <bool Touch = false, walkable_level L>
tuple_index<tuple_kind::vf> index_tuple(const corner<L>& c)
{
    return {c.index()};
}
/// Returns the index of (v,f). Cost: O(degree of f), for faces of many corners O(the smaller of degree and valence).
template <bool Touch = false, walkable_level L>
tuple_index<tuple_kind::vf> index_tuple(const vertex<L>& v, const face<L>& f)
{
    const auto first = f.first_corner();
    auto c = first;
    if (f.degree() > 64) {
        for (const auto& around : v.corners()) { // search around the vertex and in the face by turns
            if (around.f() == f)
                return {around.index()};
            if (c.v() == v)
                return {c.index()};
            if (c = c.next(); c == first)
                break;
        }
        return {tuple_index<tuple_kind::vf>::not_incident};
    }
    for (const auto& corner : f.corners())
        if (corner.v() == v)
            return {corner.index()};
    return {tuple_index<tuple_kind::vf>::not_incident};
}
template <bool Touch = false, walkable_level L>
tuple_index<tuple_kind::ve> index_tuple(const vertex<L>& v, const edge<L>& e)
{
    const corner<L> c = e.seen_from();
    if (c.v() == v)
        return {c.halfedge()};
    if (Touch or c.next().v() == v)
        return {c.halfedge() ^ 1};
    return {tuple_index<tuple_kind::ve>::not_incident};
}
template <bool Touch = false, walkable_level L>
tuple_index<tuple_kind::ef> index_tuple(const edge<L>& e, const face<L>& f)
{
    const corner<L> c = e.seen_from();
    if (c.f() == f)
        return {c.index()};
    if (Touch or (not c.is_boundary() and c.across().f() == f))
        return {c.across().index()};
    return {tuple_index<tuple_kind::ef>::not_incident};
}
/// Returns the index of (v,f,e). Side 0 of a corner is its next edge, side 1 its previous one.
template <bool Touch = false, walkable_level L>
tuple_index<tuple_kind::vfe> index_tuple(const corner<L>& c, const edge<L>& e)
{
    if (c.next_edge() == e)
        return {2 * c.index()};
    if (Touch or c.prev_edge() == e)
        return {2 * c.index() + 1};
    return {tuple_index<tuple_kind::vfe>::not_incident};
}
template <bool Touch = false, walkable_level L>
tuple_index<tuple_kind::vfe> index_tuple(const vertex<L>& v, const face<L>& f, const edge<L>& e)
{
    // The edge gives the place of the vertex in a face that has both.
    const corner<L> side = e.seen_from();
    for (const bool across : {false, true}) {
        if (across and side.is_boundary())
            break;
        const corner<L> c = across ? side.across() : side;
        if (c.f() == f and c.v() == v)
            return {2 * c.index()};
        if (c.f() == f and c.next().v() == v)
            return {2 * c.next().index() + 1};
    }
    return {tuple_index<tuple_kind::vfe>::not_incident};
}
/// Returns the edge between two neighbours as their index. Any two vertices may be given. Cost: O(valence).
template <bool Touch = false, walkable_level L>
tuple_index<tuple_kind::e> index_tuple(const vertex<L>& a, const vertex<L>& b)
{
    for (const auto& e : a.edges())
        if ((e.org() == a ? e.dst() : e.org()) == b)
            return {e.index()};
    return {tuple_index<tuple_kind::e>::not_incident};
}
/// Returns the common edge of two faces as their index, the first one in the order of `a` if they share several. Any
/// two faces may be given. Cost: O(degree).
template <bool Touch = false, walkable_level L>
tuple_index<tuple_kind::e> index_tuple(const face<L>& a, const face<L>& b)
{
    for (const auto& c : a.corners())
        if (not c.is_boundary() and c.across().f() == b)
            return {c.next_edge().index()};
    return {tuple_index<tuple_kind::e>::not_incident};
}

// The elements of a tuple may be given in any order.
template <bool Touch = false, element A, element B>
    requires(element_letter<A> == 'f' and element_letter<B> != 'f') or
            (element_letter<A> == 'e' and element_letter<B> == 'v') or
            (element_letter<A> == 'e' and element_letter<B> == 'c')
auto index_tuple(const A& a, const B& b)
{
    return index_tuple<Touch>(b, a);
}
template <bool Touch = false, element A, element B, element C>
    requires(not(element_letter<A> == 'v' and element_letter<B> == 'f' and element_letter<C> == 'e'))
auto index_tuple(const A& a, const B& b, const C& c)
{
    if constexpr (element_letter<A> != 'v') // bring the vertex to the front, then the face before the edge
        return index_tuple<Touch>(b, c, a);
    else
        return index_tuple<Touch>(a, c, b);
}

/// A tuple as the letters and numbers of its elements, sorted; for tuples that are not incident and for messages.
using tuple_elements = std::vector<std::pair<char, std::size_t>>;

template <element... X>
[[gnu::noinline]] tuple_elements list_tuple(const X&... x)
{
    tuple_elements result;
    const auto add = [&](const auto& y) {
        if constexpr (element_letter<std::remove_cvref_t<decltype(y)>> == 'c') {
            result.emplace_back('v', y.v().index());
            result.emplace_back('f', y.f().index());
        } else {
            result.emplace_back(element_letter<std::remove_cvref_t<decltype(y)>>, y.index());
        }
    };
    (add(x), ...);
    std::sort(result.begin(), result.end());
    return result;
}

/// Returns the elements of the tuple with this kind and index: the inverse of index_tuple.
template <level Level>
[[gnu::noinline]] tuple_elements list_tuple(const Level& level, tuple_kind kind, std::size_t index)
{
    switch (kind) {
    case tuple_kind::v: return {{'v', index}};
    case tuple_kind::e: return {{'e', index}};
    case tuple_kind::f: return {{'f', index}};
    case tuple_kind::vf: return list_tuple(level.corners()[index]);
    case tuple_kind::ef: {
        const auto c = level.corners()[index];
        return list_tuple(c.next_edge(), c.f());
    }
    case tuple_kind::ve: {
        const auto e = level.edges()[index / 2];
        return list_tuple(index % 2 == 0 ? e.org() : e.dst(), e);
    }
    case tuple_kind::vfe: {
        const auto c = level.corners()[index / 2];
        return list_tuple(c.v(), c.f(), index % 2 == 0 ? c.next_edge() : c.prev_edge());
    }
    }
    return {};
}

/// Returns the tuple of these elements, with this index, as a dictionary stores it: two neighbours are their edge.
template <level Level, tuple_kind Kind, element... X>
[[gnu::noinline]] tuple_elements listed_tuple(const Level& level, tuple_index<Kind> tuple, const X&... x)
{
    return tuple.value != tuple.not_incident ? list_tuple(level, Kind, tuple.value) : list_tuple(x...);
}

[[gnu::noinline]] inline std::string to_string(const tuple_elements& tuple)
{
    std::string result = "(";
    for (const auto& [letter, index] : tuple)
        result += (result.size() == 1 ? "" : ", ") + std::string(1, letter) + " " + std::to_string(index);
    return result + ")";
}

} // namespace kith
