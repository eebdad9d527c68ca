// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/error.hpp>
#include <kith/numbering/association/tuples.hpp>
#include <kith/numbering/step/children.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace kith {

/// An element of a level by kind and number.
struct numbered_element {
    element_kind kind;
    std::size_t number;

    friend bool operator==(const numbered_element&, const numbered_element&) = default;
};

namespace detail {

/// Returns the element between two others, or one of them if the other lies on it. Between vertices it is the edge that
/// joins them, between edges the face on which both lie, between faces the edge that they share. Returns nothing if
/// they do not touch.
template <level Level>
std::optional<numbered_element> element_between(const Level& level, numbered_element a, numbered_element b)
{
    using enum element_kind;
    if (a == b)
        return a;
    if (b.kind < a.kind)
        std::swap(a, b);
    const auto vertex_of = [&](const numbered_element& x) { return level.vertices()[x.number]; };
    const auto edge_of = [&](const numbered_element& x) { return level.edges()[x.number]; };
    const auto face_of = [&](const numbered_element& x) { return level.faces()[x.number]; };
    const auto the = [](element_kind kind, std::size_t number, auto tuple) -> std::optional<numbered_element> {
        return tuple.value == tuple.not_incident ? std::nullopt : std::optional(numbered_element{kind, number});
    };
    if (b.kind == vertex) {
        const auto joined = index_tuple(vertex_of(a), vertex_of(b));
        return the(edge, joined.value, joined);
    }
    if (a.kind == face) {
        const auto shared = index_tuple(face_of(a), face_of(b));
        return the(edge, shared.value, shared);
    }
    if (a.kind == vertex)
        return b.kind == edge ? the(edge, b.number, index_tuple(vertex_of(a), edge_of(b)))
                              : the(face, b.number, index_tuple(vertex_of(a), face_of(b)));
    if (b.kind == face)
        return the(face, b.number, index_tuple(edge_of(a), face_of(b)));
    const auto left = edge_of(b).lface();
    if (const auto found = the(face, left.index(), index_tuple(edge_of(a), left)); found or edge_of(b).is_boundary())
        return found;
    const auto right = edge_of(b).rface();
    return the(face, right.index(), index_tuple(edge_of(a), right));
}

/// Throws mesh_error unless coarser <= finer.
inline void require_finer(int finer, int coarser)
{
    if (finer < coarser)
        throw mesh_error("level " + std::to_string(finer) + " was given as the finer, level " +
                         std::to_string(coarser) + " as the coarser one; give them the other way round");
}
/// Throws mesh_error for level 0.
inline void require_origins(int level)
{
    if (level == 0)
        throw mesh_error("level 0 is the control mesh, whose elements come from no others; ask for the origin of those "
                         "of level 1 or more");
}

} // namespace detail

/// Returns the kind and number of an element. Precondition: it is a vertex, an edge or a face.
template <element X>
numbered_element numbered(const X& x)
{
    constexpr char letter = element_letter<X>;
    constexpr auto kind = letter == 'v'   ? element_kind::vertex
                          : letter == 'e' ? element_kind::edge
                                          : element_kind::face;
    return {kind, x.index()};
}

/// Returns the parent of a tuple that is in no column. As for other tuples, it is its face, its edge if it has no face,
/// else its vertex. Two vertices that do not touch have the face in which both lie as their parent, and two faces the
/// vertex that both have. Among several, it is the one with the smallest number; if there is none, it is the first of
/// the two. Cost: O(valence * degree).
template <level Level>
numbered_element parent_of_listed(const Level& level, const tuple_elements& tuple)
{
    using enum element_kind;
    const auto find = [&](char letter) { return std::ranges::find(tuple, letter, &tuple_elements::value_type::first); };
    const auto touch = [](const auto& v, const auto& f) {
        const auto corner = index_tuple(v, f);
        return corner.value != corner.not_incident;
    };
    const bool is_pair = tuple.size() == 2 and tuple[0].first == tuple[1].first; // of vertices or of faces
    constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    std::size_t common = none;
    if (const auto f = find('f'); f != tuple.end()) {
        if (is_pair)
            for (const auto v : level.faces()[tuple[0].second].vertices())
                if (touch(v, level.faces()[tuple[1].second]))
                    common = std::min<std::size_t>(common, v.index());
        return common == none ? numbered_element{face, f->second} : numbered_element{vertex, common};
    }
    if (const auto e = find('e'); e != tuple.end())
        return {edge, e->second};
    if (is_pair)
        for (const auto f : level.vertices()[tuple[0].second].faces())
            if (touch(level.vertices()[tuple[1].second], f))
                common = std::min<std::size_t>(common, f.index());
    return common == none ? numbered_element{vertex, tuple.front().second} : numbered_element{face, common};
}

/// Returns the element of the coarse level that is the parent of an element of the next level. For an edge that was
/// found by matching, it is the element between the parents of its ends, as its split would have said. If these do not
/// touch, it is the parent of the face on its left. Cost: that of `origin`; that of parent_of_listed for vertices of
/// the dictionary; for edges that were found by matching O(valence + degree) more.
template <level Level, level_numbering Numbering, level Fine>
numbered_element parent_of(const Level& coarse, const Numbering& ids, const Fine& fine, const numbered_element& x)
{
    const auto by_column = [&](const auto& of_kind, std::size_t id) -> numbered_element {
        const auto [kind, tuple] = of_kind.origin(id);
        return {parent_kind(kind), parent(coarse, kind, tuple)};
    };
    const auto of_vertex = [&](std::size_t id) {
        const std::size_t listed = ids.vertices.total();
        return id < listed ? by_column(ids.vertices, id)
                           : parent_of_listed(coarse, ids.dictionary.tuple_of(id - listed));
    };
    if (x.kind == element_kind::vertex)
        return of_vertex(x.number);
    if (x.kind == element_kind::face)
        return by_column(ids.faces, x.number);
    if constexpr (Numbering::has_edges) {
        return by_column(ids.edges, x.number);
    } else {
        const auto e = fine.edges()[x.number];
        const auto between = detail::element_between(coarse, of_vertex(e.org().index()), of_vertex(e.dst().index()));
        return between ? *between : by_column(ids.faces, e.lface().index());
    }
}

/// Returns the ranges that hold this element only.
inline element_ranges only(const numbered_element& x)
{
    element_ranges result;
    result.*of_kind(x.kind) = {{x.number, x.number + 1}};
    return result;
}

/// Returns the children of elements of a level, with vertices of the dictionary and edges that were found by matching.
/// Cost: O(ranges); more by O(vertices of the dictionary), and by O(edges of the next level) if edges were found by
/// matching.
template <level Level, level_numbering Numbering, level Fine>
element_ranges children(const Level& coarse, const Numbering& ids, const Fine& fine, const element_ranges& parents)
{
    auto result = children(coarse, ids, parents);
    if constexpr (Numbering::has_edges)
        return result; // then there is no dictionary either
    const auto add_where_parent_is_among = [&](element_kind kind, std::size_t first, std::size_t end) {
        auto& ranges = result.*of_kind(kind);
        for (std::size_t id = first; id < end; ++id) {
            const numbered_element from = parent_of(coarse, ids, fine, {kind, id});
            const auto& all = parents.*of_kind(from.kind);
            const auto after = std::ranges::upper_bound(all, from.number, {}, &number_range::begin);
            if (after == all.begin() or from.number >= std::prev(after)->end)
                continue;
            if (not ranges.empty() and ranges.back().end == id)
                ++ranges.back().end;
            else
                ranges.push_back({id, id + 1});
        }
    };
    add_where_parent_is_among(element_kind::vertex, ids.vertices.total(), fine.vertex_count());
    add_where_parent_is_among(element_kind::edge, 0, fine.edge_count());
    return result;
}

} // namespace kith
