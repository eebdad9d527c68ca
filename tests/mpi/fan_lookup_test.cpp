// SPDX-License-Identifier: BSD-3-Clause
#include <kith/mpi/slices/fan_lookup.hpp>

#include <gtest/gtest.h>

#include <cstdint>
#include <span>
#include <vector>

TEST(fan_lookup, finds_the_first_corner_in_small_and_large_fans)
{
    struct corner {
        std::uint64_t next, prev;
    };
    for (const std::uint64_t size : {3U, 64U, 65U, 1000U}) {
        std::vector<corner> corners;
        for (std::uint64_t i = 0; i < size; ++i)
            corners.push_back({7 * i % size, 2 * (i / 2)}); // two corners each have the same prev
        const std::span fan(corners);
        const kith::mpi::detail::fan_lookup<std::span<corner>, &corner::prev> at_prev(fan);
        for (std::uint64_t i = 0; i < size; i += 2) {
            EXPECT_EQ(at_prev(i) - fan.begin(), std::ptrdiff_t(i));
            EXPECT_EQ(at_prev(i + 1), fan.end());
        }
    }
}
