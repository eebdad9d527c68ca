// SPDX-License-Identifier: BSD-3-Clause
#include <kith/core/mask/by_valence.hpp>

#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

TEST(weights_by_valence, give_the_weight_of_every_valence)
{
    const kith::weights_by_valence<float> weights([](std::size_t n) { return 1. / double(n); });
    for (const std::size_t n : {1U, 3U, 64U, 65U, 1000U})
        EXPECT_EQ(weights(n), float(1. / double(n)));
}

TEST(weights_by_valence, compute_the_usual_valences_once)
{
    int calls = 0;
    const kith::weights_by_valence<double> weights([&](std::size_t n) { return ++calls, double(n); });
    const int made = calls;
    for (std::size_t n = 3; n <= 64; ++n)
        EXPECT_EQ(weights(n), double(n));
    EXPECT_EQ(calls, made);
}

TEST(rows_by_valence, compute_what_is_asked_for_once)
{
    int calls = 0;
    const kith::rows_by_valence<float> rows([&](std::size_t n) { return ++calls, std::vector<double>(n, .1); });
    for (int i = 0; i < 2; ++i)
        for (const std::size_t n : {1U, 3U, 64U})
            EXPECT_EQ(rows(n)[n - 1], float(.1));
    EXPECT_EQ(calls, 3);
}

TEST(rows_by_valence, are_the_same_for_all_threads)
{
    std::atomic<int> calls = 0;
    const kith::rows_by_valence<double> rows([&](std::size_t n) { return ++calls, std::vector<double>(n, double(n)); });
    std::vector<std::thread> threads;
    std::atomic<int> wrong = 0;
    for (int t = 0; t < 4; ++t)
        threads.emplace_back([&] {
            for (std::size_t n = 1; n <= kith::longest_row; ++n)
                for (std::size_t j = 0; j < n; ++j)
                    wrong += rows(n)[j] != double(n);
        });
    for (auto& thread : threads)
        thread.join();
    EXPECT_EQ(wrong, 0);
    EXPECT_EQ(calls, int(kith::longest_row));
}
