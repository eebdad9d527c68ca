// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/message.hpp>

#include <concepts>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace kith {

/// Values on a few of the many elements of one kind of a level: a sorted list of dense numbers and values. All other
/// elements have T(). It is cut, joined and sent as a `field` is. The state that has it defines how it is inherited.
template <class T>
class sparse_values {
public:
    using entry = std::pair<std::size_t, T>;

    friend bool operator==(const sparse_values&, const sparse_values&) = default;

    [[nodiscard]] bool empty() const { return list_.empty(); }
    /// Returns the entries, sorted by number.
    [[nodiscard]] const std::vector<entry>& list() const { return list_; }
    /// Returns the value of an element, or T(). Cost: O(log of the entries).
    [[nodiscard]] T operator[](std::size_t element) const
    {
        const auto place = std::ranges::lower_bound(list_, element, {}, &entry::first);
        return place != list_.end() and place->first == element ? place->second : T();
    }
    /// Sets or replaces the value of an element; T() removes it. Cost: O(entries), O(log of them) behind the last one.
    void set(std::size_t element, const T& value)
    {
        const auto place = std::ranges::lower_bound(list_, element, {}, &entry::first);
        const bool is_there = place != list_.end() and place->first == element;
        if (value == T()) {
            if (is_there)
                list_.erase(place);
        } else if (is_there) {
            place->second = value;
        } else {
            list_.emplace(place, element, value);
        }
    }
    /// Appends a value in any order, for many at once; `sort` must follow. Precondition: each element once.
    void append(std::size_t element, const T& value) { list_.emplace_back(element, value); }
    void sort() { std::ranges::stable_sort(list_, {}, &entry::first); }

    /// Returns the values of a part, whose elements have these numbers. They increase; a number may come several times.
    /// Cost: O(log) per entry or per element, whichever are fewer, and for what is found.
    template <std::unsigned_integral Index>
    [[nodiscard]] sparse_values of_part(std::span<const Index> numbers) const
    {
        sparse_values result;
        auto known = list_.begin();
        for (auto number = numbers.begin(); number != numbers.end() and known != list_.end();)
            if (known->first < *number)
                known = std::ranges::lower_bound(known, list_.end(), std::size_t(*number), {}, &entry::first);
            else if (*number < known->first)
                number = std::lower_bound(number, numbers.end(), known->first);
            else
                result.append(std::size_t(number++ - numbers.begin()), known->second);
        return result;
    }
    /// Takes over the values of a part. An element that has a value in both keeps the one here. Cost: O(entries log of
    /// them).
    template <std::unsigned_integral Index>
    void add_part(const sparse_values& part, std::span<const Index> numbers)
    {
        for (const auto& [element, value] : part.list_)
            append(numbers[element], value);
        sort();
        const auto twice = std::ranges::unique(list_, {}, &entry::first);
        list_.erase(twice.begin(), twice.end());
    }
    /// Writes the values to a message; unpack() reads them from one.
    template <message_writer Out>
    void pack(Out& out) const
    {
        out.add(std::uint64_t(list_.size()));
        for (const auto& [element, value] : list_)
            out.add(std::uint64_t(element)).add(value);
    }
    template <message_reader In>
    void unpack(In& in)
    {
        list_.clear();
        for (auto left = in.template get<std::uint64_t>(); left > 0; --left) {
            const auto element = in.template get<std::uint64_t>();
            append(element, in.template get<T>());
        }
        sort(); // in case the sender has not sorted them
    }

private:
    std::vector<entry> list_;
};

} // namespace kith
