// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/engine/refinement_run.hpp>

#include "thread_count.hpp"
#include "written_level.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <utility>

/// Costs that enforce patches wherever possible, with a template for every class of faces.
inline constexpr kith::strategy_costs all_templates = kith::strategy_costs::of_templates_for_all();

/// Returns these costs with another cost of a template, so that only large classes have templates, or none.
constexpr kith::strategy_costs with_cost_of_template(double cost)
{
    auto costs = all_templates;
    costs.of_template = cost;
    return costs;
}
inline constexpr kith::strategy_costs some_templates = with_cost_of_template(300);

/// Returns the last level, made in patches. Expects that the costs favour patches.
template <class Point, class Index, class Scheme>
kith::basic_mesh<Point, Index> made_by_patches(kith::basic_mesh<Point, Index> mesh, Scheme scheme, int levels,
                                               kith::connect last, const kith::strategy_costs& costs)
{
    kith::native_last_level<Point, Index> made(last);
    EXPECT_TRUE(kith::refinement_run(std::move(mesh), scheme, levels, costs).make_in_patches(made));
    return made.take();
}
/// Returns the last level, made in patches by one thread and written into a stand-in for another library's mesh.
template <class Point, class Index, class Scheme>
kith::basic_mesh<Point, Index> written_by_patches(kith::basic_mesh<Point, Index> mesh, Scheme scheme, int levels,
                                                  const kith::strategy_costs& costs)
{
    const thread_count one(1);
    written_level<Point, Index> written;
    kith::written_last_level<Point, Index> last(written);
    EXPECT_TRUE(kith::refinement_run(std::move(mesh), scheme, levels, costs).make_in_patches(last));
    return written.take();
}
