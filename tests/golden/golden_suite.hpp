// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "golden_schemes.hpp"
#include "support/same_mesh.hpp"
#include "support/user_mesh.hpp"

#include <kith/hierarchy.hpp>
#include <kith/limits/limit.hpp>
#include <kith/refine.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

/// The tests of all golden files, instantiated for each mesh type in golden_*test.cpp:
///
///   INSTANTIATE_TYPED_TEST_SUITE_P(name_of_the_mesh, golden_files, all_schemes_on<the mesh>);
template <class SchemeOnMesh>
class golden_files : public testing::Test {
protected:
    using mesh = typename SchemeOnMesh::mesh;
    using traits = kith::mesh_traits<mesh>;

    static double tolerance(const golden::file& f)
    {
        double size = 0;
        for (const auto& p : f.levels[0].vertices)
            for (const double x : p)
                size = std::max(size, std::abs(x));
        return size * user_mesh<mesh>::tolerance;
    }
    /// Expects a vertex at the place of a golden vertex.
    static void expect_near(const mesh& m, typename traits::vertex v, const golden::file& f, std::size_t level,
                            std::size_t golden_vertex)
    {
        const auto is = coordinates(traits::point_of(m, v));
        const auto should_be = f.levels[level].vertices[golden_vertex];
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_NEAR(is[i], should_be[i], tolerance(f)) << "golden vertex " << golden_vertex << ", coordinate " << i;
    }
    static void expect_counts(const mesh& m, const golden::level& level)
    {
        const auto counts = kith::level_of<mesh>(m).counts();
        EXPECT_EQ((std::array<std::size_t, 3>{counts.vertices, counts.edges, counts.faces}), level.counts);
        EXPECT_EQ(counts.boundary_edges, level.boundary_edges);
    }
    /// Expects the golden faces. number[i] is the golden number of vertex i.
    static void expect_faces(const mesh& m, const golden::level& level, const std::vector<std::size_t>& number)
    {
        auto faces = faces_of(m);
        for (auto& face : faces)
            for (auto& v : face)
                v = number[v];
        EXPECT_EQ(as_cycles(faces), as_cycles(level.faces));
    }
    /// Returns the vertex of level 1 that belongs to a tuple.
    template <class Scheme>
    static auto vertex_of(const kith::hierarchy<mesh, Scheme>& levels, const golden::key& key)
    {
        using kith::targets::V;
        const auto& coarse = levels.elements(0);
        const auto v = [&](std::size_t i) { return coarse.vertex_at(key.numbers[i]); };
        const auto f = [&](std::size_t i) { return coarse.face_at(key.numbers[i]); };
        const auto e = [&](std::size_t i) { return edge_between(coarse, key.numbers[i], key.numbers[i + 1]); };
        return key.kind == "v"    ? levels.assoc(0, v(0), V)
               : key.kind == "e"  ? levels.assoc(0, e(0), V)
               : key.kind == "f"  ? levels.assoc(0, f(0), V)
               : key.kind == "vf" ? levels.assoc(0, v(0), f(1), V)
                                  : levels.assoc(0, v(0), e(1), V);
    }
};

TYPED_TEST_SUITE_P(golden_files);

TYPED_TEST_P(golden_files, each_vertex_of_level_1_is_found_by_its_tuple)
{
    using mesh = typename TypeParam::mesh;
    TypeParam::for_each([](const golden::file& f, const mesh& control, const auto& scheme) {
        SCOPED_TRACE(f.name);
        kith::hierarchy levels(control, scheme);
        levels.refine();
        const mesh& fine = levels[1];
        const auto& level = f.levels[1];
        TestFixture::expect_counts(fine, level);
        if (f.degree != 0)
            return; // the files of the unified scheme contain no tuples
        ASSERT_EQ(level.keys.size(), level.vertices.size());
        std::vector<std::size_t> number(level.vertices.size(), level.vertices.size());
        for (std::size_t i = 0; i < level.keys.size(); ++i) {
            const auto v = TestFixture::vertex_of(levels, level.keys[i]);
            TestFixture::expect_near(fine, v, f, 1, i);
            number[std::size_t(TestFixture::traits::index(fine, v))] = i;
        }
        TestFixture::expect_faces(fine, level, number);
    });
}

TYPED_TEST_P(golden_files, all_levels_have_the_golden_points_and_faces)
{
    using mesh = typename TypeParam::mesh;
    TypeParam::for_each([](const golden::file& f, const mesh& control, const auto& scheme) {
        for (std::size_t n = 1; n < f.levels.size(); ++n) {
            SCOPED_TRACE(f.name + ", level " + std::to_string(n));
            const mesh fine = kith::refine(control, scheme, int(n));
            const auto& level = f.levels[n];
            TestFixture::expect_counts(fine, level);
            std::vector<std::size_t> number;
            for (const auto v : TestFixture::traits::vertices(fine)) {
                const auto p = coordinates(TestFixture::traits::point_of(fine, v));
                const auto distance = [&](const auto& q) { return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]); };
                const auto nearest = std::ranges::min_element(level.vertices, {}, distance);
                ASSERT_LT(distance(*nearest), level.min_vertex_distance / 4);
                number.push_back(std::size_t(nearest - level.vertices.begin()));
                TestFixture::expect_near(fine, v, f, n, number.back());
            }
            TestFixture::expect_faces(fine, level, number);
        }
    });
}

TYPED_TEST_P(golden_files, level_by_level_gives_the_same_bits_as_all_levels_at_once)
{
    using mesh = typename TypeParam::mesh;
    TypeParam::for_each([](const golden::file& f, const mesh& control, const auto& scheme) {
        SCOPED_TRACE(f.name);
        const int n = int(f.levels.size()) - 1;
        kith::hierarchy levels(control, scheme);
        levels.refine(n);
        EXPECT_TRUE(same_bits(levels.finest(), kith::refine(control, scheme, n)));
    });
}

/// Limit points of level 1 are the golden ones, and those without a golden mask have no mask here.
TYPED_TEST_P(golden_files, limit_points_of_level_1)
{
    using mesh = typename TypeParam::mesh;
    TypeParam::for_each([]<class Scheme>(const golden::file& f, const mesh& control, const Scheme& scheme) {
        const auto& level = f.levels[1];
        if (level.limit_points.empty())
            return;
        SCOPED_TRACE(f.name);
        kith::hierarchy levels(control, scheme);
        levels.refine();
        using elements = kith::level_of<mesh>;
        if constexpr (kith::has_limit_positions<Scheme, kith::vertex<elements>, elements>) {
            const auto limits = limit_positions(levels.elements(1), levels.scheme(1));
            for (std::size_t i = 0; i < level.limit_points.size(); ++i) {
                const auto v = std::size_t(
                    TestFixture::traits::index(levels[1], TestFixture::vertex_of(levels, level.keys[i])));
                const auto& should_be = level.limit_points[i];
                ASSERT_EQ(limits[v].has_value(), should_be.has_value()) << "golden vertex " << i;
                if (not limits[v])
                    continue;
                const auto is = coordinates(*limits[v]);
                for (std::size_t k = 0; k < 3; ++k)
                    EXPECT_NEAR(is[k], (*should_be)[k], TestFixture::tolerance(f)) << "golden vertex " << i;
            }
        } else {
            ADD_FAILURE() << "the scheme has no limit masks";
        }
    });
}

REGISTER_TYPED_TEST_SUITE_P(golden_files, each_vertex_of_level_1_is_found_by_its_tuple,
                            all_levels_have_the_golden_points_and_faces,
                            level_by_level_gives_the_same_bits_as_all_levels_at_once, limit_points_of_level_1);
