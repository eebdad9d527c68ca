// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "column_numbers.hpp"

#include <kith/core/base/storage.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>

namespace kith {

namespace detail {

/// The tuples of a column that a sweep over the elements of a level has picked: a run, or the rank of each element.
template <std::unsigned_integral Index>
class found_tuples {
public:
    found_tuples() = default;
    found_tuples(std::size_t first, std::size_t count) : first_(first), count_(count) {}
    /// Takes for each element the number of picked elements before it, and once more the number of all at the end.
    found_tuples(storage<Index> before, std::size_t count) : count_(count), before_(std::move(before)) {}

    [[nodiscard]] bool is_run() const { return before_.empty(); }
    [[nodiscard]] std::size_t first() const { return first_; }
    [[nodiscard]] std::size_t count() const { return count_; }
    [[nodiscard]] std::size_t rank(std::size_t index, std::size_t each) const
    {
        return each * before_[index / each] + index % each;
    }
    [[nodiscard]] bool has(std::size_t index, std::size_t each) const
    {
        const std::size_t element = index / each;
        return element + 1 < before_.size() and before_[element] != before_[element + 1];
    }
    [[nodiscard]] std::size_t tuple(std::size_t rank, std::size_t each) const
    {
        const auto element = std::upper_bound(before_.begin(), before_.end(), rank / each) - 1;
        return std::size_t(element - before_.begin()) * each + rank % each;
    }

private:
    std::size_t first_ = 0, count_ = 0;
    storage<Index> before_;
};

/// Returns the tuples whose elements `keep` picks. Cost: one sweep over the elements, and a second one if the picked
/// elements are not consecutive.
template <std::unsigned_integral Index, tuple_kind Kind, level Level, class Keep>
found_tuples<Index> find_tuples(const Level& level, const Keep& keep)
{
    constexpr std::size_t each = tuples_per_element(Kind);
    const auto elements = tuple_elements_of<Kind>(level);
    const auto run_from = [&](std::size_t x, bool picked) {
        while (x < elements.size() and bool(keep(elements[x])) == picked)
            ++x;
        return x;
    };
    // If the picked elements do not form one run, this is noticed early, usually at the first boundary face.
    const std::size_t first = run_from(0, false), last = run_from(first, true);
    if (run_from(last, false) == elements.size())
        return {each * first, each * (last - first)};
    storage<Index> before(elements.size() + 1);
    Index picked = 0;
    for (std::size_t x = 0; x < elements.size(); ++x) {
        before[x] = picked;
        picked += Index(bool(keep(elements[x])));
    }
    before[elements.size()] = picked;
    return {std::move(before), each * std::size_t(picked)};
}

} // namespace detail

/// The ids of the new elements of one kind, and the tuples that made them.
template <class I>
concept element_ids = requires(const I& ids, std::size_t n) {
    // True if some tuples of a kind make elements; true if all of them do, on any mesh.
    { I::template has<tuple_kind::v> } -> std::convertible_to<bool>;
    { I::template is_full<tuple_kind::v> } -> std::convertible_to<bool>;
    // The number of elements.
    { ids.total() } -> std::convertible_to<std::size_t>;
    // The element that a tuple made, or `none` if it made no element. Some tuples of its kind make elements.
    { ids.template id<tuple_kind::v>(n) } -> std::convertible_to<std::size_t>;
    { I::none } -> std::convertible_to<std::size_t>;
    // The element of a tuple that made one.
    { ids.template known_id<tuple_kind::v>(n) } -> std::convertible_to<std::size_t>;
    // The tuple that made an element.
    { ids.origin(n) } -> std::convertible_to<std::pair<tuple_kind, std::size_t>>;
};

/// The ids of the new elements of one kind, computed by column_numbers. The level exists, so the tuples that conditions
/// pick are found by a sweep over its elements.
template <std::unsigned_integral Index, class... Columns>
class column_ids {
    using numbers = column_numbers<Index, detail::found_tuples<Index>, Columns...>;

public:
    static constexpr std::size_t size = numbers::size;
    static constexpr auto kinds = numbers::kinds;
    static constexpr Index none = std::numeric_limits<Index>::max();

    column_ids() = default;
    /// Takes the coarse level and the columns. Cost: O(1), and one sweep over the tuples of each column with a
    /// condition.
    template <level Level>
    column_ids(const Level& level, const std::tuple<Columns...>& list)
        : numbers_(count_elements(level), list,
                   [&]<tuple_kind Kind, class Where, class Degree>(std::size_t, const column<Kind, Where, Degree>& c,
                                                                   std::size_t tuples) -> detail::found_tuples<Index> {
                       if constexpr (not detail::picks_at_boundary<Where>)
                           return detail::find_tuples<Index, Kind>(level, c.where.keep);
                       else if (level.is_closed()) // without a boundary there is nothing to look at
                           return {0, Where::inner ? tuples : 0};
                       else
                           return detail::find_tuples<Index, Kind>(level, [&](const auto& element) {
                               return element.is_boundary() ? bool(c.where.keep(element)) : Where::inner;
                           });
                   })
    {
    }

    template <tuple_kind Kind>
    static constexpr bool has = numbers::template has<Kind>;
    /// True if every tuple of this kind makes an element, on any mesh.
    template <tuple_kind Kind>
    static constexpr bool is_full = numbers::template is_full<Kind>;

    /// Returns the number of new elements; count(i) those of column i, base(i) those before it.
    [[nodiscard]] std::size_t total() const { return numbers_.total(); }
    [[nodiscard]] std::size_t count(std::size_t i) const { return numbers_.count(i); }
    [[nodiscard]] std::size_t base(std::size_t i) const { return numbers_.base(i); }

    /// Returns the id of the element that a tuple made, or `none` if the column leaves this tuple out.
    template <tuple_kind Kind>
    [[nodiscard]] Index id(std::size_t index) const
    {
        if constexpr (not is_full<Kind>)
            if (not numbers_.has_number(numbers::template position<Kind>(), index, tuples_per_element(Kind)))
                return none;
        return known_id<Kind>(index);
    }
    /// Returns the id of the element that a tuple made. Precondition: the column does not leave this tuple out.
    template <tuple_kind Kind>
    [[nodiscard]] Index known_id(std::size_t index) const
    {
        if constexpr (is_full<Kind>)
            return numbers_.template number<Kind>(index);
        else
            return numbers_.number(numbers::template position<Kind>(), index, tuples_per_element(Kind));
    }
    /// Returns the ids in column i of consecutive tuples, which are all tuples of some elements. Cost: O(1).
    [[nodiscard]] number_range ids(std::size_t i, const number_range& tuples) const
    {
        return numbers_.numbers(i, tuples);
    }
    /// Returns the tuple that made an element. Precondition: id < total(). Cost: O(1), O(log n) in a column whose
    /// tuples are not consecutive.
    [[nodiscard]] std::pair<tuple_kind, std::size_t> origin(std::size_t id) const { return numbers_.origin(id); }

private:
    numbers numbers_;
};

} // namespace kith
