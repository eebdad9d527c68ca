// SPDX-License-Identifier: BSD-3-Clause
#include <kith/numbering/step/rules.hpp>

#include <kith/core/mask/by_valence.hpp>
#include <kith/schemes/split/quad_split.hpp>
#include <kith/schemes/split/triangle_split.hpp>

#include "support/all_shapes.hpp"
#include "support/native_shape.hpp"
#include "support/same_mesh.hpp"

#include <kith/hierarchy.hpp>
#include <kith/refine.hpp>

#include <gtest/gtest.h>

#include <cstddef>

using namespace kith::targets;

namespace {

/// A user-defined scheme with explicit loops and pairs of weights for the vertices.
struct by_loops {
    static constexpr auto columns() { return kith::quad_split::columns(); }
    template <class R>
    void operator()(const R& r) const
    {
        const auto& [coarse, assoc, generation] = r;
        for_each(coarse.faces(), [&](auto f) { assoc(f, V) = average(f.vertices()); });
        for_each(coarse.edges(), [&](auto e) {
            if (e.is_boundary())
                assoc(e, V) = average(e.org(), e.dst());
            else
                assoc(e, V) = 1. / 4 * (e.org() + e.dst() + assoc(e.lface(), V) + assoc(e.rface(), V));
        });
        for_each(coarse.vertices(), [&](auto v) {
            const double n = double(v.valence()), c = 1 / (3 + n);
            assoc(v, V) = (1 - n * c) * v + c * sum(v.neighbors());
        });
        kith::quad_split::connect(r);
    }
};

/// The scheme of by_loops, written as rules on the split.
struct by_rules {
    static constexpr auto columns() { return kith::quad_split::columns(); }
    template <class R>
    void operator()(const R& r) const
    {
        const auto& [coarse, assoc, generation] = r;
        const auto weights = by_valence(r, [](std::size_t n) { return 1 / (3 + double(n)); });
        for_each(coarse.faces(), [&](auto f) { assoc(f, V) = average(f.vertices()); });
        const auto inner = kith::at_edges([&](auto e) {
            if (not e.is_boundary())
                assoc(e, V) = 1. / 4 * (e.org() + e.dst() + assoc(e.lface(), V) + assoc(e.rface(), V));
        });
        const auto outer = kith::at_edges([&](auto e) {
            if (e.is_boundary())
                assoc(e, V) = average(e.org(), e.dst());
        });
        const auto vertices = kith::at_vertices([&](auto v) {
            const auto formula = [](auto n, auto c, auto v, auto sum) { return (1 - n * c) * v + c * sum; };
            return around(v, v.neighbors(), weights, formula);
        });
        kith::subdivide(kith::quad_split(), r, vertices, inner, outer.when(not coarse.is_closed()));
    }
};

/// A scheme whose rule of edges is switched off, so that edge points are missing.
struct without_edges {
    static constexpr auto columns() { return kith::triangle_split::columns(); }
    template <class R>
    void operator()(const R& r) const
    {
        const auto midpoints = kith::at_edges([](auto e) { return average(e.org(), e.dst()); });
        kith::subdivide(kith::triangle_split(), r, kith::at_vertices([](auto v) { return v; }), midpoints.when(false));
    }
};

} // namespace

TEST(rules, are_the_same_as_loops_on_every_level)
{
    for (const auto& shape : {shapes::torus(10, 12), shapes::grid(5, 9), shapes::house(), shapes::tetrahedron()}) {
        const auto mesh = native(shapes::shaken(shape));
        EXPECT_TRUE(same_bits(kith::refine(mesh, by_rules(), 4), kith::refine(mesh, by_loops(), 4)));
        kith::hierarchy levels(mesh, by_rules());
        levels.refine(4);
        EXPECT_TRUE(same_bits(levels.finest(), kith::refine(mesh, by_loops(), 4)));
    }
}

TEST(rules, hold_only_under_their_condition)
{
    EXPECT_THROW(kith::refine(native(shapes::tetrahedron()), without_edges(), 1), kith::association_error);
}

TEST(rules, around_is_the_formula_that_it_is_given)
{
    const auto mesh = native(shapes::shaken(shapes::grid(3, 3)));
    const kith::level_of<mesh3d> level(mesh);
    const kith::point_values<kith::level_of<mesh3d>> values;
    for (const auto v : level.vertices()) {
        const double n = double(v.valence());
        const auto mask = around(
            v, v.neighbors(), [](auto n, auto v, auto sum) { return (n - 2) / n * v + 1 / (n * n) * sum - 3. * v; });
        EXPECT_EQ(mask.evaluate(values),
                  ((n - 2) / n * v + 1 / (n * n) * sum(v.neighbors()) - 3. * v).evaluate(values));
    }
}
