// SPDX-License-Identifier: BSD-3-Clause
#include <kith/schemes/kernel/large_rings.hpp>

#include "support/large_shapes.hpp"
#include "support/native_shape.hpp"

#include <kith/butterfly.hpp>
#include <kith/doo_sabin.hpp>
#include <kith/hierarchy.hpp>
#include <kith/interpolatory_sqrt3.hpp>
#include <kith/kobbelt.hpp>
#include <kith/nasri_hasbini.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace {

using namespace kith::targets;
using level = kith::level_of<mesh3d>;
using level_vertex = kith::vertex<level>;
using row = std::map<std::size_t, double>; // weights by vertex

shapes::point combine(const mesh3d& mesh, const row& weights)
{
    shapes::point result{};
    for (const auto& [v, weight] : weights)
        for (int i = 0; i < 3; ++i)
            result[i] += weight * mesh.point(v)[i];
    return result;
}

void expect_near(const shapes::point& a, const shapes::point& b)
{
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(a[i], b[i], 1e-13);
}

/// Calls test(mesh, level, levels) with one step by a scheme.
template <class Scheme, class Test>
void refine_once(const shapes::shape& shape, const Scheme& scheme, const Test& test)
{
    const auto mesh = native(shape);
    kith::hierarchy levels(mesh, scheme);
    levels.refine();
    test(mesh, levels.elements(0), [&](const auto&... tuple) {
        return levels[1].point(levels.assoc(0, tuple.handle()..., V).value);
    });
}

constexpr std::size_t on_both_sides[] = {kith::longest_row, kith::longest_row + 1, 98};

/// Returns the weights of a point at an inner vertex by the rule of docs/schemes.md.
row ternary_row(const level_vertex& v, std::size_t i, kith::ternary_point point)
{
    using kith::ternary_point;
    std::vector<kith::corner<level>> ring;
    for (const auto c : v.corners())
        ring.push_back(c);
    const std::size_t n = ring.size();
    const auto is_special = [&](std::size_t j) {
        return ring[j].f().degree() != 4 and
               (point == ternary_point::vertex or j == i or (point == ternary_point::edge and (j + 1) % n == i));
    };
    double specials = 0;
    for (std::size_t j = 0; j < n; ++j)
        specials += is_special(j) ? 1 : 0;
    row result;
    std::vector<double> block(n, 0);
    if (specials == 0)
        result[v.index()] += kith::center_weight(point);
    for (std::size_t j = 0; j < n; ++j) {
        const std::size_t steps = (j + n - i) % n, before = (j + n - 1) % n;
        const double e = kith::neighbor_weight(point, steps, n), d = kith::opposite_weight(point, steps, n);
        const double sharing = int(is_special(j)) + int(is_special(before));
        if (sharing == 0)
            result[ring[j].next().v().index()] += e;
        if (is_special(before))
            block[before] += e / sharing;
        if (is_special(j)) {
            block[j] += kith::center_weight(point) / specials + e / sharing + d;
            continue;
        }
        const std::size_t m = ring[j].f().degree();
        std::size_t k = 0;
        for (const auto u : ring[j].vertices_from_here()) {
            result[u.index()] += d * (m == 4 ? k == 2 : kith::diagonal_weight(k, m));
            ++k;
        }
    }
    for (std::size_t j = 0; j < n; ++j)
        if (is_special(j)) {
            const std::size_t m = ring[j].f().degree();
            const bool mirrored = point == ternary_point::edge and j != i;
            std::size_t k = 0;
            for (const auto u : ring[j].vertices_from_here()) {
                result[u.index()] += block[j] * kith::polygon_weight(point, mirrored ? (m - k) % m : k, m);
                ++k;
            }
        }
    for (auto& [vertex, weight] : result)
        weight /= 729;
    return result;
}

void expect_ternary(const shapes::shape& shape)
{
    refine_once(shape, kith::nasri_hasbini(), [](const auto& mesh, const auto& coarse, const auto& point) {
        for (const auto v : coarse.vertices()) {
            using kith::ternary_point;
            expect_near(point(v), combine(mesh, ternary_row(v, 0, ternary_point::vertex)));
            std::size_t i = 0;
            for (const auto c : v.corners()) {
                if ((v.valence() < 10 and v.index() % 5 == 0) or i % 7 == 0) {
                    expect_near(point(v, c.next_edge()), combine(mesh, ternary_row(v, i, ternary_point::edge)));
                    expect_near(point(v, c.f()), combine(mesh, ternary_row(v, i, ternary_point::face)));
                }
                ++i;
            }
        }
    });
}

} // namespace

TEST(large_rings, doo_sabin_is_that_of_its_weights)
{
    for (const std::size_t n : on_both_sides)
        for (const auto weights : {kith::doo_sabin_weights::cosine, kith::doo_sabin_weights::averaging}) {
            const kith::doo_sabin scheme{.boundary = kith::doo_sabin_boundary::drop, .weights = weights};
            refine_once(shapes::prism(n), scheme, [&](const auto& mesh, const auto& coarse, const auto& point) {
                for (const auto c : coarse.corners()) {
                    row r;
                    std::size_t j = 0;
                    for (const auto u : c.vertices_from_here())
                        r[u.index()] += scheme.weight(j++, c.f().degree());
                    expect_near(point(c.v(), c.f()), combine(mesh, r));
                }
            });
        }
}

TEST(large_rings, butterfly_is_that_of_its_weights)
{
    for (const std::size_t n : on_both_sides)
        refine_once(
            shapes::double_pyramid(n), kith::butterfly(), [&](const auto& mesh, const auto& coarse, const auto& point) {
                const auto weights = kith::butterfly::ring_weights(n);
                for (const auto c : coarse.vertices()[n].corners()) {
                    row r{{n, 3. / 4}};
                    std::size_t j = 0;
                    for (const auto u : c.neighbors_from_here())
                        r[u.index()] += weights[j++];
                    const auto other = c.across(); // of valence 4
                    r[other.v().index()] += 3. / 4;
                    for (j = 0; const auto u : other.neighbors_from_here())
                        r[u.index()] += kith::butterfly::ring_weights(4)[j++];
                    for (auto& [vertex, weight] : r)
                        weight /= 2;
                    expect_near(point(c.next_edge()), combine(mesh, r));
                }
            });
}

TEST(large_rings, interpolatory_sqrt3_is_that_of_its_weights)
{
    for (const std::size_t n : on_both_sides)
        refine_once(shapes::double_pyramid(n),
                    kith::interpolatory_sqrt3(),
                    [&](const auto& mesh, const auto& coarse, const auto& point) {
                        for (const auto f : coarse.faces()) {
                            row r;
                            for (const auto c : f.corners()) {
                                const std::size_t valence = c.v().valence();
                                const auto weights = kith::interpolatory_sqrt3::ring_weights(valence);
                                r[c.v().index()] += kith::interpolatory_sqrt3::center_weight(valence) / 3;
                                std::size_t j = 0;
                                for (const auto u : c.prev().across().neighbors_from_here())
                                    r[u.index()] += weights[j++] / 3;
                            }
                            expect_near(point(f), combine(mesh, r));
                        }
                    });
}

TEST(large_rings, kobbelt_is_that_of_its_weights)
{
    const auto add_beyond = [](row& r, const kith::corner<level>& c) { // the vertex of c, where no line goes on
        const double gamma = 1. / 9, n = double(c.v().valence());
        std::vector<kith::corner<level>> ring;
        for (const auto d : c.fan_from_here()) {
            ring.push_back(d);
            r[d.next().v().index()] -= 4 / n / 16;
            r[d.next().next().v().index()] += gamma * 4 / n / 16;
        }
        const std::size_t size = ring.size();
        for (const std::size_t j : {size - 1, size, size + 1})
            r[ring[j % size].next().v().index()] += 1. / 16;
        for (const std::size_t j : {2 * size - 2, 2 * size - 1, 2 * size, 2 * size + 1})
            r[ring[j % size].next().next().v().index()] -= gamma / 16;
    };
    for (const std::size_t n : on_both_sides)
        refine_once(
            shapes::quads_around(n), kith::kobbelt(), [&](const auto& mesh, const auto& coarse, const auto& point) {
                for (const auto e : coarse.edges()) {
                    row r{{e.org().index(), 9. / 16}, {e.dst().index(), 9. / 16}};
                    add_beyond(r, e.lcorner());
                    add_beyond(r, e.rcorner());
                    expect_near(point(e), combine(mesh, r));
                }
            });
}

TEST(large_rings, nasri_hasbini_is_that_of_its_weights)
{
    for (const std::size_t n : on_both_sides) {
        expect_ternary(shapes::prism(n));
        expect_ternary(shapes::double_pyramid(n));
        expect_ternary(shapes::quads_around(n));
    }
    expect_ternary(shapes::triangles_and_quads_around(100));
}

TEST(large_rings, nasri_hasbini_takes_large_faces_at_the_boundary)
{
    constexpr std::size_t n = 100;
    refine_once(
        shapes::polygon(n), kith::nasri_hasbini(), [&](const auto& mesh, const auto& coarse, const auto& point) {
            for (const auto c : coarse.corners()) {
                row r;
                std::size_t k = 0;
                for (const auto u : c.vertices_from_here())
                    r[u.index()] += kith::diagonal_weight(k++, n) / 9;
                r[c.v().index()] += 4. / 9;
                r[c.next().v().index()] += 2. / 9;
                r[c.prev().v().index()] += 2. / 9;
                expect_near(point(c.v(), c.f()), combine(mesh, r));
            }
        });
}
