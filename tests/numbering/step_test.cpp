// SPDX-License-Identifier: BSD-3-Clause
#include <kith/numbering/step/step.hpp>

#include "support/error_text.hpp"
#include "support/every_scheme.hpp"
#include "support/same_mesh.hpp"

#include <gtest/gtest.h>

#include <string>
#include <typeinfo>

namespace {

template <class Scheme>
using ids_of = kith::numbering_of<Scheme, std::uint32_t>;

} // namespace

TEST(step, leaves_its_numbering_behind)
{
    const auto mesh = native(shapes::house());
    ids_of<kith::catmull_clark> ids;
    const auto fine = kith::refine_mesh<kith::connect::everything>(mesh, kith::catmull_clark(), ids);
    EXPECT_EQ(ids.vertices.total(), fine.vertex_count());
    EXPECT_EQ(ids.edges.total(), fine.edge_count());
    EXPECT_EQ(ids.faces.total(), fine.face_count());
}

TEST(step, through_the_traits_gives_the_same_bits)
{
    for_each_scheme_and_shape([](const auto& scheme, const mesh3d& mesh) {
        ids_of<std::remove_cvref_t<decltype(scheme)>> ids;
        const kith::level_elements<kith::mesh_level<mesh3d>> level(mesh);
        const auto through_traits = kith::refine_level<kith::connect::everything>(level, scheme, 0, ids);
        EXPECT_TRUE(same_bits(through_traits, kith::refine_mesh<kith::connect::everything>(mesh, scheme, ids)));
    });
}

TEST(step, picks_the_level_that_fits_the_faces)
{
    const auto name = [](const auto& level) { return std::string(typeid(level).name()); };
    const auto of = [&](const shapes::shape& s) {
        return kith::with_native_level<kith::catmull_clark>(native(s), name);
    };
    EXPECT_NE(of(shapes::cube()), of(shapes::house()));
    EXPECT_EQ(of(shapes::tetrahedron()), of(shapes::house()));
}

TEST(step, refuses_faces_that_do_not_fit_the_scheme)
{
    ids_of<kith::loop> ids;
    EXPECT_EQ(error_text<kith::mesh_error>([&] {
                  static_cast<void>(kith::refine_mesh<kith::connect::faces>(native(shapes::cube()), kith::loop(), ids));
              }),
              "loop: face 0 has 4 vertices; triangulate the mesh first");
}
