// SPDX-License-Identifier: BSD-3-Clause
#include <kith/limit_surface.hpp>

#include "every_scheme.hpp"

#include <kith/hierarchy.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace {

using kith::hierarchy;
namespace targets = kith::targets;
using point = shapes::point;

double distance(const point& a, const point& b)
{
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// What becomes of a vertex, level by level: a vertex, an edge or a face, as docs/schemes.md says for each scheme.
struct descendant {
    char kind = 'v';
    std::size_t index = 0;
};

template <class Scheme>
descendant next_of_dual(const hierarchy<mesh3d, Scheme>& levels, int level, descendant d)
{
    const auto& here = levels.elements(level);
    const auto face = [&](const auto& x) { return descendant{'f', levels.assoc(level, x.handle(), targets::F).value}; };
    if (d.kind == 'f')
        return face(here.faces()[d.index]);
    if (d.kind == 'e') { // of the boundary: it has one face, and stays an edge of that
        const auto e = here.edges()[d.index];
        return {'e', levels.assoc(level, e.handle(), e.lface().handle(), targets::E).value};
    }
    const auto v = here.vertices()[d.index];
    const std::size_t k = v.face_count();
    if constexpr (std::same_as<Scheme, kith::mid_edge>) {
        return k == 1 ? face(v.first_corner().f()) : face(v);
    } else if constexpr (std::same_as<Scheme, kith::doo_sabin>) {
        if (not v.is_boundary())
            return face(v);
        if (levels.scheme(level).boundary == kith::doo_sabin_boundary::drop) {
            auto c = v.first_corner();
            for (std::size_t i = 1; i < (k + 1) / 2; ++i)
                c = c.prev().across();
            return k % 2 != 0 ? face(c.f()) : face(c.prev_edge());
        }
        if (k == 1)
            return {'v', levels.assoc(level, v.handle(), v.first_corner().f().handle(), targets::V).value};
        if (k == 2)
            return {'e', levels.assoc(level, v.handle(), v.first_corner().prev_edge().handle(), targets::E).value};
        return {'e', levels.assoc(level, v.handle(), targets::E).value};
    } else {
        return face(v);
    }
}
template <class Scheme>
descendant next(const hierarchy<mesh3d, Scheme>& levels, int level, descendant d)
{
    if constexpr (std::same_as<Scheme, kith::mid_edge> or std::same_as<Scheme, kith::doo_sabin>)
        return next_of_dual(levels, level, d);
    else if constexpr (std::same_as<Scheme, kith::unified>)
        if (not levels.scheme(level).is_primal())
            return next_of_dual(levels, level, d);
    if constexpr (not std::same_as<Scheme, kith::mid_edge> and not std::same_as<Scheme, kith::doo_sabin>)
        return {'v', levels.assoc(level, levels.elements(level).vertex_at(d.index), targets::V).value};
}

template <class Scheme>
point place(const hierarchy<mesh3d, Scheme>& levels, int level, descendant d)
{
    std::vector<std::size_t> vertices;
    const auto& here = levels.elements(level);
    if (d.kind == 'v')
        vertices.push_back(d.index);
    else if (d.kind == 'e')
        vertices = {here.edges()[d.index].org().index(), here.edges()[d.index].dst().index()};
    else
        for (const auto v : here.faces()[d.index].vertices())
            vertices.push_back(v.index());
    point result{};
    for (const std::size_t v : vertices)
        for (std::size_t i = 0; i < 3; ++i)
            result[i] += levels[level].point(v)[i] / double(vertices.size());
    return result;
}

/// Deeper levels come nearer, by this factor per step at least, where the limit is that of the deepest.
template <class Scheme>
struct depth_of {
    static constexpr int value = std::same_as<Scheme, kith::nasri_hasbini> ? 3
                                 : std::same_as<Scheme, kith::four_eight>  ? 8
                                                                           : 4;
};

void expect_unit(const kith::normal_vector& n)
{
    EXPECT_NEAR(std::hypot(n[0], n[1], n[2]), 1, 1e-15);
}

/// Of every vertex of levels 0 and 1: the limit is that of its descendant, and levels come near to it.
template <class Scheme>
void expect_limits(const mesh3d& control, const Scheme& scheme)
{
    constexpr int depth = depth_of<Scheme>::value;
    hierarchy levels(control, scheme);
    levels.refine(depth);
    std::vector<kith::limit_surface<point>> limits;
    for (int i = 0; i < 3; ++i)
        limits.push_back(limit_surface_of(levels, i));
    double size = 0;
    for (const auto& p : control.points())
        size = std::max(size, distance(p, control.point(0)));
    for (int from = 0; from < 2; ++from) {
        double early = 0, late = 0;
        for (std::size_t v = 0; v < levels[from].vertex_count(); ++v) {
            const point limit = limits[std::size_t(from)].positions[v];
            descendant d{'v', v};
            for (int i = from; i < depth; ++i) {
                d = next(levels, i, d);
                if (i + 1 <= 2 and d.kind == 'v') {
                    ASSERT_LT(distance(limits[std::size_t(i + 1)].positions[d.index], limit), 2e-14 * size)
                        << "vertex " << v << " of level " << from << " on level " << i + 1;
                }
                if (i == from)
                    early = std::max(early, distance(place(levels, i + 1, d), limit));
            }
            late = std::max(late, distance(place(levels, depth, d), limit));
        }
        // The slowest is a strip along a boundary, by 3/4 a step.
        EXPECT_LE(late, early * std::pow(0.78, depth - from - 1) + 1e-4 * size) << "of level " << from;
        for (const auto& n : limits[std::size_t(from)].normals)
            expect_unit(n);
    }
}

} // namespace

TEST(limit_surface, no_vertex_is_left_out_and_all_levels_agree)
{
    for_each_of_all_schemes_and_shape(
        []<class Scheme>(const Scheme& scheme, const mesh3d& mesh) { expect_limits(mesh, scheme); });
}
