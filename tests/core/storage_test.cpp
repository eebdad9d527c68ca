// SPDX-License-Identifier: BSD-3-Clause
#include <kith/core/base/storage.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using kith::storage;

namespace {

/// A type that counts its living objects and can be made to throw.
struct counted {
    static inline int alive = 0;
    static inline int throw_at = -1;

    counted()
    {
        if (alive == throw_at)
            throw std::runtime_error("enough");
        ++alive;
    }
    counted(const counted&) { ++alive; }
    counted& operator=(const counted&) = default;
    ~counted() { --alive; }
};

std::uintptr_t address(const auto& array)
{
    return reinterpret_cast<std::uintptr_t>(array.data());
}

} // namespace

TEST(storage, starts_empty)
{
    const storage<int> none;
    EXPECT_TRUE(none.empty());
    EXPECT_EQ(none.size(), 0U);
    EXPECT_EQ(none.begin(), none.end());
}

TEST(storage, fills_with_a_value)
{
    const storage<int> seven(3, 7);
    EXPECT_EQ(std::vector<int>(seven.begin(), seven.end()), (std::vector{7, 7, 7}));
}

TEST(storage, copies_any_contiguous_range_and_converts)
{
    const storage<std::uint32_t> numbers(std::vector<std::size_t>{3, 1, 4});
    EXPECT_EQ(std::vector<std::size_t>(numbers.begin(), numbers.end()), (std::vector<std::size_t>{3, 1, 4}));
}

TEST(storage, gives_values_the_alignment_that_they_ask_for)
{
    struct alignas(256) wide {
        std::array<double, 32> x;
    };
    for (const std::size_t size : {3, 600}) { // small and large
        const storage<wide> some(size);
        EXPECT_EQ(address(some) % 256, 0U) << size;
    }
}

TEST(storage, small_arrays_start_at_a_cache_line)
{
    for (std::size_t size = 1; size < 300; size += 37)
        EXPECT_EQ(address(storage<char>(size)) % 64, 0U);
}

TEST(storage, large_arrays_start_at_a_huge_page)
{
    constexpr std::size_t page = 2 << 20;
    EXPECT_EQ(address(storage<double>(3 * page / sizeof(double) + 1)) % page, 0U);
}

TEST(storage, respects_types_that_need_more_alignment)
{
    struct alignas(256) wide {
        char c;
    };
    EXPECT_EQ(address(storage<wide>(3)) % 256, 0U);
}

TEST(storage, a_copy_is_deep)
{
    storage<int> original(2, 1);
    const storage<int> copy = original;
    original[0] = 5;
    EXPECT_EQ(copy[0], 1);
    EXPECT_EQ(copy.size(), 2U);
}

TEST(storage, a_moved_from_array_is_empty)
{
    storage<int> from(2, 1);
    const int* const data = from.data();
    const storage<int> to = std::move(from);
    EXPECT_EQ(to.data(), data);
    EXPECT_TRUE(from.empty()); // NOLINT: the state after a move is what is tested
}

TEST(storage, assignment_replaces_what_was_there)
{
    storage<std::string> a(1, std::string(100, 'a'));
    const storage<std::string> b(3, std::string(100, 'b'));
    a = b;
    EXPECT_EQ(a.size(), 3U);
    EXPECT_EQ(a[2], std::string(100, 'b'));
    EXPECT_EQ(b.size(), 3U);
}

TEST(storage, assignment_to_itself_changes_nothing)
{
    storage<std::string> a(2, "text");
    const auto& same = a;
    a = same;
    EXPECT_EQ(a[1], "text");
}

TEST(storage, elements_that_need_it_are_constructed_and_destroyed_once)
{
    {
        const storage<counted> three(3);
        EXPECT_EQ(counted::alive, 3);
        const storage<counted> copy = three;
        EXPECT_EQ(counted::alive, 6);
    }
    EXPECT_EQ(counted::alive, 0);
}

TEST(storage, a_constructor_that_throws_leaves_nothing_behind)
{
    counted::throw_at = 2;
    EXPECT_THROW(storage<counted>(5), std::runtime_error);
    counted::throw_at = -1;
    EXPECT_EQ(counted::alive, 0);
}

TEST(storage, a_size_that_no_machine_has_is_refused)
{
    EXPECT_THROW(storage<double>(SIZE_MAX / 2), std::bad_alloc);
}
