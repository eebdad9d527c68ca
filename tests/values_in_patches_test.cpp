// SPDX-License-Identifier: BSD-3-Clause
#include <kith/field/values_in_patches.hpp>

#include <kith/catmull_clark.hpp>
#include <kith/crease/make_creases.hpp>
#include <kith/doo_sabin.hpp>
#include <kith/hierarchy.hpp>
#include <kith/loop.hpp>
#include <kith/refine_with_fields.hpp>

#include "native_shape.hpp"
#include "same_mesh.hpp"
#include "shapes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>
#include <type_traits>
#include <vector>

namespace {

using mesh_type = kith::basic_mesh<>;
using colour = std::array<float, 4>;

/// Differs from vertex to vertex in all bits.
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

/// Levels that are large enough for patches, one by one and several at once.
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
    expect_same_carried<kith::doo_sabin, double>(torus, {}, 5);
    const auto open = native(shapes::shaken(shapes::grid(17, 19)));
    kith::catmull_clark creased;
    creased.sharpness = kith::make_creases(open, [](auto e) { return e.value % 19 == 0 ? 1.5 : 0; });
    expect_same_carried<kith::catmull_clark, double>(open, creased, 5);
}

TEST(values_in_patches, come_from_templates_of_their_own_kind_of_number)
{
    const kith::catmull_clark scheme{.corners = kith::boundary_corner::smoothed}; // of this test alone
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
    for (const auto last : {kith::connect::faces, kith::connect::everything}) {
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
    static_assert(not kith::go_in_patches<std::tuple<label>, kith::doo_sabin, std::uint32_t>); // born by edges, too
}

} // namespace
