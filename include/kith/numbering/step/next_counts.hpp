// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/counts.hpp>
#include <kith/numbering/association/column_numbers.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <tuple>

namespace kith {

namespace detail {

/// The tuples of a column if only their number is known.
class counted_tuples {
public:
    counted_tuples() = default;
    explicit counted_tuples(std::uint64_t count) : count_(count) {}

    [[nodiscard]] static std::uint64_t first() { return 0; }
    [[nodiscard]] std::uint64_t count() const { return count_; }
    [[nodiscard]] static std::uint64_t corners(std::uint64_t all) { return all; }

private:
    std::uint64_t count_ = 0;
};

/// A condition that tells how many edges are marked, and how many tuples it picks then.
template <class Where>
concept counts_marks = requires(const Where& where, const counts& c, std::uint64_t n) {
    { where.keep.marked(c, 0) } -> std::convertible_to<std::uint64_t>;
    { where.keep.before(n, n) } -> std::convertible_to<std::uint64_t>;
};
/// A condition that also tells which tuples it picks, if the marked edges come first.
template <class Where>
concept numbers_by_marks = counts_marks<Where> and requires(const Where& where, std::uint64_t n) {
    { where.keep.picked(n, n) } -> std::convertible_to<std::uint64_t>;
};
template <class Where>
concept counts_tuples = requires(const Where& where, const counts& c) {
    { std::invoke(where.how_many, c) } -> std::convertible_to<std::uint64_t>;
};

/// Returns the number of tuples that a condition picks out of `tuples`. If the condition does not state it, there is no
/// boundary.
template <class Where>
counted_tuples count_picked(const Where& where, std::uint64_t tuples, const counts& c, int generation)
{
    if constexpr (counts_marks<Where>) {
        return counted_tuples(where.keep.before(tuples, where.keep.marked(c, generation)));
    } else if constexpr (picks_at_boundary<Where>) {
        std::uint64_t exceptions = 0;
        if constexpr (counts_tuples<Where>)
            exceptions = std::invoke(where.how_many, c);
        return counted_tuples(Where::inner ? tuples - std::min(tuples, exceptions) : exceptions);
    } else {
        return counted_tuples(std::invoke(where.how_many, c));
    }
}

template <class List>
struct counted_columns;
template <template <class...> class List, class... C>
struct counted_columns<List<C...>> {
    /// True if the number of tuples of each column is known; all_inside is also true if only the boundary keeps it
    /// unknown.
    static constexpr bool all = ((not has_condition<decltype(C::where)> or counts_tuples<decltype(C::where)> or
                                  counts_marks<decltype(C::where)>) and
                                 ...);
    static constexpr bool all_inside = ((not has_condition<decltype(C::where)> or counts_tuples<decltype(C::where)> or
                                         counts_marks<decltype(C::where)> or picks_at_boundary<decltype(C::where)>) and
                                        ...);
    /// True if the number of corners of the new faces is known, too.
    static constexpr bool corners = ((fixed_degree_of<decltype(C::degree)> != 0 or
                                      (std::same_as<decltype(C::degree), same_degree> and C::kind == tuple_kind::f and
                                       not has_condition<decltype(C::where)>)) and
                                     ...);

    static auto count(const List<C...>& columns, const counts& c, int generation)
    {
        return column_numbers<std::uint64_t, counted_tuples, C...>(
            {c.vertices, c.edges, c.faces, c.corners()},
            columns.list,
            [&](std::size_t, const auto& column, std::uint64_t tuples) {
                return count_picked(column.where, tuples, c, generation);
            });
    }
    /// Returns how many of the new faces have three corners, given their numbers. Faces whose degree the columns do not
    /// know are left out.
    static std::uint64_t count_triangles(const auto& numbers, const counts& c)
    {
        std::uint64_t result = 0;
        std::size_t i = 0;
        const auto add = [&]<tuple_kind K, class W, class D>(const column<K, W, D>*) {
            if constexpr (fixed_degree_of<D> == 3)
                result += numbers.count(i);
            else if constexpr (std::same_as<D, same_degree>)
                result += c.triangles;
            ++i;
        };
        (add(static_cast<const C*>(nullptr)), ...);
        return result;
    }
};

} // namespace detail

/// Columns from which the counts of the next level follow. They declare edges, and each condition says how many tuples
/// it picks. The boundary edges of the next level are the sides of edges that no corner has. They can be counted if the
/// degree of each new face is fixed or `same_degree`; else `with_boundary` gives them. If `Closed` is true, there is no
/// boundary.
template <class Columns, bool Closed = false>
concept countable_columns = std::tuple_size_v<decltype(Columns::edges.list)> != 0 and
                            (Closed ? detail::counted_columns<decltype(Columns::vertices)>::all_inside and
                                          detail::counted_columns<decltype(Columns::edges)>::all_inside and
                                          detail::counted_columns<decltype(Columns::faces)>::all_inside
                                    : detail::counted_columns<decltype(Columns::vertices)>::all and
                                          detail::counted_columns<decltype(Columns::edges)>::all and
                                          detail::counted_columns<decltype(Columns::faces)>::all and
                                          (detail::counted_columns<decltype(Columns::faces)>::corners or
                                           std::invocable<decltype(Columns::boundary), const counts&>));

/// Returns the counts of the next level. Precondition: the level is closed if `Closed`. Cost: O(1).
template <bool Closed, declared_columns Columns>
    requires countable_columns<Columns, Closed>
counts next_counts(const Columns& columns, const counts& c, int generation)
{
    const auto faces = detail::counted_columns<decltype(Columns::faces)>::count(columns.faces, c, generation);
    counts next;
    if constexpr (not Closed and std::invocable<decltype(Columns::boundary), const counts&>)
        next = std::invoke(columns.boundary, c);
    next.vertices = detail::counted_columns<decltype(Columns::vertices)>::count(columns.vertices, c, generation)
                        .total();
    next.edges = detail::counted_columns<decltype(Columns::edges)>::count(columns.edges, c, generation).total();
    next.faces = faces.total();
    next.triangles = detail::counted_columns<decltype(Columns::faces)>::count_triangles(faces, c);
    if constexpr (not Closed and not std::invocable<decltype(Columns::boundary), const counts&>)
        // More corners than sides are a fault of the scheme, which the step itself will name.
        next.boundary_edges = std::max(2 * next.edges, faces.total_corners()) - faces.total_corners();
    return next;
}

} // namespace kith
