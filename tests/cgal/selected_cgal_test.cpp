// SPDX-License-Identifier: BSD-3-Clause
#include "support/cgal_mesh.hpp"
#include "support/selected_on.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/loop.hpp>

#include <gtest/gtest.h>

using mesh = surface_mesh<CGAL::Simple_cartesian<double>>;

TEST(selected_cgal, levels_are_those_of_native_meshes)
{
    expect_levels_of_native<mesh>(kith::loop(), shapes::shaken(figures::triangulated(shapes::open_house())));
    expect_levels_of_native<mesh>(kith::catmull_clark(), shapes::shaken(shapes::house()));
}

TEST(selected_cgal, removed_faces_are_named)
{
    auto control = user_mesh<mesh>::make(shapes::house().points, shapes::house().faces);
    CGAL::Euler::remove_face(control.halfedge(mesh::Face_index(10)), control);
    expect_removed_face_is_named(kith::catmull_clark(), control, mesh::Face_index(10));
}

TEST(selected_cgal, closed_meshes_stay_without_a_mark_of_odd_steps)
{
    const auto tetrahedron = shapes::tetrahedron();
    const auto control = user_mesh<mesh>::make(tetrahedron.points, tetrahedron.faces);
    kith::hierarchy levels(control, kith::selected(kith::loop()));
    levels.refine();
    EXPECT_EQ(levels.finest().number_of_faces(), 16U);
    EXPECT_EQ(levels.finest().properties<mesh::Face_index>(), control.properties<mesh::Face_index>());
}
