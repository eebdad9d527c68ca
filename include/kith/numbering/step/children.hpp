// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "next_counts.hpp"

#include <kith/numbering/association/column_ids.hpp>
#include <kith/numbering/association/numbering.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace kith {

/// The kinds of elements. Every tuple has one element as its parent: (v) the vertex; (e) and (v,e) the edge; (f),
/// (v,f), (e,f) and (v,f,e) the face. So every new element has one parent, and the children of an element are those
/// that its tuples make.
enum class element_kind : unsigned char { vertex, edge, face };

/// Returns the kind of the parent of all tuples of a kind.
constexpr element_kind parent_kind(tuple_kind kind)
{
    switch (kind) {
    case tuple_kind::v: return element_kind::vertex;
    case tuple_kind::e:
    case tuple_kind::ve: return element_kind::edge;
    default: return element_kind::face;
    }
}

/// Returns the number of the parent of a tuple; face_of(corner) returns the face of a corner. Cost: O(1).
template <std::invocable<std::size_t> FaceOf>
std::size_t parent_by(tuple_kind kind, std::size_t tuple, const FaceOf& face_of)
{
    switch (kind) {
    case tuple_kind::ve: return tuple / 2;
    case tuple_kind::vfe: return face_of(tuple / 2);
    case tuple_kind::vf:
    case tuple_kind::ef: return face_of(tuple);
    default: return tuple;
    }
}
/// Returns the number of the parent of a tuple of a level.
template <level Level>
std::size_t parent(const Level& level, tuple_kind kind, std::size_t tuple)
{
    return parent_by(
        kind, tuple, [&](std::size_t corner) -> std::size_t { return level.corners()[corner].f().index(); });
}

/// Returns the face from which a new element comes: the parent of its tuple. If that is an edge or a vertex, it is the
/// face with the smallest number there. Cost: O(faces at the parent).
template <level Level>
std::size_t parent_face(const Level& level, tuple_kind kind, std::size_t tuple)
{
    const std::size_t x = parent(level, kind, tuple);
    switch (parent_kind(kind)) {
    case element_kind::vertex: {
        std::size_t result = level.face_count();
        for (const auto f : level.vertices()[x].faces())
            result = std::min(result, std::size_t(f.index()));
        return result;
    }
    case element_kind::edge: {
        const auto e = level.edges()[x];
        return e.is_boundary() ? e.lface().index() : std::min(e.lface().index(), e.rface().index());
    }
    default: return x;
    }
}

/// Ranges of consecutive numbers for elements of each kind, increasing and with gaps between them.
struct element_ranges {
    std::vector<number_range> vertices, edges, faces;

    friend bool operator==(const element_ranges&, const element_ranges&) = default;
};

/// Returns the member with the ranges of one kind: ranges.*of_kind(kind).
constexpr std::vector<number_range> element_ranges::* of_kind(element_kind kind)
{
    switch (kind) {
    case element_kind::vertex: return &element_ranges::vertices;
    case element_kind::edge: return &element_ranges::edges;
    default: return &element_ranges::faces;
    }
}

/// The ids of new elements that can be found for a range of consecutive tuples of a column.
template <class I>
concept numbers_of_tuples = requires(const I& ids, std::size_t column, const number_range& tuples) {
    { I::size } -> std::convertible_to<std::size_t>;
    { I::kinds[column] } -> std::convertible_to<tuple_kind>;
    { ids.ids(column, tuples) } -> std::same_as<number_range>;
};

namespace detail {

/// Returns the tuples of a kind that have these parents. They are consecutive, as ends of edges and corners of faces
/// are. `first_corner(face)` returns the first corner of a face; for the number of faces it returns the number of
/// corners.
template <std::invocable<std::size_t> FirstCorner>
number_range tuples_of(tuple_kind kind, const number_range& parents, const FirstCorner& first_corner)
{
    switch (kind) {
    case tuple_kind::v:
    case tuple_kind::e:
    case tuple_kind::f: return parents;
    case tuple_kind::ve: return {2 * parents.begin, 2 * parents.end};
    case tuple_kind::vfe: return {2 * first_corner(parents.begin), 2 * first_corner(parents.end)};
    default: return {first_corner(parents.begin), first_corner(parents.end)};
    }
}

template <numbers_of_tuples Ids, std::invocable<std::size_t> FirstCorner>
std::vector<number_range> children_among(const Ids& ids, const element_ranges& parents, const FirstCorner& first_corner)
{
    std::vector<number_range> result;
    for (std::size_t i = 0; i < ids.size; ++i) {
        const tuple_kind kind = ids.kinds[i];
        for (const number_range& range : parents.*of_kind(parent_kind(kind)))
            if (const auto born = ids.ids(i, tuples_of(kind, range, first_corner)); born.begin != born.end) {
                if (not result.empty() and result.back().end == born.begin)
                    result.back().end = born.end;
                else
                    result.push_back(born);
            }
    }
    return result;
}

/// Returns the children of elements of a level, computed from the numbering of the step alone.
template <class Ids, std::invocable<std::size_t> FirstCorner>
    requires requires(const Ids& ids) {
        requires numbers_of_tuples<std::remove_cvref_t<decltype(ids.vertices)>>;
        requires numbers_of_tuples<std::remove_cvref_t<decltype(ids.edges)>>;
        requires numbers_of_tuples<std::remove_cvref_t<decltype(ids.faces)>>;
    }
element_ranges children_by(const Ids& ids, const element_ranges& parents, const FirstCorner& first_corner)
{
    return {children_among(ids.vertices, parents, first_corner),
            children_among(ids.edges, parents, first_corner),
            children_among(ids.faces, parents, first_corner)};
}

} // namespace detail

/// Returns the children of elements of a level, as ranges of numbers of the next level. The children of all elements
/// are all elements that have a column, and two elements have no children in common. So the descendants over several
/// levels are children of children.
/// Preconditions: `ids` is the numbering of the step from `level`; ranges increase and do not overlap.
/// Cost: O(ranges).
template <level Level, level_numbering Numbering>
element_ranges children(const Level& level, const Numbering& ids, const element_ranges& parents)
{
    return detail::children_by(ids, parents, [&](std::size_t face) -> std::size_t {
        return face == level.face_count() ? level.corner_count() : level.faces()[face].first_corner().index();
    });
}

} // namespace kith
