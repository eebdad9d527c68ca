// SPDX-License-Identifier: BSD-3-Clause
#include <kith/engine/refine_in_surface_order.hpp>

#include <kith/refine.hpp>

#include "support/every_scheme.hpp"
#include "support/forced_way.hpp"
#include "support/refined_by_levels.hpp"
#include "support/same_mesh.hpp"
#include "support/thread_count.hpp"
#include "support/under_sanitizers.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

using kith::connect;

template <class Scheme>
constexpr bool is_orderable = kith::orderable_scheme<Scheme, std::uint32_t>;

/// Returns a mesh that is large enough to count as scattered.
mesh3d scattered_torus()
{
    return native(shapes::shaken(shapes::shuffled(shapes::triangulated(shapes::torus(64, 64)), 7)));
}
mesh3d scattered_grid()
{
    return native(shapes::shaken(shapes::shuffled(shapes::triangulated(shapes::grid(64, 64)), 7)));
}

TEST(refine_in_surface_order, makes_the_same_bits)
{
    std::size_t compared = 0;
    for_each_of_all_schemes_and_shape([&](const auto& scheme, const mesh3d& mesh) {
        using scheme_type = std::remove_cvref_t<decltype(scheme)>;
        if constexpr (is_orderable<scheme_type>) {
            const bool closed = count(mesh.topology()).boundary_edges == 0;
            if (not kith::detail::is_free_of_order<scheme_type>(closed))
                return;
            const forced_way_here forced(kith::refinement_way::in_surface_order);
            for (const int levels : {2, 3})
                for (const connect last : {connect::faces, connect::everything}) {
                    EXPECT_EQ(strategy_of(mesh, scheme, levels, {.last_level = last}).way,
                              kith::refinement_way::in_surface_order);
                    EXPECT_TRUE(same_bits(refine(mesh, scheme, levels, {.last_level = last}),
                                          refined_by_levels(mesh, scheme, levels, last)))
                        << levels;
                }
            ++compared;
        }
    });
    EXPECT_GT(compared, 50U);
}

TEST(refine_in_surface_order, is_what_refine_does_with_a_scattered_mesh)
{
    const auto expect_same = [](const mesh3d& mesh, const auto& scheme, int levels = 3, connect last = connect::faces) {
        ASSERT_TRUE(is_worth_ordering(mesh, scheme, levels, last));
        const auto given = refined_by_levels(mesh, scheme, levels, last);
        for (const int threads : under_sanitizers ? std::vector{3} : std::vector{1, 2, 3, 7}) {
            const thread_count count(threads);
            EXPECT_TRUE(same_bits(refine(mesh, scheme, levels, {.last_level = last}), given)) << threads;
        }
    };
    expect_same(scattered_torus(), kith::catmull_clark{});
    expect_same(scattered_grid(), kith::loop{});
    if (under_sanitizers) // the closed and the open mesh before cover all branches
        return;
    expect_same(scattered_torus(), kith::sqrt3{});
    expect_same(scattered_torus(), kith::butterfly{});
    expect_same(scattered_torus(), kith::sqrt3{}, 5, connect::everything);
    expect_same(scattered_grid(), kith::catmull_clark{.corners = kith::boundary_corner::smoothed, .sharpness = {}});
}

/// Returns true if the order of the surface is a gain for a level that is large enough.
template <class Scheme>
bool gains_by_order(const kith::connectivity<std::uint32_t>& control, const Scheme& scheme, int levels)
{
    return can_be_ordered(control, scheme, levels) and is_scattered(control);
}

TEST(refine_in_surface_order, is_left_out_where_it_would_be_wrong_or_of_no_use)
{
    const auto torus = scattered_torus(), grid = scattered_grid();
    EXPECT_FALSE(gains_by_order(torus.topology(), kith::loop{}, 1));
    // Levels must be large for a gain; larger if they have all connectivity.
    EXPECT_FALSE(is_worth_ordering(torus, kith::loop{}, 2, connect::faces));
    EXPECT_TRUE(is_worth_ordering(torus, kith::loop{}, 3, connect::faces));
    EXPECT_FALSE(is_worth_ordering(torus, kith::loop{}, 3, connect::everything));
    EXPECT_TRUE(is_worth_ordering(torus, kith::loop{}, 4, connect::everything));
    EXPECT_FALSE(gains_by_order(native(shapes::torus(60, 60)).topology(), kith::catmull_clark{}, 2));
    // The columns of sqrt(3) depend on the boundary, and creases are stored by edge numbers.
    EXPECT_FALSE(gains_by_order(grid.topology(), kith::sqrt3{}, 2));
    kith::loop creased;
    creased.sharpness.sharpen_edge(0, 2.);
    EXPECT_FALSE(gains_by_order(torus.topology(), creased, 2));
    EXPECT_TRUE(same_bits(refine(torus, creased, 2, {.last_level = connect::faces}),
                          refined_by_levels(torus, creased, 2, connect::faces)));
    // Doo-Sabin makes faces of several degrees; 4-8 has columns of marked edges.
    static_assert(not is_orderable<kith::doo_sabin> and not is_orderable<kith::four_eight>);
}

TEST(refine_in_surface_order, is_left_out_where_memory_is_short)
{
    const auto mesh = scattered_torus();
    const auto levels = plan(count(mesh.topology()), kith::loop{}, 3);
    const std::uint64_t least = peak_bytes(levels, false, true);
    const auto given = refined_by_levels(mesh, kith::loop{}, 3, connect::faces);
    for (const std::uint64_t limit : {least, 2 * least})
        EXPECT_TRUE(same_bits(refine(mesh, kith::loop{}, 3, {connect::faces, limit}), given));
}

} // namespace
