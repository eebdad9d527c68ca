// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "columns.hpp"

#include <kith/base/storage.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>

namespace kith {

/// The ids of the new elements of one kind: for each column its base, and where the tuples that are picked do not follow
/// one another the rank of each.
template <class Index, class... Columns>
class column_ids {
public:
    static constexpr std::size_t size = sizeof...(Columns);
    static constexpr Index none = std::numeric_limits<Index>::max();

    column_ids() = default;
    /// Cost: O(1), and one pass over the tuples of each column that is not full.
    template <class Level>
    column_ids(const Level& level, const std::tuple<Columns...>& list)
    {
        std::apply([&](const auto&... column) { (append(level, column), ...); }, list);
    }

    template <tuple_kind Kind>
    static constexpr bool has = ((Columns::kind == Kind) or ...);
    /// Every tuple of this kind gives birth, on any mesh.
    template <tuple_kind Kind>
    static constexpr bool is_full = ((Columns::kind == Kind and std::same_as<decltype(Columns::where), everywhere>) or
                                     ...);

    /// The number of new elements, and of those in column i.
    [[nodiscard]] std::size_t total() const { return base_[size]; }
    [[nodiscard]] std::size_t count(std::size_t i) const { return base_[i + 1] - base_[i]; }
    [[nodiscard]] std::size_t base(std::size_t i) const { return base_[i]; }

    /// The id of the element that a tuple gave birth to, `none` if the column leaves this tuple out.
    template <tuple_kind Kind>
    [[nodiscard]] Index id(std::size_t index) const
    {
        return is_full<Kind> or gives_birth<Kind>(index) ? known_id<Kind>(index) : none;
    }
    /// The same. Precondition: the column does not leave this tuple out.
    template <tuple_kind Kind>
    [[nodiscard]] Index known_id(std::size_t index) const
    {
        constexpr std::size_t i = position<Kind>(), each = tuples_per_element(Kind);
        if (is_full<Kind> or before_[i].empty())
            return Index(start_[i] + index);
        return Index(base_[i] + each * before_[i][index / each] + index % each);
    }
    /// The inverse: the tuple that gave birth to an element. Precondition: id < total(). Cost: O(1), O(log n) in a column
    /// whose tuples do not follow one another.
    [[nodiscard]] std::pair<tuple_kind, std::size_t> origin(std::size_t id) const
    {
        constexpr std::array<tuple_kind, size> kinds{Columns::kind...};
        std::size_t i = 0;
        while (id >= base_[i + 1])
            ++i;
        const std::size_t rank = id - base_[i];
        if (before_[i].empty())
            return {kinds[i], id - start_[i]};
        const std::size_t each = tuples_per_element(kinds[i]);
        const auto element = std::upper_bound(before_[i].begin(), before_[i].end(), rank / each) - 1;
        return {kinds[i], std::size_t(element - before_[i].begin()) * each + rank % each};
    }

private:
    template <tuple_kind Kind>
    [[nodiscard]] bool gives_birth(std::size_t index) const
    {
        constexpr std::size_t i = position<Kind>();
        const storage<Index>& before = before_[i];
        if (before.empty())
            return start_[i] + index - base_[i] < count(i);
        const std::size_t element = index / tuples_per_element(Kind);
        return element + 1 < before.size() and before[element] != before[element + 1];
    }
    template <tuple_kind Kind>
    static constexpr std::size_t position()
    {
        static_assert(has<Kind>, "the scheme's columns() declare no new element of this kind for this kind of tuple");
        constexpr std::array<tuple_kind, size> kinds{Columns::kind...};
        return std::size_t(std::find(kinds.begin(), kinds.end(), Kind) - kinds.begin());
    }
    template <class Level, tuple_kind Kind, class Where, class Degree>
    void append(const Level& level, const column<Kind, Where, Degree>& c)
    {
        const std::size_t i = appended_++;
        start_[i] = base_[i];
        std::size_t count = tuple_count(level, Kind);
        if constexpr (requires { Where::inner; }) { // the boundary decides; without one there is nothing to look at
            if (level.is_closed())
                count = Where::inner ? count : 0;
            else
                count = pick<Kind>(level, i, [&](const auto& element) {
                    return element.is_boundary() ? bool(c.where.keep(element)) : Where::inner;
                });
        } else if constexpr (std::same_as<Where, all_or_none>) {
            count = c.where.all ? count : 0;
        } else if constexpr (not std::same_as<Where, everywhere>) {
            count = pick<Kind>(level, i, c.where.keep);
        }
        base_[i + 1] = base_[i] + count;
    }

    template <tuple_kind Kind, class Level, class Keep>
    std::size_t pick(const Level& level, std::size_t i, const Keep& keep)
    {
        constexpr std::size_t each = tuples_per_element(Kind);
        const auto elements = tuple_elements_of<Kind>(level);
        const auto run_from = [&](std::size_t x, bool picked) {
            while (x < elements.size() and bool(keep(elements[x])) == picked)
                ++x;
            return x;
        };
        // Where it is no run that shows early: at the first boundary, in the first faces.
        const std::size_t first = run_from(0, false), last = run_from(first, true);
        if (run_from(last, false) == elements.size()) {
            start_[i] = base_[i] - each * first;
            return each * (last - first);
        }
        storage<Index> before(elements.size() + 1);
        Index picked = 0;
        for (std::size_t x = 0; x < elements.size(); ++x) {
            before[x] = picked;
            picked += Index(bool(keep(elements[x])));
        }
        before[elements.size()] = picked;
        before_[i] = std::move(before);
        return each * std::size_t(picked);
    }

    std::size_t appended_ = 0;
    std::array<std::size_t, size + 1> base_{};
    // Of a column that is a run of tuples: what the index of a tuple and its id differ by.
    std::array<std::size_t, size> start_{};
    // Of any other, by element: how many before it were picked.
    std::array<storage<Index>, size> before_;
};

} // namespace kith
