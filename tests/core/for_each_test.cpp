// SPDX-License-Identifier: BSD-3-Clause
#include <kith/core/level/for_each.hpp>

#include "support/error_text.hpp"
#include "support/every_level.hpp"
#include "support/thread_count.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

TEST(for_each, visits_every_element_once)
{
    const auto mesh = native(shapes::torus(100, 100)); // large enough for threads
    const level_type level(mesh);
    std::vector<std::atomic<int>> visits(level.corner_count());
    kith::for_each(level.corners(), [&](auto c) { ++visits[c.index()]; });
    for (const auto& n : visits)
        ASSERT_EQ(n, 1);
}

TEST(for_each, visits_every_element_once_on_any_threads)
{
    const auto mesh = native(shapes::triangulated(shapes::torus(70, 70)));
    const level_type level(mesh);
    const auto expect_one_visit = [](const auto& range) {
        for (const int threads : {1, 2, 3, 5, 64, 70}) {
            const thread_count count(threads);
            std::vector<std::atomic<int>> visits(range.size());
            kith::for_each(range, [&](const auto& x) { ++visits[x.index()]; });
            for (const auto& n : visits)
                ASSERT_EQ(n, 1);
        }
    };
    expect_one_visit(level.vertices());
    expect_one_visit(level.edges());
    expect_one_visit(level.faces());
}

TEST(for_each, finds_nothing_in_a_mesh_without_elements)
{
    const mesh3d nothing;
    const level_type level(nothing);
    const auto fail = [](const auto&) { FAIL(); };
    kith::for_each(level.vertices(), fail);
    kith::for_each(level.edges(), fail);
    kith::for_each(level.faces(), fail);
    kith::for_each(level.corners(), fail);
}

TEST(for_each, an_error_in_a_body_reaches_the_caller)
{
    const auto mesh = native(shapes::torus(100, 100));
    const level_type level(mesh);
    EXPECT_THROW(kith::for_each(level.vertices(),
                                [](auto v) {
                                    if (v.index() % 1000 == 999)
                                        throw std::runtime_error("here");
                                }),
                 std::runtime_error);
}

TEST(for_each, of_several_errors_the_first_in_the_range_is_told)
{
    const thread_count four(4);
    for (int i = 0; i < 20; ++i)
        EXPECT_EQ(error_text<std::runtime_error>([] {
                      kith::detail::for_parts(10000, true, [](std::size_t begin, std::size_t) {
                          throw std::runtime_error(std::to_string(begin));
                      });
                  }),
                  "0");
}

namespace {

/// Returns the error of a loop in which parts fail on several threads.
std::string error_of_shared_parts()
{
    return error_text<std::runtime_error>([] {
        kith::detail::for_shared_parts(10000, 10, true, [](kith::detail::parts_to_do parts) {
            parts.for_each([](std::size_t begin, std::size_t) {
                if (begin == 3000 or (begin > 3000 and begin % 1000 == 990))
                    throw std::runtime_error(std::to_string(begin));
            });
        });
    });
}

} // namespace

TEST(for_each, of_several_errors_in_shared_parts_the_first_in_the_range_is_told)
{
    for (const int threads : {1, 2, 4}) {
        const thread_count count(threads);
        for (int i = 0; i < 20; ++i)
            EXPECT_EQ(error_of_shared_parts(), "3000");
    }
}

TEST(for_each, of_several_errors_the_first_is_told_inside_a_loop_on_threads_too)
{
    const thread_count four(4);
    std::vector<std::string> errors(4);
    kith::detail::for_parts(
        errors.size(),
        true,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                errors[i] = error_of_shared_parts(); // here one thread does the parts of four threads
        },
        1);
    EXPECT_EQ(errors, std::vector<std::string>(4, "3000"));
}

TEST(for_each, shared_parts_are_done_once_by_whoever_is_free)
{
    for (const int threads : {1, 2, 3, 7}) {
        const thread_count count(threads);
        for (const std::size_t size : {0U, 1U, 10U, 11U, 10007U}) {
            std::vector<std::atomic<int>> visits(size);
            kith::detail::for_shared_parts(size, 10, true, [&](kith::detail::parts_to_do parts) {
                parts.for_each([&](std::size_t begin, std::size_t end) {
                    EXPECT_LE(end - begin, 10);
                    for (std::size_t i = begin; i < end; ++i)
                        ++visits[i];
                    // The thread with the first part waits until all other parts are done. These must not wait for it.
                    const auto left = [&] {
                        return std::ranges::count_if(visits, [](const auto& n) { return n == 0; });
                    };
                    while (begin == 0 and left() != 0 and threads > 1 and size > 10)
                        std::this_thread::yield();
                });
            });
            for (const auto& n : visits)
                ASSERT_EQ(n, 1);
        }
    }
}

TEST(for_each, parts_are_ranges_without_gaps)
{
    for (const std::size_t size : {0U, 1U, 4096U, 10007U}) {
        std::vector<std::atomic<int>> visits(size);
        kith::detail::for_parts(size, true, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                ++visits[i];
        });
        for (const auto& n : visits)
            ASSERT_EQ(n, 1);
    }
}

namespace {

/// Returns the number of parts of a loop.
std::size_t parts_of_loop(std::size_t size)
{
    std::atomic<std::size_t> parts = 0;
    kith::detail::for_parts(size, true, [&](std::size_t, std::size_t) { ++parts; });
    return parts;
}

#if defined(_OPENMP)
constexpr std::size_t most = 4;
#else
constexpr std::size_t most = 1;
#endif

} // namespace

TEST(for_each, a_program_says_how_many_threads_it_has)
{
    const thread_count four(4);
    EXPECT_EQ(parts_of_loop(100'000), most);
    kith::set_threads(1);
    EXPECT_EQ(parts_of_loop(100'000), 1U);
    kith::set_threads(3);
    EXPECT_EQ(parts_of_loop(100'000), std::min<std::size_t>(most, 3));
    kith::set_threads(0);
    EXPECT_EQ(parts_of_loop(100'000), most);
}

TEST(for_each, levels_of_fewer_than_ten_thousand_faces_are_made_by_one_thread)
{
    const thread_count four(4);
    kith::detail::faces_worth_threads = 10'000; // the default value in programs
    const auto threads_at = [](const kith::basic_mesh<std::array<double, 3>>& mesh) {
        const level_type level(mesh);
        std::mutex mutex;
        std::set<std::thread::id> met;
        const auto meet = [&](const auto&) {
            const std::lock_guard lock(mutex);
            met.insert(std::this_thread::get_id());
        };
        kith::for_each(level.vertices(), meet);
        kith::for_each(level.edges(), meet);
        kith::for_each(level.faces(), meet);
        kith::for_each(level.corners(), meet);
        return met.size();
    };
    EXPECT_EQ(threads_at(native(shapes::torus(99, 101))), 1U);
    EXPECT_EQ(threads_at(native(shapes::torus(100, 101))), most);
}
