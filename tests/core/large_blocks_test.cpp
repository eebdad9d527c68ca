// SPDX-License-Identifier: BSD-3-Clause
#include "support/under_sanitizers.hpp"

#include <kith/core/base/large_blocks.hpp>
#include <kith/core/base/storage.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <new>
#include <string>
#include <vector>

using kith::large_blocks;

namespace {

constexpr std::size_t mebibyte = std::size_t(1) << 20;

/// A test with its own large blocks, which keep freed blocks even under the sanitizers.
class large_blocks_test : public testing::Test {
protected:
    large_blocks_test() { blocks.keep_at_most(1024 * mebibyte); }
    ~large_blocks_test() override { blocks.keep_at_most(0); }

    large_blocks blocks;
};

} // namespace

TEST_F(large_blocks_test, a_freed_block_is_the_next_of_its_size)
{
    void* const first = blocks.allocate(16 * mebibyte);
    blocks.free(first, 16 * mebibyte);
    EXPECT_EQ(blocks.kept(), 16 * mebibyte);
    void* const second = blocks.allocate(16 * mebibyte - 100); // nearly: sizes are rounded
    EXPECT_EQ(second, first);
    EXPECT_EQ(blocks.kept(), 0U);
    blocks.free(second, 16 * mebibyte - 100);
}

TEST_F(large_blocks_test, the_same_work_once_more_gets_the_same_blocks)
{
    constexpr std::size_t bytes = std::size_t(1) << 17;
    const auto allocate_all = [&] {
        std::vector<void*> all;
        for (const std::size_t size : {bytes, 2 * bytes, bytes, bytes})
            all.push_back(blocks.allocate(size));
        return all;
    };
    const auto free_all = [&](const std::vector<void*>& all) {
        blocks.free(all[1], 2 * bytes);
        blocks.free(all[3], bytes);
        blocks.free(all[2], bytes);
        blocks.free(all[0], bytes);
    };
    const auto first = allocate_all();
    free_all(first);
    for (int again = 0; again < 3; ++again) {
        EXPECT_EQ(allocate_all(), first);
        free_all(first);
    }
}

TEST_F(large_blocks_test, all_start_at_a_huge_page_and_can_be_written)
{
    const std::size_t bytes = 5 * mebibyte + 3;
    auto* const block = static_cast<unsigned char*>(blocks.allocate(bytes));
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(block) % large_blocks::page, 0U);
    block[0] = block[bytes - 1] = 1;
    blocks.free(block, bytes);
}

TEST_F(large_blocks_test, blocks_below_a_huge_page_are_kept_too)
{
    constexpr std::size_t bytes = std::size_t(100) << 10;
    void* const first = blocks.allocate(bytes);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(first) % 64, 0U);
    blocks.free(first, bytes);
    EXPECT_GE(blocks.kept(), bytes);
    EXPECT_LE(blocks.kept(), bytes + bytes / 8);
    void* const second = blocks.allocate(bytes - 100);
    EXPECT_EQ(second, first);
    blocks.free(second, bytes - 100);
}

TEST_F(large_blocks_test, many_small_blocks_do_not_push_out_a_large_one)
{
    void* const large = blocks.allocate(64 * mebibyte);
    std::vector<void*> small(300);
    for (void*& block : small)
        block = blocks.allocate(large_blocks::smallest);
    for (void* const block : small)
        blocks.free(block, large_blocks::smallest);
    blocks.free(large, 64 * mebibyte);
    void* const again = blocks.allocate(64 * mebibyte);
    EXPECT_EQ(again, large);
    blocks.free(again, 64 * mebibyte);
}

TEST_F(large_blocks_test, another_size_gets_a_block_of_its_own)
{
    void* const first = blocks.allocate(64 * mebibyte);
    blocks.free(first, 64 * mebibyte);
    void* const second = blocks.allocate(8 * mebibyte);
    EXPECT_NE(second, first);
    EXPECT_EQ(blocks.kept(), 64 * mebibyte); // used and kept: at most an eighth more than was in use
    blocks.free(second, 8 * mebibyte);
}

TEST_F(large_blocks_test, more_in_use_than_ever_leaves_nothing_kept_beyond_it)
{
    void* const small = blocks.allocate(8 * mebibyte);
    void* const middle = blocks.allocate(16 * mebibyte);
    blocks.free(small, 8 * mebibyte);
    EXPECT_EQ(blocks.kept(), 8 * mebibyte);
    void* const large = blocks.allocate(64 * mebibyte);
    EXPECT_EQ(blocks.kept(), 0U);
    blocks.free(middle, 16 * mebibyte);
    blocks.free(large, 64 * mebibyte);
}

TEST_F(large_blocks_test, the_smallest_are_given_back_first)
{
    void* const a = blocks.allocate(8 * mebibyte);
    void* const b = blocks.allocate(64 * mebibyte);
    blocks.free(a, 8 * mebibyte);
    blocks.free(b, 64 * mebibyte);
    blocks.keep_at_most(70 * mebibyte);
    EXPECT_EQ(blocks.kept(), 64 * mebibyte);
}

TEST_F(large_blocks_test, keeps_no_more_than_it_is_told)
{
    blocks.keep_at_most(20 * mebibyte);
    void* const a = blocks.allocate(16 * mebibyte);
    void* const b = blocks.allocate(16 * mebibyte);
    blocks.free(a, 16 * mebibyte);
    blocks.free(b, 16 * mebibyte);
    EXPECT_EQ(blocks.kept(), 16 * mebibyte);
    blocks.keep_at_most(0);
    EXPECT_EQ(blocks.kept(), 0U);
}

TEST_F(large_blocks_test, what_no_machine_has_is_refused_and_forgotten)
{
    if (under_sanitizers)
        GTEST_SKIP() << "the sanitizers end the program where malloc would return nothing";
    void* const kept = blocks.allocate(8 * mebibyte);
    blocks.free(kept, 8 * mebibyte);
    EXPECT_THROW(static_cast<void>(blocks.allocate(SIZE_MAX / 4)), std::bad_alloc);
    void* const next = blocks.allocate(8 * mebibyte);
    void* const more = blocks.allocate(16 * mebibyte);
    blocks.free(next, 8 * mebibyte);
    blocks.free(blocks.allocate(32 * mebibyte), 32 * mebibyte); // more in use than ever
    EXPECT_EQ(blocks.kept(), 32 * mebibyte);
    blocks.free(more, 16 * mebibyte);
}

TEST(large_blocks, a_freed_block_is_kept_unless_the_sanitizers_watch_it)
{
    large_blocks blocks;
    blocks.free(blocks.allocate(8 * mebibyte), 8 * mebibyte);
    EXPECT_EQ(blocks.kept(), under_sanitizers ? 0 : 8 * mebibyte);
    blocks.keep_at_most(0);
}

TEST(advise_large_pages, what_has_been_written_stays)
{
    std::vector<unsigned char> bytes(5 * mebibyte);
    for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = static_cast<unsigned char>(i % 251);
    kith::advise_large_pages(bytes.data(), bytes.size());
    kith::advise_large_pages(bytes.data(), 1);
    kith::advise_large_pages(bytes.data(), 0);
    for (std::size_t i = 0; i < bytes.size(); ++i)
        ASSERT_EQ(bytes[i], i % 251);
}

std::size_t huge_bytes()
{
    std::ifstream maps("/proc/self/smaps");
    std::string word;
    std::size_t kibibytes = 0;
    while (maps >> word)
        if (std::size_t more = 0; word == "AnonHugePages:" and maps >> more)
            kibibytes += more;
    return kibibytes << 10;
}

TEST(reserve_in_large_pages, asks_for_them_where_something_is_mapped_meanwhile)
{
    std::vector<unsigned char> bytes, others;
    kith::reserve_in_large_pages([&] {
        bytes.reserve(64 * mebibyte);
        others.reserve(3 * mebibyte);
    });
    const std::size_t before = huge_bytes();
    bytes.resize(64 * mebibyte, 7);
    others.resize(3 * mebibyte, 9);
    EXPECT_TRUE(std::ranges::all_of(bytes, [](unsigned char byte) { return byte == 7; }));
    EXPECT_TRUE(std::ranges::all_of(others, [](unsigned char byte) { return byte == 9; }));
    EXPECT_THROW(kith::reserve_in_large_pages([] { throw std::bad_alloc(); }), std::bad_alloc);
    if (huge_bytes() == before)
        GTEST_SKIP() << "the system has no huge pages to give";
    EXPECT_GT(huge_bytes(), before);
}

TEST(reserve_in_large_pages, finds_the_memory_of_the_process)
{
    const std::vector<unsigned char> bytes(64 * mebibyte);
    const auto at = reinterpret_cast<std::uintptr_t>(bytes.data());
    const auto all = kith::detail::writable_memory();
    EXPECT_TRUE(std::ranges::is_sorted(all, {}, &kith::detail::memory_range::begin));
    EXPECT_TRUE(std::ranges::any_of(all, [&](const kith::detail::memory_range& range) {
        return range.begin <= at and at + bytes.size() <= range.end;
    }));
}

TEST(storage_in_large_blocks, a_large_array_is_given_back)
{
    kith::shared_blocks.keep_at_most(64 * mebibyte);
    const std::size_t before = kith::shared_blocks.kept();
    const char* where = nullptr;
    {
        const kith::storage<char> array(16 * mebibyte);
        where = array.data();
    }
    EXPECT_EQ(kith::shared_blocks.kept(), before + 16 * mebibyte);
    const kith::storage<char> again(16 * mebibyte);
    EXPECT_EQ(again.data(), where);
}
