// SPDX-License-Identifier: BSD-3-Clause
#include "every_scheme.hpp"
#include "tiles.hpp"

#include <kith/creases.hpp>
#include <kith/hash_value.hpp>

namespace {

/// Calls test(scheme, mesh) for all schemes that can be refined in tiles.
template <class Test>
void for_each_reaching_scheme_and_shape(const Test& test)
{
    for_each_of_all_schemes_and_shape([&]<class Scheme>(const Scheme& scheme, const mesh3d& mesh) {
        if constexpr (kith::reaching_scheme<Scheme>)
            test(scheme, mesh);
    });
}

std::vector<std::uint32_t> one_part_per_face(std::size_t faces)
{
    return partitions::blocks(faces, faces);
}

} // namespace

TEST(refine_tile, equals_the_whole_mesh_bit_for_bit)
{
    for_each_reaching_scheme_and_shape([](const auto& scheme, const mesh3d& mesh) {
        const std::size_t faces = mesh.face_count();
        for (const int levels : {0, 1, 2, 3})
            EXPECT_EQ(tiles_differ(mesh, scheme, levels, partitions::blocks(faces, 3), 3), "") << levels;
    });
}

TEST(refine_tile, takes_scattered_and_empty_parts)
{
    for_each_reaching_scheme_and_shape([](const auto& scheme, const mesh3d& mesh) {
        for (const std::uint32_t seed : {1, 2})
            EXPECT_EQ(tiles_differ(mesh, scheme, 3, partitions::scattered(mesh.face_count(), 5, seed), 7), "") << seed;
    });
}

TEST(refine_tile, takes_parts_of_one_face)
{
    for_each_reaching_scheme_and_shape([](const auto& scheme, const mesh3d& mesh) {
        if (mesh.face_count() <= 60) {
            EXPECT_EQ(tiles_differ(mesh, scheme, 3, one_part_per_face(mesh.face_count()), mesh.face_count()), "");
        }
    });
}

TEST(refine_tile, needs_no_more_rings_for_more_levels)
{
    for_each_reaching_scheme_and_shape([](const auto& scheme, const mesh3d& mesh) {
        const int levels = scheme.name == "sqrt3" or scheme.name == "mid-edge" or scheme.name == "4-8" ? 6 : 4;
        if (mesh.face_count() <= 20 and scheme.name != "nasri-hasbini") {
            EXPECT_EQ(tiles_differ(mesh, scheme, levels, partitions::scattered(mesh.face_count(), 3, 4), 3), "");
        }
    });
}

TEST(refine_tile, leaves_rings_of_shadows_where_asked)
{
    for_each_reaching_scheme_and_shape([](const auto& scheme, const mesh3d& mesh) {
        for (const int rings : {1, 2})
            EXPECT_EQ(tiles_differ(mesh, scheme, 2, partitions::scattered(mesh.face_count(), 4, 3), 4, rings), "")
                << rings;
    });
}

TEST(refine_tile, leaves_edges_and_shadows_out_at_the_end)
{
    for_each_reaching_scheme_and_shape([](const auto& scheme, const mesh3d& mesh) {
        const auto parts = partitions::scattered(mesh.face_count(), 4, 6);
        for (const int levels : {1, 2, 3})
            EXPECT_EQ(tiles_differ(mesh, scheme, levels, parts, 4, 0, kith::connect::faces), "") << levels;
    });
}

TEST(refine_tile, hands_creases_on)
{
    for (const auto method : {kith::crease_method::uniform, kith::crease_method::chaikin}) {
        const auto mesh = native(shapes::shaken(shapes::torus(6, 8)));
        kith::creases sharp(method);
        for (std::size_t e = 0; e < mesh.edge_count(); e += 5)
            sharp.sharpen_edge(e, e % 3 == 0 ? kith::infinitely_sharp : 0.4 * double(e % 7));
        sharp.sharpen_vertex(3, 1.5);
        sharp.sharpen_vertex(20, kith::infinitely_sharp);
        const kith::catmull_clark scheme{.corners = kith::boundary_corner::kept, .sharpness = sharp};
        EXPECT_EQ(tiles_differ(mesh, scheme, 3, partitions::scattered(mesh.face_count(), 5, 1), 5), "");
        EXPECT_EQ(tiles_differ(mesh, scheme, 3, partitions::blocks(mesh.face_count(), 3), 3), "");
    }
}

TEST(refine_tile, does_the_same_operations_in_the_same_order)
{
    for_each_reaching_scheme_and_shape([](const auto& scheme, const mesh3d& mesh) {
        kith::storage<kith::hash_value> names(mesh.vertex_count());
        for (std::size_t v = 0; v < names.size(); ++v)
            names[v].bits = kith::mix_bits(v + 1);
        const kith::basic_mesh<kith::hash_value> hashed(std::move(names), mesh.topology(), mesh.generation());
        EXPECT_EQ(tiles_differ(hashed, scheme, 2, partitions::scattered(mesh.face_count(), 4, 5), 4), "");
    });
}
