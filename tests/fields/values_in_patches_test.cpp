// SPDX-License-Identifier: BSD-3-Clause
#include <kith/fields/values_in_patches.hpp>

#include <kith/butterfly.hpp>
#include <kith/catmull_clark.hpp>
#include <kith/doo_sabin.hpp>
#include <kith/face_varying.hpp>
#include <kith/hierarchy.hpp>
#include <kith/kobbelt.hpp>
#include <kith/linear.hpp>
#include <kith/loop.hpp>
#include <kith/make_creases.hpp>
#include <kith/mid_edge.hpp>
#include <kith/refine_with_fields.hpp>
#include <kith/sqrt3.hpp>

#include "support/forced_way.hpp"
#include "support/native_shape.hpp"
#include "support/same_mesh.hpp"
#include "support/shapes.hpp"
#include "support/shuffled.hpp"
#include "support/under_sanitizers.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

using mesh_type = kith::basic_mesh<>;
using colour = std::array<float, 4>;

/// Returns values that differ from vertex to vertex.
template <class T>
std::vector<T> values_at_vertices(const mesh_type& mesh)
{
    std::vector<T> result;
    for (const auto& p : mesh.points())
        if constexpr (std::is_same_v<T, colour>)
            result.push_back({float(p[0]), float(p[1] / 3), float(p[2] * p[0]), float(1 / (3 + p[1]))});
        else
            result.push_back(T(p[0] / 3 + p[1] * p[2]));
    return result;
}
std::vector<int> labels_of(const mesh_type& mesh)
{
    std::vector<int> result;
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        result.push_back(int(7 * f + 1));
    return result;
}

template <class T>
::testing::AssertionResult same_values(std::span<const T> given, std::span<const T> expected)
{
    if (given.size() != expected.size())
        return ::testing::AssertionFailure() << given.size() << " values, not " << expected.size();
    for (std::size_t i = 0; i < given.size(); ++i)
        if (std::bit_cast<std::array<std::byte, sizeof(T)>>(given[i]) !=
            std::bit_cast<std::array<std::byte, sizeof(T)>>(expected[i]))
            return ::testing::AssertionFailure() << "value " << i << " differs";
    return ::testing::AssertionSuccess();
}

/// Expects equal values whether several levels are carried at once or one by one. Precondition: the levels are large
/// enough for patches.
template <class Scheme, class T>
void expect_same_carried(const mesh_type& mesh, const Scheme& scheme, int levels)
{
    kith::hierarchy<mesh_type, Scheme> surface(mesh, scheme);
    surface.refine(levels);
    auto expected = kith::on_vertices(values_at_vertices<T>(mesh), kith::by_mask());
    const auto given = surface.carry(0, levels, expected);
    for (int level = 0; level < levels; ++level)
        expected = surface.carry(level, level + 1, expected);
    EXPECT_TRUE(same_values(given.values(), expected.values()));
}

TEST(values_in_patches, are_carried_by_the_masks_to_the_same_bits)
{
    const auto torus = native(shapes::shaken(shapes::torus(12, 24)));
    expect_same_carried<kith::catmull_clark, double>(torus, {}, 5);
    expect_same_carried<kith::loop, float>(native(shapes::shaken(shapes::triangulated(shapes::torus(12, 24)))), {}, 5);
    if (under_sanitizers)
        return;
    expect_same_carried<kith::doo_sabin, double>(torus, {}, 5);
    const auto open = native(shapes::shaken(shapes::grid(17, 19)));
    kith::catmull_clark creased;
    creased.sharpness = kith::make_creases(open, [](auto e) { return e.value % 19 == 0 ? 1.5 : 0; });
    expect_same_carried<kith::catmull_clark, double>(open, creased, 5);
}

TEST(values_in_patches, come_from_templates_of_their_own_kind_of_number)
{
    const kith::catmull_clark scheme{.corners = kith::boundary_corner::smoothed}; // no other test uses these options
    const auto mesh = native(shapes::shaken(shapes::torus(12, 24)));
    const auto plan = kith::plan_patches(kith::count(mesh.topology()), 4, scheme, 5, 0);
    ASSERT_TRUE(plan);
    const auto kept = kith::kept_templates<float, std::uint32_t>::of(
        scheme, plan->begin, plan->rings, plan->bases.size());
    kith::hierarchy<mesh_type, kith::catmull_clark> surface(mesh, scheme);
    surface.refine(5);
    EXPECT_TRUE(kept.empty());
    EXPECT_EQ(surface.carry(0, 5, values_at_vertices<float>(mesh)).size(), surface.finest().vertex_count());
    EXPECT_FALSE(kept.empty());
}

TEST(values_in_patches, go_along_with_a_mesh_that_is_refined_in_patches)
{
    const auto control = native(shapes::shaken(shapes::torus(12, 24)));
    const kith::catmull_clark scheme;
    for (const auto last : {kith::connect::everything, kith::connect::faces}) {
        if (under_sanitizers and last == kith::connect::faces)
            continue;
        auto weight = kith::on_vertices(values_at_vertices<double>(control), kith::by_mask());
        auto shade = kith::on_vertices(values_at_vertices<colour>(control), kith::by_mask());
        auto label = kith::on_faces(labels_of(control));
        auto fields = std::tuple(weight, shade, label);
        const auto fine = kith::refine_with_fields(
            control, scheme, 5, std::tie(weight, shade, label), {.last_level = last});
        auto level = control;
        for (int i = 1; i <= 5; ++i)
            level = std::apply(
                [&](auto&... each) {
                    return kith::refine_with_fields(
                        level, scheme, 1, std::tie(each...), {.last_level = i == 5 ? last : kith::connect::everything});
                },
                fields);
        EXPECT_TRUE(same_bits(fine, level));
        EXPECT_TRUE(same_values(weight.values(), std::get<0>(fields).values()));
        EXPECT_TRUE(same_values(shade.values(), std::get<1>(fields).values()));
        EXPECT_TRUE(same_values(label.values(), std::get<2>(fields).values()));
    }
}

/// Expects equal fields of each inherited kind from refinement at once and step by step.
template <class Scheme>
void expect_inherited(const mesh_type& control, const Scheme& scheme, int levels, bool are_corners_taken = true)
{
    const auto numbers = [](std::size_t count, double factor) {
        std::vector<double> result(count);
        for (std::size_t i = 0; i < count; ++i)
            result[i] = std::sin(factor * double(i + 1));
        return result;
    };
    const auto make = [&] {
        std::vector<int> labels(control.corner_count());
        std::iota(labels.begin(), labels.end(), 1);
        std::vector<colour> uv(control.corner_count());
        for (std::size_t c = 0; c < uv.size(); ++c)
            uv[c] = {float(std::sin(double(c))), float(c % 7), float(1) / float(c + 3), 1};
        return std::tuple(
            kith::on_corners(uv, kith::linear_in_faces()),
            kith::on_corners(numbers(control.corner_count(), 3), kith::face_varying{kith::face_varying_linear::all}),
            kith::on_corners(labels, kith::along_sides()),
            kith::on_edges(numbers(control.edge_count(), 5), kith::along_edges()),
            kith::on_vertices(numbers(control.vertex_count(), 7), kith::from_vertex()),
            kith::on_faces(numbers(control.face_count(), 9), kith::from_parent()));
    };
    auto together = make(), expected = make();
    const auto refined = [&](auto& fields, kith::refinement_way way) {
        const forced_way_here in(way);
        return std::apply([&](auto&... each) { return refine_with_fields(control, scheme, levels, std::tie(each...)); },
                          fields);
    };
    EXPECT_TRUE(same_bits(refined(together, kith::refinement_way::in_patches),
                          refined(expected, kith::refinement_way::by_levels)));
    const auto same = [&]<std::size_t... I>(std::index_sequence<I...>) {
        return std::array{same_values(std::get<I>(together).values(), std::get<I>(expected).values())...};
    };
    for (const bool is_same : same(std::make_index_sequence<6>()))
        EXPECT_TRUE(is_same) << kith::scheme_name<Scheme>();

    kith::hierarchy all(control, scheme);
    all.refine(levels);
    std::apply([&](const auto&... each) { together = std::tuple(all.carry(0, levels, each)...); }, make());
    for (const bool is_same : same(std::make_index_sequence<6>()))
        EXPECT_TRUE(is_same) << "carried by a hierarchy, " << kith::scheme_name<Scheme>();

    const auto plan = kith::plan_patches(
        count(control.topology()), control.topology().degree, scheme, levels, control.generation());
    ASSERT_TRUE(plan);
    const auto& level = all[plan->begin];
    const kith::fields_in_patches in_patches(
        level.topology(), level.generation(), scheme, *plan, kith::connect::everything);
    EXPECT_EQ(in_patches.can_take(std::get<0>(together)), are_corners_taken) << kith::scheme_name<Scheme>();
}

TEST(values_in_patches, are_inherited_by_corners_edges_and_vertices)
{
    const auto quads = native(shapes::shaken(shapes::shuffled(shapes::torus(7, 6), 3)));
    const auto polygons = native(shapes::shaken(shapes::both(shapes::house(), shapes::pentacube())));
    const auto open = native(shapes::shaken(shapes::grid(4, 5)));
    const auto triangles = native(shapes::shaken(shapes::shuffled(shapes::triangulated(shapes::torus(6, 5)), 5)));
    for (const auto& mesh : {quads, polygons, open})
        expect_inherited(mesh, kith::catmull_clark{}, 3);
    for (const auto& mesh : {quads, polygons})
        expect_inherited(mesh, kith::linear{}, 3);
    expect_inherited(quads, kith::kobbelt{}, 2);
    expect_inherited(triangles, kith::loop{}, 3);
    expect_inherited(triangles, kith::butterfly{}, 2);
    expect_inherited(triangles, kith::sqrt3{}, 3, false); // corners come from two faces, which needs single steps
}

TEST(values_in_patches, are_those_of_one_kind_of_rule_each)
{
    using kith::field_on;
    using scheme = kith::catmull_clark;
    using weight = kith::field<field_on::vertices, double, kith::by_mask>;
    using label = kith::field<field_on::faces, int, kith::from_parent<>>;
    using linear = kith::field<field_on::vertices, double, kith::linear_values>;
    static_assert(kith::go_in_patches<std::tuple<weight, label>, scheme, std::uint32_t>);
    static_assert(not kith::go_in_patches<std::tuple<weight, linear>, scheme, std::uint32_t>);
    static_assert(not kith::go_in_patches<std::tuple<>, scheme, std::uint32_t>);
    using corner = kith::field<field_on::corners, double, kith::linear_in_faces>;
    static_assert(kith::go_in_patches<std::tuple<corner>, scheme, std::uint32_t>);
    static_assert(not kith::go_in_patches<std::tuple<corner>, kith::mid_edge, std::uint32_t>);
    static_assert(not kith::go_in_patches<std::tuple<label>, kith::doo_sabin, std::uint32_t>); // born by edges, too
}

} // namespace
