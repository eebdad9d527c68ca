// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "boundary_facts.hpp"
#include "column_facts.hpp"
#include "prefix_sums.hpp"
#include "global_counts.hpp"
#include "global_tuple.hpp"

#include <kith/numbering/association/column_numbers.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith {

namespace detail {

/// Returns the last number of [begin, end) for which `holds`. Preconditions: it holds for `begin`, and for no number
/// after one for which it does not hold.
template <std::predicate<global_id> Holds>
global_id last_where(global_id begin, global_id end, const Holds& holds)
{
    while (end - begin > 1) {
        const global_id middle = begin + (end - begin) / 2;
        (holds(middle) ? begin : end) = middle;
    }
    return begin;
}

/// The tuples of a column that make elements, in a mesh that no rank holds. If the boundary decides (`inside`,
/// `on_boundary`), the list stores the exceptions, which are few, since they lie along curves. If marks of edges
/// decide, the tuple has the number of marked edges before it; otherwise marked edges come first, unless `tell` was
/// called.
class exception_list {
public:
    exception_list() = default;
    /// Takes two functions for marks: the number of picked tuples before a tuple, and its inverse; see
    /// numbers_by_marks.
    using count_by_marks = global_id (*)(global_id, global_id);
    exception_list(count_by_marks before, count_by_marks picked, global_id tuples, global_id marked)
        : count_(before(tuples, marked)), tuples_(tuples), marked_edges_(marked), before_(before), picked_(picked)
    {
    }
    /// Takes all facts of the boundary, in their order.
    template <class Facts>
    exception_list(bool inner, global_id tuples, const Facts& facts) : exceptions_are_all_(not inner)
    {
        global_id excluded = 0, kept = 0;
        std::int64_t more = 0;
        for (const auto& fact : facts) {
            fact.is_kept != 0 ? ++kept : ++excluded;
            exceptions_.push_back(fact.tuple);
            excluded_.push_back(excluded);
            corners_more_.push_back(more += fact.corners_more);
        }
        count_ = inner ? tuples - excluded : kept;
    }

    /// Sets the number of marked edges before each edge, for a level on which the marked edges do not come first.
    void tell(const std::shared_ptr<const prefix_sums>& marks)
    {
        if (before_ != nullptr)
            marks_ = marks;
    }

    [[nodiscard]] bool is_run() const { return before_ == nullptr and exceptions_.empty(); }
    [[nodiscard]] static global_id first() { return 0; }
    [[nodiscard]] global_id count() const { return count_; }
    [[nodiscard]] global_id rank(const global_tuple& tuple, std::size_t each) const
    {
        return before_ != nullptr ? before_(tuple.id, std::min(tuple.marked_before, marked_edges_))
                                  : rank(tuple.id, each);
    }
    [[nodiscard]] global_id rank(global_id tuple, std::size_t each) const
    {
        if (before_ != nullptr)
            return before_(tuple, marked_before(tuple / each));
        const std::size_t n = exceptions_before(tuple);
        return exceptions_are_all_ ? n : tuple - excluded_before(n);
    }
    [[nodiscard]] global_id tuple(global_id rank, std::size_t each) const
    {
        if (marks_ != nullptr) { // finds the last element before which at most `rank` tuples are picked
            const auto begin = [&](global_id element) { return before_(each * element, marked_before(element)); };
            const global_id element = last_where(
                0, tuples_ / each, [&](global_id candidate) { return begin(candidate) <= rank; });
            return each * element + (rank - begin(element));
        }
        if (picked_ != nullptr)
            return picked_(rank, marked_edges_);
        if (exceptions_are_all_)
            return exceptions_[rank];
        // Finds the last exception up to which, including itself, at most `rank` tuples make elements.
        std::size_t n = 0;
        for (std::size_t end = exceptions_.size(); n < end;) {
            const std::size_t middle = (n + end) / 2;
            (exceptions_[middle] + 1 - excluded_[middle] <= rank ? n = middle + 1 : end = middle);
        }
        return rank + excluded_before(n);
    }
    [[nodiscard]] global_id corners(global_id all) const
    {
        return all + global_id(corners_more_.empty() ? 0 : corners_more_.back());
    }
    [[nodiscard]] global_id corners_before(const global_tuple& tuple) const
    {
        const std::size_t n = exceptions_before(tuple.id);
        return tuple.corners_before + global_id(n == 0 ? 0 : corners_more_[n - 1]);
    }

private:
    [[nodiscard]] global_id marked_before(global_id edge) const
    {
        return marks_ != nullptr ? marks_->before(edge) : std::min(edge, marked_edges_);
    }
    [[nodiscard]] std::size_t exceptions_before(global_id tuple) const
    {
        return std::size_t(std::ranges::lower_bound(exceptions_, tuple) - exceptions_.begin());
    }
    /// Returns how many of the first n exceptions the column leaves out.
    [[nodiscard]] global_id excluded_before(std::size_t n) const { return n == 0 ? 0 : excluded_[n - 1]; }

    global_id count_ = 0, tuples_ = 0, marked_edges_ = 0;
    count_by_marks before_ = nullptr, picked_ = nullptr;
    std::shared_ptr<const prefix_sums> marks_;
    bool exceptions_are_all_ = false;
    std::vector<global_id> exceptions_, excluded_; // boundary tuples, increasing; sums
    std::vector<std::int64_t> corners_more_;       // sums of the corners of new faces minus the faces of tuples
};

template <tuple_kind Kind, class Where, class Degree>
consteval void require_closed_form(const column<Kind, Where, Degree>*)
{
    constexpr bool of_many_degrees = has_degree<Degree> and fixed_degree_of<Degree> == 0;
    static_assert(not has_condition<Where> or picks_at_boundary<Where> or numbers_by_marks<Where>,
                  "columns that pick tuples anywhere have no ids in closed form unless they say how many");
    static_assert(not of_many_degrees or Kind == tuple_kind::f or Kind == tuple_kind::v,
                  "new faces of unknown degree need a face or a vertex that tells it");
    static_assert(not of_many_degrees or not picks_at_boundary<Where> or Kind == tuple_kind::v,
                  "only vertices may both leave tuples out and tell the degree of new faces");
    static_assert(
        not of_many_degrees or Kind == tuple_kind::f or not std::same_as<Where, all_or_none>,
        "vertices that tell the degree of new faces must do so in every step; in tiles another step would change them");
}

} // namespace detail

/// The global numbers of all new elements of one kind: column_numbers with the facts of the whole mesh.
template <class List>
class global_column_ids;
template <template <class...> class List, class... Columns>
class global_column_ids<List<Columns...>> {
    using numbers = column_numbers<global_id, detail::exception_list, Columns...>;

public:
    static constexpr std::size_t size = numbers::size;
    static constexpr auto kinds = numbers::kinds;

    global_column_ids() = default;
    /// Takes the counts of the coarse level and the facts of its whole boundary, in any order.
    global_column_ids(const global_counts& whole, const List<Columns...>& columns, std::vector<boundary_fact> facts)
    {
        (detail::require_closed_form(static_cast<const Columns*>(nullptr)), ...);
        std::sort(facts.begin(), facts.end());
        numbers_ = numbers(
            whole.elements(),
            columns.list,
            [&]<tuple_kind Kind, class Where, class Degree>(
                std::size_t i, const column<Kind, Where, Degree>&, global_id tuples) {
                if constexpr (detail::numbers_by_marks<Where>)
                    return detail::exception_list(
                        &decltype(Where::keep)::before, &decltype(Where::keep)::picked, tuples, whole.marked_edges);
                else
                    return detail::exception_list(
                        Where::inner, tuples, std::ranges::equal_range(facts, i, {}, &boundary_fact::column));
            });
    }

    [[nodiscard]] global_id total() const { return numbers_.total(); }
    [[nodiscard]] global_id count(std::size_t column) const { return numbers_.count(column); }
    /// Returns the number of corners of all new faces.
    [[nodiscard]] global_id total_corners() const { return numbers_.total_corners(); }

    /// Returns the number of the element that a tuple makes. Precondition: the scheme makes one.
    [[nodiscard]] global_id id(const global_tuple& tuple) const
    {
        return numbers_.number(numbers::position(tuple.kind), tuple, tuples_per_element(tuple.kind));
    }
    /// Returns the numbers in column i of consecutive tuples, which are all tuples of some elements. Preconditions and
    /// cost: as origin.
    [[nodiscard]] number_range ids(std::size_t i, const number_range& tuples) const
    {
        return numbers_.numbers(i, tuples);
    }
    /// Sets the number of marked edges before each edge of level 0, where the marked edges do not come first.
    void tell_marks(const std::shared_ptr<const prefix_sums>& marks)
    {
        for (std::size_t i = 0; i < size; ++i)
            numbers_.picked(i).tell(marks);
    }
    /// Returns the tuple that makes an element, without its corners_before. It is the inverse of `id`. Preconditions:
    /// id < total(); if marks decide, the marked edges come first, as on all levels but 0, or tell_marks was called.
    /// Cost: O(log exceptions); after tell_marks O(log elements log runs).
    [[nodiscard]] global_tuple origin(global_id id) const
    {
        const auto [kind, tuple] = numbers_.origin(id);
        return {kind, tuple, 0, kind == tuple_kind::ve ? tuple / 2 : tuple};
    }
    /// Returns the first corner of a new face. If the degree of the face is that of a face or the valence of a vertex,
    /// the tuple must have its corners_before.
    [[nodiscard]] global_id first_corner(const global_tuple& tuple) const
    {
        return numbers_.first_corner(numbers::position(tuple.kind), tuple);
    }
    /// Returns the first corner of the new face with this number. `corners_before(tuple)` returns the number of corners
    /// before a tuple (f) or (v) of the coarse level.
    template <class CornersBefore>
        requires std::is_invocable_r_v<global_id, const CornersBefore&, const global_tuple&>
    [[nodiscard]] global_id first_corner(global_id face, const CornersBefore& corners_before) const
    {
        const std::size_t i = numbers_.column_of(face);
        if (numbers::degree_in(i) != 0)
            return numbers_.first_corner_of(i, face);
        global_tuple tuple = origin(face);
        tuple.corners_before = corners_before(tuple);
        return first_corner(tuple);
    }
    /// Returns the face that has a corner. It is the inverse of first_corner. Precondition: corner < total_corners().
    /// Cost: O(1) if the column fixes the degree of its faces, else O(log faces) times that of first_corner.
    template <class CornersBefore>
        requires std::is_invocable_r_v<global_id, const CornersBefore&, const global_tuple&>
    [[nodiscard]] global_id face_of(global_id corner, const CornersBefore& corners_before) const
    {
        const std::size_t i = numbers_.column_of_corner(corner);
        if (numbers::degree_in(i) != 0)
            return numbers_.face_of_corner(i, corner);
        return detail::last_where(numbers_.base(i), numbers_.base(i) + numbers_.count(i), [&](global_id face) {
            return first_corner(face, corners_before) <= corner;
        });
    }

private:
    numbers numbers_;
};

/// The global numbers of all new elements of one step.
template <declared_columns Columns>
struct global_numbering {
    global_column_ids<decltype(Columns::vertices)> vertices;
    global_column_ids<decltype(Columns::edges)> edges;
    global_column_ids<decltype(Columns::faces)> faces;

    global_numbering() = default;
    /// Takes a tile of the coarse level that owns all faces at the boundary and has a ring of ghosts.
    template <tile_like Tile>
    global_numbering(const global_counts& whole, const Columns& columns, const Tile& rim)
        : global_numbering(whole, columns, facts_at_boundary(columns, rim))
    {
    }
    /// Takes the facts of the whole boundary for the columns of vertices, edges and faces.
    global_numbering(const global_counts& whole, const Columns& columns,
                     std::array<std::vector<boundary_fact>, 3> facts)
        : vertices(whole, columns.vertices, std::move(facts[0]))
        , edges(whole, columns.edges, std::move(facts[1]))
        , faces(whole, columns.faces, std::move(facts[2]))
    {
    }
    template <tile_like Tile>
    static std::array<std::vector<boundary_fact>, 3> facts_at_boundary(const Columns& columns, const Tile& part)
    {
        return {boundary_facts(columns.vertices, part),
                boundary_facts(columns.edges, part),
                boundary_facts(columns.faces, part)};
    }

    [[nodiscard]] global_counts counts() const
    {
        constexpr bool marks = detail::affine_columns<decltype(Columns::vertices)>::by_marks;
        return {vertices.total(), edges.total(), faces.total(), faces.total_corners(), marks ? edges.count(0) : 0};
    }
};

} // namespace kith
