// SPDX-License-Identifier: BSD-3-Clause
#include <kith/limits/limit.hpp>

#include "support/every_scheme.hpp"

#include <kith/hierarchy.hpp>

#include <gtest/gtest.h>

#include <concepts>
#include <cstddef>

namespace {

using kith::hierarchy;
namespace targets = kith::targets;

template <class Scheme>
constexpr bool has_vertices_of_vertices = not std::same_as<Scheme, kith::doo_sabin> and
                                          not std::same_as<Scheme, kith::mid_edge>;
template <class Scheme>
bool keeps_vertices(const Scheme& scheme)
{
    if constexpr (std::same_as<Scheme, kith::unified>)
        return scheme.is_primal();
    else
        return true;
}

/// Expects each limit of `coarse` to equal the limit of `fine` at child(i). Returns the number of compared limits.
template <class Limits>
std::size_t expect_same(const Limits& coarse, const Limits& fine, const auto& child)
{
    std::size_t count = 0;
    for (std::size_t v = 0; v < coarse.size(); ++v) {
        if (not coarse[v])
            continue;
        const auto& later = fine[child(v)];
        EXPECT_TRUE(later) << "element " << v;
        for (std::size_t i = 0; later and i < 3; ++i)
            EXPECT_NEAR((*coarse[v])[i], (*later)[i], 1e-12) << "element " << v;
        ++count;
    }
    return count;
}

/// Returns the limits without those of boundary vertices, which belong to no face.
auto inner(const auto& level, auto limits)
{
    for (const auto v : level.vertices())
        if (v.is_boundary())
            limits[v.index()].reset();
    return limits;
}

/// Expects upright normals around vertices of all valences in a plane.
template <class Scheme>
void expect_upright(const Scheme& scheme)
{
    std::size_t known = 0;
    for (std::size_t n = 3; n < 10; ++n) {
        auto shape = shapes::umbrella(n);
        for (auto& p : shape.points)
            p[2] = 0;
        auto plane = kith::refine(native(shape), kith::linear_triangles(), 1);
        if (kith::needs_quads<Scheme>)
            plane = kith::refine(plane, kith::linear(), 1);
        if (std::same_as<Scheme, kith::four_eight>)
            plane = kith::tri_quad(plane);
        hierarchy levels(plane, scheme);
        levels.refine(3);
        for (const auto& normal : limit_normals(levels.elements(3), levels.scheme(3)))
            if (normal) {
                EXPECT_NEAR((*normal)[2], 1, 1e-15) << kith::scheme_name<Scheme>() << ", valence " << n;
                ++known;
            }
    }
    EXPECT_GT(known, 100U) << kith::scheme_name<Scheme>();
}

/// Compares the limits of vertices with those of their children, for all schemes for which `limits(elements, scheme)`
/// exists. Returns the number of compared vertices.
template <class Limits>
std::size_t compare_with_children(const Limits& limits)
{
    std::size_t known = 0;
    for_each_of_all_schemes_and_shape([&]<class Scheme>(const Scheme& scheme, const mesh3d& mesh) {
        if constexpr (requires(hierarchy<mesh3d, Scheme> levels) { limits(levels.elements(0), scheme); } and
                      has_vertices_of_vertices<Scheme>) {
            if (not keeps_vertices(scheme))
                return;
            constexpr int depth = std::same_as<Scheme, kith::four_eight> ? 4 : 2; // a step of 4-8 is half a step
            hierarchy levels(mesh, scheme);
            levels.refine(depth);
            for (int i = 0; i < depth; ++i)
                known += expect_same(
                    limits(levels.elements(i), levels.scheme(i)),
                    limits(levels.elements(i + 1), levels.scheme(i + 1)),
                    [&](std::size_t v) { return levels.assoc(i, levels.elements(i).vertex_at(v), targets::V).value; });
        }
    });
    return known;
}

} // namespace

TEST(limit_levels, every_level_has_the_same_for_a_vertex_and_its_child)
{
    const auto positions = []<class Level, class Scheme>(const Level& level, const Scheme& scheme)
        requires kith::has_limit_positions<Scheme, kith::vertex<Level>, Level>
    { return limit_positions(level, scheme); };
    EXPECT_GT(compare_with_children(positions), 10000U);
}

TEST(limit_levels, every_level_has_the_same_normal_for_a_vertex_and_its_child)
{
    const auto normals = []<class Level, class Scheme>(const Level& level, const Scheme& scheme)
        requires kith::has_limit_tangents<Scheme, kith::vertex<Level>, Level>
    { return limit_normals(level, scheme); };
    EXPECT_GT(compare_with_children(normals), 10000U);
}

TEST(limit_levels, of_doo_sabin_is_handed_from_vertices_and_faces_to_faces)
{
    std::size_t known = 0;
    for_each_scheme_and_shape([&known]<class Scheme>(const Scheme& scheme, const mesh3d& mesh) {
        if constexpr (std::same_as<Scheme, kith::doo_sabin>) {
            hierarchy levels(mesh, scheme);
            levels.refine(2);
            for (int i = 0; i < 2; ++i) {
                const auto& coarse = levels.elements(i);
                const auto fine_faces = levels.elements(i + 1).faces();
                const auto of_face = [&](std::size_t f) {
                    return levels.assoc(i, levels.elements(i).face_at(f), targets::F).value;
                };
                known += expect_same(
                    limit_positions(coarse.faces(), scheme), limit_positions(fine_faces, scheme), of_face);
                known += expect_same(limit_normals(coarse.faces(), scheme), limit_normals(fine_faces, scheme), of_face);
                const auto of_vertex = [&](std::size_t v) {
                    return levels.assoc(i, levels.elements(i).vertex_at(v), targets::F).value;
                };
                known += expect_same(
                    inner(coarse, limit_positions(coarse, scheme)), limit_positions(fine_faces, scheme), of_vertex);
                known += expect_same(limit_normals(coarse, scheme), limit_normals(fine_faces, scheme), of_vertex);
            }
        }
    });
    EXPECT_GT(known, 10000U);
}

TEST(limit_levels, normals_of_a_plane_are_upright)
{
    expect_upright(kith::catmull_clark());
    expect_upright(kith::loop());
    expect_upright(kith::doo_sabin());
    expect_upright(kith::sqrt3());
    expect_upright(kith::butterfly());
    expect_upright(kith::kobbelt());
    expect_upright(kith::nasri_hasbini());
    expect_upright(kith::four_eight());
}
