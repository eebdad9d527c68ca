// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/in_library.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <ranges>
#include <utility>
#include <vector>

namespace kith::mpi::detail {

/// A search in a fan, a range of corners, for the first corner whose `Side` is a vertex; the result is the end if there
/// is none. Cost: linear in small fans, O(log corners) in large ones.
template <class Fan, auto Side>
class fan_lookup {
public:
    explicit fan_lookup(const Fan& fan) : fan_(fan)
    {
        constexpr std::size_t small = 64;
        if (fan.size() <= small)
            return;
        for (auto c = fan.begin(); c != fan.end(); ++c)
            sorted_.emplace_back((*c).*Side, c);
        std::ranges::sort(sorted_);
    }

    [[nodiscard]] auto operator()(std::uint64_t vertex) const
    {
        if (sorted_.empty())
            return std::ranges::find(fan_.begin(), fan_.end(), vertex, Side);
        const auto found = std::ranges::lower_bound(sorted_, vertex, {}, &entry::first);
        return found != sorted_.end() and found->first == vertex ? found->second : fan_.end();
    }

private:
    using entry = std::pair<std::uint64_t, std::ranges::iterator_t<const Fan>>;
    Fan fan_;
    std::vector<entry> sorted_;
};

} // namespace kith::mpi::detail
