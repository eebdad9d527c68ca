// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "next_counts.hpp"

#include <kith/association/numbering.hpp>
#include <kith/association/column_ids.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace kith {

/// The kinds of elements. Every tuple is listed with one element, its parent: (v) with the vertex, (e) and (v,e) with the
/// edge, (f), (v,f), (e,f) and (v,f,e) with the face. So every new element has one parent, and the children of an element
/// are those of its tuples.
enum class element_kind : unsigned char { vertex, edge, face };

constexpr element_kind parent_kind(tuple_kind kind)
{
    switch (kind) {
    case tuple_kind::v: return element_kind::vertex;
    case tuple_kind::e:
    case tuple_kind::ve: return element_kind::edge;
    default: return element_kind::face;
    }
}

/// The number of the parent of a tuple. Cost: O(1).
template <level Level>
std::size_t parent(const Level& level, tuple_kind kind, std::size_t tuple)
{
    switch (kind) {
    case tuple_kind::ve: return tuple / 2;
    case tuple_kind::vfe: return level.corners()[tuple / 2].f().index();
    case tuple_kind::vf:
    case tuple_kind::ef: return level.corners()[tuple].f().index();
    default: return tuple;
    }
}

/// The face that what a tuple gives birth to comes from: its parent or, where that is an edge or a vertex, the face with
/// the smallest number there. Cost: O(faces at it).
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

/// Elements of each kind whose numbers follow one another here and there: increasing ranges with gaps between.
struct element_ranges {
    std::vector<number_range> vertices, edges, faces;

    friend bool operator==(const element_ranges&, const element_ranges&) = default;
};

/// The ranges of one kind: ranges.*of_kind(kind).
constexpr std::vector<number_range> element_ranges::* of_kind(element_kind kind)
{
    switch (kind) {
    case element_kind::vertex: return &element_ranges::vertices;
    case element_kind::edge: return &element_ranges::edges;
    default: return &element_ranges::faces;
    }
}

namespace detail {

/// The tuples of a kind that have these parents follow one another, as ends of edges and corners of faces do.
template <level Level>
number_range tuples_of(const Level& level, tuple_kind kind, const number_range& parents)
{
    const auto corner = [&](std::size_t face) {
        return face == level.face_count() ? level.corner_count() : level.faces()[face].first_corner().index();
    };
    switch (kind) {
    case tuple_kind::v:
    case tuple_kind::e:
    case tuple_kind::f: return parents;
    case tuple_kind::ve: return {2 * parents.begin, 2 * parents.end};
    case tuple_kind::vfe: return {2 * corner(parents.begin), 2 * corner(parents.end)};
    default: return {corner(parents.begin), corner(parents.end)};
    }
}

template <level Level, element_ids Ids>
std::vector<number_range> children_among(const Level& level, const Ids& ids, const element_ranges& parents)
{
    std::vector<number_range> result;
    for (std::size_t i = 0; i < ids.size; ++i) {
        const tuple_kind kind = ids.kinds[i];
        for (const number_range& range : parents.*of_kind(parent_kind(kind)))
            if (const auto born = ids.ids(i, tuples_of(level, kind, range)); born.begin != born.end) {
                if (not result.empty() and result.back().end == born.begin)
                    result.back().end = born.end;
                else
                    result.push_back(born);
            }
    }
    return result;
}

} // namespace detail

/// The children of elements of a level, as ranges of numbers of the next level. The children of all elements are all
/// elements, and those of two elements have none in common; so over several levels descendants are children of children.
/// Preconditions: `ids` is the numbering of the step from `level`; ranges increase and do not overlap.
/// Cost: O(ranges).
template <level Level, level_numbering Numbering>
element_ranges children(const Level& level, const Numbering& ids, const element_ranges& parents)
{
    return {detail::children_among(level, ids.vertices, parents),
            detail::children_among(level, ids.edges, parents),
            detail::children_among(level, ids.faces, parents)};
}

} // namespace kith
