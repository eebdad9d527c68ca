// SPDX-License-Identifier: BSD-3-Clause
#include "support/error_text.hpp"
#include "support/openmesh_mesh.hpp"
#include "support/same_mesh.hpp"
#include "support/some_maps.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/openmesh_properties.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace {

using namespace some_maps;
using native = kith::property_mesh<>;

} // namespace

TEST(convert, what_does_not_fit_exactly_is_named)
{
    auto control = with_maps(cgal(shapes::cube()));
    const auto exactly = kith::convert<poly_mesh_float>(control);
    EXPECT_EQ(exactly.report.narrowed, names{"v:normal"}); // 0.1 as a float
    control.point(vertex(0)) = kernel::Point_3(0.1, 0, 0);
    property<vertex, CGAL::IO::Color>(control, "v:color")[vertex(1)] = CGAL::IO::Color(1, 2, 3, 4);
    const auto narrowed = kith::convert<poly_mesh_float>(control);
    EXPECT_EQ(narrowed.report.narrowed, (names{"points", "v:color", "v:normal"}));
    EXPECT_EQ(narrowed.mesh.point(OpenMesh::VertexHandle(0))[0], 0.1F);
    EXPECT_EQ(narrowed.mesh.color(OpenMesh::VertexHandle(1)), poly_mesh_float::Color(1, 2, 3));
}

TEST(convert, exact_numbers_are_rounded_where_they_must_be)
{
    using exact_mesh = surface_mesh<epeck>;
    auto control = user_mesh<exact_mesh>::make(shapes::cube().points, shapes::cube().faces);
    auto normal = control.add_property_map<vertex, epeck::Vector_3>("v:normal").first;
    for (const auto v : control.vertices())
        normal[v] = epeck::Vector_3(0, 0, 0.5 * int(v));
    const auto exactly = kith::convert<cgal_mesh>(control);
    EXPECT_EQ(exactly.report.narrowed, names());
    EXPECT_EQ((property<vertex, kernel::Vector_3>(exactly.mesh, "v:normal")[vertex(3)]), kernel::Vector_3(0, 0, 1.5));
    control.point(vertex(0)) = epeck::Point_3(epeck::FT(1) / 3, 0, 0);
    normal[vertex(1)] = epeck::Vector_3(0, epeck::FT(1) / 3, 0);
    const auto narrowed = kith::convert<cgal_mesh>(control);
    EXPECT_EQ(narrowed.report.narrowed, (names{"points", "v:normal"}));
    EXPECT_NEAR(narrowed.mesh.point(vertex(0)).x(), 1. / 3, 1e-15);
}

TEST(property_mesh, refines_its_properties_as_other_meshes_do)
{
    const auto control = with_maps(cgal(shapes::open_house()));
    const auto expected = kith::refine_with_properties(control, kith::catmull_clark(), 2).first;
    const auto [fine,
                report] = kith::refine_with_properties(kith::convert<native>(control).mesh, kith::catmull_clark(), 2);
    EXPECT_TRUE(same_bits(fine.native(), kith::to_native(kith::convert<native>(expected).mesh)));
    EXPECT_TRUE(std::ranges::equal(fine.get<kith::field_on::faces, std::string>("f:material"),
                                   values<face, std::string>(expected, "f:material")));
    EXPECT_TRUE(std::ranges::equal(fine.get<kith::field_on::edges, bool>("e:is_sharp"),
                                   values<edge, bool>(expected, "e:is_sharp")));
    const auto texture = fine.get<kith::field_on::corners, uv>("h:uv");
    const auto same_texture = kith::convert<native>(expected).mesh.get<kith::field_on::corners, uv>("h:uv");
    EXPECT_TRUE(std::ranges::equal(texture, same_texture));
}

TEST(property_mesh, says_what_is_missing)
{
    native mesh = kith::make_mesh(shapes::cube().points, shapes::cube().faces);
    EXPECT_NE(error_text<kith::mesh_error>([&] {
                  mesh.set("f:id", kith::on_faces(std::vector<int>(5)));
              }).find("5 values for 6 elements"),
              std::string::npos);
    mesh.set("f:id", kith::on_faces(std::vector<int>(6, 2)));
    EXPECT_EQ((mesh.get<kith::field_on::faces, int>("f:id")[5]), 2);
    EXPECT_NE(error_text<kith::mesh_error>([&] {
                  static_cast<void>(mesh.get<kith::field_on::faces, float>("f:id"));
              }).find("'f:id'"),
              std::string::npos);
}
