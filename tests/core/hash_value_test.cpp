// SPDX-License-Identifier: BSD-3-Clause
#include <kith/core/mask/hash_value.hpp>

#include "support/every_scheme.hpp"
#include "support/hashes.hpp"
#include "support/thread_count.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

using kith::hash_value;

namespace {

/// Returns the shape with its faces in another order, each beginning with another corner.
shapes::shape shuffled(shapes::shape s, std::uint32_t seed)
{
    std::minstd_rand random(seed);
    std::ranges::shuffle(s.faces, random);
    for (auto& f : s.faces)
        std::ranges::rotate(f, f.begin() + std::ptrdiff_t(random() % f.size()));
    return s;
}

hash_value sum(hash_value a, hash_value b)
{
    kith::affine<hash_value>::add(a, b);
    return a;
}
hash_value scaled(hash_value a, double weight)
{
    kith::affine<hash_value>::scale(a, weight);
    return a;
}

} // namespace

TEST(hash_value, sums_know_the_order_of_their_operands)
{
    const hash_value a{1}, b{2}, c{3};
    EXPECT_NE(sum(a, b), sum(b, a));
    EXPECT_NE(sum(sum(a, b), c), sum(a, sum(b, c)));
    EXPECT_EQ(sum(a, b), sum(a, b));
}

TEST(hash_value, products_know_the_last_bit_of_a_weight)
{
    EXPECT_NE(scaled({1}, 0.3), scaled({1}, 0.1 + 0.2));
    EXPECT_NE(scaled(sum({1}, {2}), 0.5), sum(scaled({1}, 0.5), scaled({2}, 0.5)));
    EXPECT_NE(scaled({1}, 1), (hash_value{1}));
}

TEST(hash_value, mixing_is_a_bijection)
{
    std::set<std::uint64_t> images;
    for (std::uint64_t x = 0; x < 10000; ++x)
        images.insert(kith::mix_bits(x));
    EXPECT_EQ(images.size(), 10000U);
}

TEST(hash_value, different_masks_have_different_hashes)
{
    const auto mesh = native(shapes::shaken(shapes::torus(6, 6)));
    auto all = hashes(mesh, kith::catmull_clark(), 3);
    EXPECT_EQ(std::ranges::adjacent_find(all), all.end());
    EXPECT_NE(all, hashes(mesh, kith::linear(), 3));
}

TEST(hash_value, the_order_of_faces_and_of_their_corners_changes_no_operation)
{
    const auto same = [](const auto& shapes, const auto&... schemes) {
        for (const auto& [name, shape] : shapes)
            for (const std::uint32_t seed : {1U, 2U, 3U}) {
                SCOPED_TRACE(name);
                const auto original = native(shape), other = native(shuffled(shape, seed));
                EXPECT_TRUE(((hashes(other, schemes, 2) == hashes(original, schemes, 2)) and ...));
            }
    };
    same(shapes::all_shapes(), kith::catmull_clark());
    same(shapes::triangle_shapes(), kith::loop(), kith::sqrt3());
}

TEST(hash_value, the_number_of_threads_changes_no_operation)
{
    const auto mesh = native(shapes::shaken(shapes::grid(40, 50)));
    const auto triangles = native(shapes::triangulated(shapes::shaken(shapes::grid(40, 50))));
    const auto all = [&](int count) {
        const thread_count here(count);
        return std::vector{hashes(mesh, kith::catmull_clark(), 2),
                           hashes(mesh, kith::doo_sabin(), 2),
                           hashes(triangles, kith::loop(), 2),
                           hashes(triangles, kith::sqrt3(), 2)};
    };
    const auto by_one = all(1);
    for (const int count : {2, 3, 7})
        EXPECT_EQ(all(count), by_one);
}
