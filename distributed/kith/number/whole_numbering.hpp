// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "boundary_facts.hpp"
#include "column_facts.hpp"
#include "whole_counts.hpp"
#include "whole_tuple.hpp"

#include <kith/association/columns.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace kith {

/// The ids of all new elements of one kind in the whole mesh, by formula: the base of a column plus the number of the
/// tuple. Where the boundary leaves tuples out (`inside`, `on_boundary`), the exceptions are kept: they are few, since
/// they lie along curves. Where marks of edges decide, the tuple knows how many there are before it. It is `column_ids`,
/// for a mesh that nobody holds.
template <class List>
class whole_column_ids;
template <template <class...> class List, class... Columns>
class whole_column_ids<List<Columns...>> {
public:
    static constexpr std::size_t size = sizeof...(Columns);

    whole_column_ids() = default;
    /// From the counts of the coarse level and the facts of all of its boundary, in any order.
    whole_column_ids(const whole_counts& whole, const List<Columns...>& columns, std::vector<boundary_fact> facts)
    {
        std::sort(facts.begin(), facts.end());
        std::apply([&](const auto&... column) { (append(whole, column, facts), ...); }, columns.list);
    }

    [[nodiscard]] global_id total() const { return base_[size]; }
    [[nodiscard]] global_id count(std::size_t column) const { return base_[column + 1] - base_[column]; }
    /// The corners of all new faces.
    [[nodiscard]] global_id total_corners() const { return first_corner_[size]; }

    /// The id that belongs to a tuple. Precondition: the scheme makes one.
    [[nodiscard]] global_id id(const whole_tuple& tuple) const
    {
        const std::size_t i = position(tuple.kind);
        return base_[i] + rank(i, tuple);
    }
    /// The inverse: the tuple that gave birth to an element, without the corners before it.
    /// Preconditions: id < total(); where marks decide, the marked edges come first, as they do on all levels but 0.
    /// Cost: O(log exceptions).
    [[nodiscard]] whole_tuple origin(global_id id) const
    {
        std::size_t i = 0;
        while (id >= base_[i + 1])
            ++i;
        const global_id tuple = tuple_of_rank(i, id - base_[i]);
        return {kinds[i], tuple, 0, kinds[i] == tuple_kind::ve ? tuple / 2 : tuple};
    }
    /// The first corner of a new face. Where its degree is that of a face (the number of faces at a vertex) the tuple has
    /// to know the corners before it.
    [[nodiscard]] global_id first_corner(const whole_tuple& tuple) const
    {
        const std::size_t i = position(tuple.kind);
        if (degree_[i] != 0)
            return first_corner_[i] + global_id(degree_[i]) * rank(i, tuple);
        const auto before = std::lower_bound(exceptions_[i].begin(), exceptions_[i].end(), tuple.id);
        const std::ptrdiff_t n = before - exceptions_[i].begin();
        return first_corner_[i] + tuple.corners_before + global_id(n == 0 ? 0 : corners_more_[i][std::size_t(n - 1)]);
    }

private:
    static constexpr std::array<tuple_kind, size> kinds{Columns::kind...};

    static std::size_t position(tuple_kind kind)
    {
        return std::size_t(std::find(kinds.begin(), kinds.end(), kind) - kinds.begin());
    }
    [[nodiscard]] global_id rank(std::size_t i, const whole_tuple& tuple) const
    {
        if (picked_before_[i] != nullptr)
            return picked_before_[i](tuple.id, std::min(tuple.marked_before, marked_edges_));
        if (exceptions_[i].empty())
            return tuple.id;
        const auto before = std::lower_bound(exceptions_[i].begin(), exceptions_[i].end(), tuple.id);
        const auto n = global_id(before - exceptions_[i].begin());
        return exceptions_are_all_[i] ? n : tuple.id - excluded_before(i, std::size_t(n));
    }
    [[nodiscard]] global_id tuple_of_rank(std::size_t i, global_id rank) const
    {
        if (picked_[i] != nullptr)
            return picked_[i](rank, marked_edges_);
        const auto& all = exceptions_[i];
        if (all.empty())
            return rank;
        if (exceptions_are_all_[i])
            return all[rank];
        // Behind the last exception up to which no more than `rank` tuples give birth, counting itself.
        std::size_t n = 0;
        for (std::size_t end = all.size(); n < end;) {
            const std::size_t middle = (n + end) / 2;
            (all[middle] + 1 - excluded_[i][middle] <= rank ? n = middle + 1 : end = middle);
        }
        return rank + excluded_before(i, n);
    }
    /// Of the first n exceptions those that the column leaves out.
    [[nodiscard]] global_id excluded_before(std::size_t i, std::size_t n) const
    {
        return n == 0 ? 0 : excluded_[i][n - 1];
    }

    template <tuple_kind Kind, class Where, class Degree>
    void append(const whole_counts& whole, const column<Kind, Where, Degree>& c,
                const std::vector<boundary_fact>& facts)
    {
        constexpr bool at_boundary = detail::picks_at_boundary<Where>;
        static_assert(
            not requires { c.where.keep; } or at_boundary or detail::picks_by_marks<Where>,
            "columns that pick tuples anywhere have no ids in closed form unless they say how many");
        static_assert(not detail::has_degree<Degree> or detail::has_fixed_degree<Degree> or Kind == tuple_kind::f or
                          Kind == tuple_kind::v,
                      "new faces of unknown degree need a face or a vertex that tells it");
        static_assert(not detail::has_degree<Degree> or detail::has_fixed_degree<Degree> or not at_boundary or
                          Kind == tuple_kind::v,
                      "only vertices may both leave tuples out and tell the degree of new faces");
        static_assert(
            not detail::has_degree<Degree> or detail::has_fixed_degree<Degree> or Kind == tuple_kind::f or
                not std::same_as<Where, all_or_none>,
            "vertices that tell the degree of new faces do so in every step; in tiles a step in between would "
            "make others of them");
        const std::size_t i = appended_++;
        global_id count = detail::tuples_of(whole, Kind);
        if constexpr (std::same_as<Where, all_or_none>)
            count = c.where.all ? count : 0;
        if constexpr (detail::picks_by_marks<Where>) {
            picked_before_[i] = [](global_id n, global_id marked) { return decltype(Where::keep)::before(n, marked); };
            picked_[i] = [](global_id rank, global_id marked) { return decltype(Where::keep)::picked(rank, marked); };
            marked_edges_ = whole.marked_edges;
            count = picked_before_[i](count, marked_edges_);
        }
        if constexpr (at_boundary) {
            exceptions_are_all_[i] = not Where::inner;
            global_id excluded = 0, kept = 0;
            std::int64_t more = 0;
            for (const auto& fact : std::ranges::equal_range(facts, i, {}, &boundary_fact::column)) {
                fact.is_kept != 0 ? ++kept : ++excluded;
                exceptions_[i].push_back(fact.tuple);
                excluded_[i].push_back(excluded);
                corners_more_[i].push_back(more += fact.corners_more);
            }
            count = Where::inner ? count - excluded : kept;
        }
        base_[i + 1] = detail::add_ids(base_[i], count);
        if constexpr (detail::has_degree<Degree>) {
            global_id corners;
            if constexpr (detail::has_fixed_degree<Degree>) {
                degree_[i] = Degree::value;
                if (__builtin_mul_overflow(global_id(Degree::value), count, &corners))
                    corners = detail::add_ids(~global_id(0), 1);
            } else {
                corners = count == 0
                              ? 0
                              : whole.corners + global_id(corners_more_[i].empty() ? 0 : corners_more_[i].back());
            }
            first_corner_[i + 1] = detail::add_ids(first_corner_[i], corners);
        }
    }

    std::size_t appended_ = 0;
    std::array<global_id, size + 1> base_{}, first_corner_{};
    std::array<std::size_t, size> degree_{}; // of the new faces; 0: of many degrees
    std::array<bool, size> exceptions_are_all_{};
    global_id marked_edges_ = 0;
    std::array<global_id (*)(global_id, global_id), size> picked_before_{}, picked_{}; // where marks decide
    std::array<std::vector<global_id>, size> exceptions_, excluded_; // tuples at the boundary, increasing; sums
    std::array<std::vector<std::int64_t>, size> corners_more_;       // sums of the corners they have beyond their faces
};

/// The ids of all new elements of one step in the whole mesh.
template <class Columns>
struct whole_numbering {
    whole_column_ids<decltype(Columns::vertices)> vertices;
    whole_column_ids<decltype(Columns::edges)> edges;
    whole_column_ids<decltype(Columns::faces)> faces;

    whole_numbering() = default;
    /// From a tile of the coarse level that owns all faces at the boundary and has a ring of shadows.
    template <class Tile>
    whole_numbering(const whole_counts& whole, const Columns& columns, const Tile& rim)
        : whole_numbering(whole, columns, facts_at_boundary(columns, rim))
    {
    }
    /// From the facts of all of the boundary: of vertices, edges and faces.
    whole_numbering(const whole_counts& whole, const Columns& columns, std::array<std::vector<boundary_fact>, 3> facts)
        : vertices(whole, columns.vertices, std::move(facts[0]))
        , edges(whole, columns.edges, std::move(facts[1]))
        , faces(whole, columns.faces, std::move(facts[2]))
    {
    }
    template <class Tile>
    static std::array<std::vector<boundary_fact>, 3> facts_at_boundary(const Columns& columns, const Tile& part)
    {
        return {boundary_facts(columns.vertices, part),
                boundary_facts(columns.edges, part),
                boundary_facts(columns.faces, part)};
    }

    [[nodiscard]] whole_counts counts() const
    {
        constexpr bool marks = detail::column_facts<decltype(Columns::vertices)>::any_by_marks;
        return {vertices.total(), edges.total(), faces.total(), faces.total_corners(), marks ? edges.count(0) : 0};
    }
};

} // namespace kith
