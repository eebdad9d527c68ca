// SPDX-License-Identifier: BSD-3-Clause
#include "support/openmesh_mesh.hpp"
#include "support/selected_on.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/loop.hpp>

#include <gtest/gtest.h>

TEST(selected_openmesh, levels_are_those_of_native_meshes)
{
    expect_levels_of_native<tri_mesh>(kith::loop(), shapes::shaken(figures::triangulated(shapes::open_house())));
    expect_levels_of_native<poly_mesh>(kith::catmull_clark(), shapes::shaken(shapes::house()));
}

TEST(selected_openmesh, removed_faces_are_named)
{
    auto control = user_mesh<poly_mesh>::make(shapes::house().points, shapes::house().faces);
    control.delete_face(OpenMesh::FaceHandle(10), true);
    expect_removed_face_is_named(kith::catmull_clark(), control, OpenMesh::FaceHandle(10));
}
