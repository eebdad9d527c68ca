// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/association/tuples.hpp>
#include <kith/base/error.hpp>
#include <kith/step/children.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace kith {

/// An element of a level by kind and number.
struct numbered_element {
    element_kind kind;
    std::size_t number;

    friend bool operator==(const numbered_element&, const numbered_element&) = default;
};

namespace detail {

/// The element between two others, one of them where the other lies on it: of vertices the edge that joins them, of edges the
/// face on which both lie, of faces the edge that they share. Nothing if they do not touch.
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

} // namespace detail

namespace detail {

/// Errors: mesh_error unless coarser <= finer.
inline void require_finer(int finer, int coarser)
{
    if (finer < coarser)
        throw mesh_error("level " + std::to_string(finer) + " was given as the finer, level " +
                         std::to_string(coarser) + " as the coarser one; give them the other way round");
}
/// Errors: mesh_error for level 0.
inline void require_origins(int level)
{
    if (level == 0)
        throw mesh_error("level 0 is the control mesh, whose elements come from no others; ask for the origin of those "
                         "of level 1 or more");
}

} // namespace detail

template <element X>
numbered_element numbered(const X& x)
{
    constexpr char letter = element_letter<X>;
    constexpr auto kind = letter == 'v'   ? element_kind::vertex
                          : letter == 'e' ? element_kind::edge
                                          : element_kind::face;
    return {kind, x.index()};
}

/// The element of the coarse level that is the parent of one of the next. Of an edge that was found by matching it is the
/// element between the parents of its ends, which is what its split would have said. Nothing for vertices of the
/// dictionary, and for edges whose ends have no parents that touch. Cost: that of `origin`; for edges that were found by
/// matching O(valence + degree) more.
template <level Level, level_numbering Numbering, level Fine>
std::optional<numbered_element> parent_of(const Level& coarse, const Numbering& ids, const Fine& fine,
                                          const numbered_element& x)
{
    const auto by_column = [&](const auto& of_kind, std::size_t id) -> std::optional<numbered_element> {
        if (id >= of_kind.total())
            return {};
        const auto [kind, tuple] = of_kind.origin(id);
        return numbered_element{parent_kind(kind), parent(coarse, kind, tuple)};
    };
    if (x.kind == element_kind::vertex)
        return by_column(ids.vertices, x.number);
    if (x.kind == element_kind::face)
        return by_column(ids.faces, x.number);
    if constexpr (Numbering::has_edges) {
        return by_column(ids.edges, x.number);
    } else {
        const auto e = fine.edges()[x.number];
        const auto a = by_column(ids.vertices, e.org().index()), b = by_column(ids.vertices, e.dst().index());
        return a and b ? detail::element_between(coarse, *a, *b) : std::nullopt;
    }
}

/// The ranges that hold this element only.
inline element_ranges only(const numbered_element& x)
{
    element_ranges result;
    result.*of_kind(x.kind) = {{x.number, x.number + 1}};
    return result;
}

/// The children of elements of a level, with edges that were found by matching. Cost: O(ranges); O(edges of the next level)
/// where edges were found by matching.
template <level Level, level_numbering Numbering, level Fine>
element_ranges children(const Level& coarse, const Numbering& ids, const Fine& fine, const element_ranges& parents)
{
    auto result = children(coarse, ids, parents);
    if constexpr (not Numbering::has_edges) {
        const auto is_among = [&](const numbered_element& x) {
            const auto& ranges = parents.*of_kind(x.kind);
            const auto after = std::ranges::upper_bound(ranges, x.number, {}, &number_range::begin);
            return after != ranges.begin() and x.number < std::prev(after)->end;
        };
        for (std::size_t id = 0; id < fine.edge_count(); ++id)
            if (const auto found = parent_of(coarse, ids, fine, {element_kind::edge, id}); found and is_among(*found)) {
                if (not result.edges.empty() and result.edges.back().end == id)
                    ++result.edges.back().end;
                else
                    result.edges.push_back({id, id + 1});
            }
    }
    return result;
}

} // namespace kith
