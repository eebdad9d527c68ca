// SPDX-License-Identifier: BSD-3-Clause
#include "support/property_names.hpp"
#include "support/shapes.hpp"

#include <kith/carry_properties.hpp>
#include <kith/catmull_clark.hpp>
#include <kith/core/mesh/make_mesh.hpp>
#include <kith/face_varying.hpp>
#include <kith/fields/property_mesh.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <vector>

namespace {

using mesh = kith::property_mesh<>;
using traits = kith::mesh_traits<mesh>;
using uv = std::array<double, 2>;
using names = std::vector<std::string>;
using kith::field_on;

/// A user-defined type of values that is no array of numbers.
struct reading {
    double celsius = 0;
    friend bool operator==(const reading&, const reading&) = default;
};
struct label {
    int number = -1;
    friend bool operator==(const label&, const label&) = default;
};

std::vector<uv> textures(std::size_t corners)
{
    std::vector<uv> result;
    for (std::size_t c = 0; c < corners; ++c)
        result.push_back({double(c % 7), double(c % 5)});
    return result;
}

} // namespace

template <>
struct kith::affine<reading> {
    using scalar = double;
    using sum = double;
    static double load(const reading& r) { return r.celsius; }
    static reading store(double total) { return {total}; }
    static void add(double& total, double more) { total += more; }
    static void scale(double& total, double weight) { total *= weight; }
};

TEST(property_rules, of_the_user_are_taken_by_the_call_that_carries_all)
{
    const auto shape = shapes::open_house();
    mesh control(kith::make_mesh(shape.points, shape.faces));
    const auto& native = control.native();
    const auto texture = textures(native.corner_count());
    std::vector<double> area(native.face_count());
    for (std::size_t f = 0; f < area.size(); ++f)
        area[f] = double(f + 1);
    std::vector<label> labels(native.vertex_count());
    for (std::size_t v = 0; v < labels.size(); ++v)
        labels[v].number = int(v);
    control.set("h:uv", kith::on_corners(texture));
    control.set("f:area", kith::on_faces(area));
    control.set("f:patch", kith::on_faces(area));
    control.set("v:label", kith::on_vertices(labels, kith::from_vertex()));

    const kith::face_varying smooth(kith::face_varying_linear::corners_only);
    const kith::from_parent shared{[](double x) { return x / 4; }};
    const auto [fine, report] = kith::refine_with_properties(
        control,
        kith::catmull_clark(),
        2,
        kith::by_rule<traits::halfedge, uv>("h:uv", smooth),
        kith::by_rule<traits::face, double>("f:area", shared),
        kith::by_rule<traits::vertex, label>("v:label", kith::from_vertex()),
        kith::by_rule<traits::face, double>("f:absent", shared));
    EXPECT_EQ(report.carried, (names{"h:uv", "f:area", "f:patch", "v:label"}));
    EXPECT_EQ(names_of(report.left_out), names{"f:absent"});

    kith::hierarchy levels(native, kith::catmull_clark());
    levels.refine(2);
    const auto expect = [&]<field_on Where, class T, class Rule>(const std::string& name,
                                                                 const kith::field<Where, T, Rule>& values) {
        EXPECT_TRUE(std::ranges::equal(fine.get<Where, T>(name), levels.carry(0, 2, values).values())) << name;
    };
    expect("h:uv", kith::on_corners(texture, smooth));
    expect("f:area", kith::on_faces(area, shared));
    expect("f:patch", kith::on_faces(area));
    expect("v:label", kith::on_vertices(labels, kith::from_vertex()));
}

TEST(property_rules, own_types_that_have_a_mean_go_by_the_masks)
{
    const auto shape = shapes::open_house();
    mesh control(kith::make_mesh(shape.points, shape.faces));
    const auto& native = control.native();
    std::vector<reading> at_vertices(native.vertex_count()), at_corners(native.corner_count());
    for (std::size_t v = 0; v < at_vertices.size(); ++v)
        at_vertices[v].celsius = native.point(v)[2];
    for (std::size_t c = 0; c < at_corners.size(); ++c)
        at_corners[c].celsius = double(c);
    control.set("v:heat", kith::on_vertices(at_vertices));
    control.set("h:heat", kith::on_corners(at_corners));
    const auto [fine, report] = kith::refine_with_properties<reading>(control, kith::catmull_clark(), 2);
    EXPECT_EQ(report.carried, (names{"v:heat", "h:heat"}));
    const auto heat = fine.get<field_on::vertices, reading>("v:heat");
    for (std::size_t v = 0; v < heat.size(); ++v)
        EXPECT_EQ(heat[v].celsius, fine.native().point(v)[2]);
    kith::hierarchy levels(native, kith::catmull_clark());
    levels.refine(2);
    EXPECT_TRUE(std::ranges::equal(fine.get<field_on::corners, reading>("h:heat"),
                                   levels.carry(0, 2, kith::on_corners(at_corners)).values()));
    EXPECT_EQ(names_of(kith::refine_with_properties(control, kith::catmull_clark(), 1).second.left_out),
              (names{"v:heat", "h:heat"}));
}
