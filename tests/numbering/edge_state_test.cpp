// SPDX-License-Identifier: BSD-3-Clause
#include <kith/core/mask/by_valence.hpp>
#include <kith/core/mask/choose.hpp>
#include <kith/core/mesh/make_mesh.hpp>
#include <kith/hierarchy.hpp>

#include "support/native_shape.hpp"
#include "support/same_mesh.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <vector>

namespace {

using point = std::array<double, 3>;

struct half {
    double operator()(double t) const { return t / 2; }
};

/// Linear subdivision of triangles with smoothed vertices and a tension on each edge. At tension 1 an edge point is the
/// midpoint of its edge, at tension 0 that of the two opposite corners. Each half of an edge gets half of the tension;
/// edges inside a face get none.
struct tense {
    using tensions = kith::field<kith::field_on::edges, double, kith::along_edges<half>>;
    tensions tension; // of the edges of this level, by e.index()

    static constexpr auto traits()
    {
        return kith::scheme_traits{.name = "tense", .faces = kith::face_shape::triangles, .state = &tense::tension};
    }
    static constexpr auto columns()
    {
        return kith::columns(kith::new_vertices(kith::per_vertex, kith::per_edge),
                             kith::new_faces(triangles(kith::per_corner), triangles(kith::per_face)),
                             kith::new_edges(kith::per_end, kith::per_corner)); // halves, and sides of the middle face
    }
    template <class R>
    void operator()(const R& r) const
    {
        using namespace kith::targets;
        const auto& [coarse, assoc, generation] = r;
        const auto pull = by_valence(r, [](std::size_t n) { return 1. / double(n + 1); });
        for_each(coarse.vertices(), [&](auto v) {
            if (v.is_boundary())
                assoc(v, V) = v;
            else
                assoc(v, V) = around(
                    v, v.neighbors(), pull, [](auto n, auto w, auto v, auto sum) { return (1 - w) * v + w / n * sum; });
        });
        for_each(coarse.edges(), [&](auto e) {
            const double t = tension.empty() ? 0 : tension[e.index()];
            const auto middle = average(e.org(), e.dst());
            assoc(e, V) = kith::choose(
                e.is_boundary(),
                [&] { return middle; },
                [&] { return t * middle + (1 - t) * average(e.lcorner().prev().v(), e.rcorner().prev().v()); });
        });
        for_each(coarse.corners(), [&](auto c) { // a line of a face: its vertex >> the side of the new edge from there
            const auto v = c.v();
            const auto next = c.next_edge(), prev = c.prev_edge();
            assoc(c, F) = polygon(assoc(v, V) >> assoc(v, next, E).along(next),
                                  assoc(next, V) >> assoc(c, E).left(),
                                  assoc(prev, V) >> assoc(v, prev, E).along(prev));
        });
        for_each(coarse.faces(), [&](auto f) {
            assoc(f, F) = polygon(f.corners(), [&](auto c) { return assoc(c.prev_edge(), V) >> assoc(c, E).right(); });
        });
    }
};

/// Returns a hierarchy of the tetrahedron with equal tension on all edges.
kith::hierarchy<mesh3d, tense> tetrahedron_with(double tension)
{
    const auto mesh = native(shapes::tetrahedron());
    tense scheme;
    scheme.tension = tense::tensions(std::vector<double>(mesh.edge_count(), tension));
    return kith::hierarchy(mesh, scheme);
}

} // namespace

TEST(edge_state, a_scheme_reads_it)
{
    for (const double t : {0., .25, 1.}) {
        auto levels = tetrahedron_with(t);
        levels.refine();
        for (const auto e : levels.elements(0).edges()) {
            const auto made = levels.assoc(0, e.handle(), kith::targets::V);
            const auto a = e.org().point(), b = e.dst().point();
            const auto c = e.lcorner().prev().v().point(), d = e.rcorner().prev().v().point();
            for (std::size_t i = 0; i < 3; ++i)
                EXPECT_DOUBLE_EQ(levels[1].point(made.value)[i], t * (a[i] + b[i]) / 2 + (1 - t) * (c[i] + d[i]) / 2);
        }
        // Vertex 0: 3/4 of itself and 1/4 of the mean of the three others.
        const auto& p = levels[0].points();
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_DOUBLE_EQ(levels[1].point(0)[i], .75 * p[0][i] + (p[1][i] + p[2][i] + p[3][i]) / 12);
    }
}

TEST(edge_state, halves_of_an_edge_inherit_and_edges_inside_faces_have_none)
{
    auto levels = tetrahedron_with(1);
    levels.refine(2);
    for (int level = 1; level <= 2; ++level) {
        std::size_t inside = 0;
        for (const auto e : levels.elements(level).edges()) {
            const auto from = levels.origin(level, e.handle());
            const double t = levels.scheme(level).tension[e.index()];
            if (from.f) {
                EXPECT_EQ(t, 0) << "edge " << e.index();
                ++inside;
            } else {
                EXPECT_EQ(t, levels.scheme(level - 1).tension[from.e->value] / 2) << "edge " << e.index();
            }
        }
        EXPECT_EQ(inside, 3 * levels[level - 1].face_count());
    }
}

TEST(edge_state, its_levels_have_the_connectivity_of_matched_edges)
{
    auto levels = tetrahedron_with(.5);
    levels.refine(2);
    const auto matched = kith::make_mesh(levels[2].points(), levels[2].faces());
    EXPECT_EQ(matched.edge_count(), levels[2].edge_count());
    EXPECT_TRUE(kith::validate(levels[2])) << kith::validate(levels[2]).text();
}
