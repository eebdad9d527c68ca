// SPDX-License-Identifier: BSD-3-Clause
#include "support/every_scheme.hpp"
#include "support/patch_templates.hpp"
#include "support/shuffled.hpp"
#include "support/tiles.hpp"
#include "support/under_sanitizers.hpp"

#include <kith/core/mask/hash_value.hpp>
#include <kith/refine_in_tiles.hpp>
#include <kith/schemes/crease/creases.hpp>
#include <kith/tiles/part/checksum.hpp>

#include <algorithm>
#include <cstddef>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace {

/// Calls test(scheme, mesh) for all schemes that can be refined in tiles.
template <class Test>
void for_each_reaching_scheme_and_shape(const Test& test)
{
    for_each_of_all_schemes_and_shape([&]<class Scheme>(const Scheme& scheme, const mesh3d& mesh) {
        if constexpr (kith::reaching_scheme<Scheme>)
            if (not under_sanitizers or mesh.face_count() <= 10)
                test(scheme, mesh);
    });
}

std::vector<std::uint32_t> one_part_per_face(std::size_t faces)
{
    return partitions::blocks(faces, faces);
}

bool has_double_edges(const mesh3d& mesh)
{
    const auto& t = mesh.topology();
    std::set<std::pair<std::uint32_t, std::uint32_t>> halfedges;
    for (std::uint32_t c = 0; c < t.corners(); ++c)
        halfedges.emplace(t.corner_vertex[c], t.target(c));
    return halfedges.size() != t.corners();
}

/// Returns creases on every fifth edge and on two vertices, with sharpness of many kinds.
kith::creases sharpened(const mesh3d& mesh, kith::crease_method method)
{
    kith::creases sharp(method);
    for (std::size_t e = 0; e < mesh.edge_count(); e += 5)
        sharp.sharpen_edge(e, e % 3 == 0 ? kith::infinitely_sharp : 0.4 * double(e % 7));
    sharp.sharpen_vertex(3, 1.5);
    sharp.sharpen_vertex(20, kith::infinitely_sharp);
    return sharp;
}

/// Compares patches with single steps in the tiles of a mesh, from each level on. Returns how often there were patches.
template <class Scheme>
std::size_t compare_last_in_patches(const mesh3d& mesh, const Scheme& scheme, int levels,
                                    std::span<const std::uint32_t> part_of, std::size_t parts)
{
    kith::tile_cutter cutter(mesh, scheme, part_of, parts);
    const int rings = kith::ring_schedule(scheme, levels)[0];
    auto rim = cutter.cut_rim(kith::ring_schedule(scheme, levels, 1)[0]);
    const kith::global_levels_of<Scheme> whole(cutter.counts(), std::move(rim.part), std::move(rim.scheme), levels);
    std::size_t compared = 0;
    for (std::size_t p = 0; p < parts; ++p) {
        auto job = cutter.cut(p, rings);
        std::vector<std::vector<std::byte>> in_patches;
        for (int level = 0; level < levels; ++level) {
            for (const auto& costs : {all_templates, some_templates})
                if (auto made = kith::last_in_patches(job.part, job.scheme, level, whole, costs))
                    in_patches.push_back(kith::pack(kith::tile_job{std::move(*made), scheme}));
            job.part = level + 1 == levels ? kith::refine_last(job.part, job.scheme, level, whole)
                                           : kith::refine_once(job.part, job.scheme, level, whole);
        }
        const auto in_steps = kith::pack(kith::tile_job{std::move(job.part), scheme});
        for (const auto& made : in_patches)
            EXPECT_EQ(made, in_steps) << "part " << p;
        compared += in_patches.size();
    }
    return compared;
}

} // namespace

TEST(refine_tile, makes_the_last_steps_in_patches)
{
    std::size_t compared = 0;
    for_each_reaching_scheme_and_shape([&](const auto& scheme, const mesh3d& mesh) {
        for (const std::uint32_t seed : {1, 2})
            compared += compare_last_in_patches(
                mesh, scheme, under_sanitizers ? 2 : 3, partitions::grown(mesh, 4, seed), 4);
    });
    EXPECT_GT(compared, 100U);
}

TEST(refine_tile, makes_the_last_steps_in_patches_beside_creases_and_irregular_vertices)
{
    const auto quads = native(shapes::shaken(shapes::torus(8, 10)));
    const auto triangles = native(shapes::shaken(shapes::torus_of_all_valences()));
    const auto open = native(shapes::shaken(shapes::triangulated(shapes::grid(7, 9))));
    const int levels = under_sanitizers ? 3 : 4;
    for (const auto method : {kith::crease_method::uniform, kith::crease_method::chaikin}) {
        const kith::catmull_clark scheme{.corners = kith::boundary_corner::kept, .sharpness = sharpened(quads, method)};
        EXPECT_GT(compare_last_in_patches(quads, scheme, levels, partitions::grown(quads, 5, 3), 5), 0U);
    }
    const int levels_of_triangles = levels - (under_sanitizers ? 1 : 0);
    for (const auto& mesh : {triangles, open}) {
        const auto parts = partitions::grown(mesh, 6, 2);
        EXPECT_GT(compare_last_in_patches(mesh, kith::loop{}, levels_of_triangles, parts, 6), 0U);
        EXPECT_GT(compare_last_in_patches(mesh, kith::butterfly{}, levels_of_triangles, parts, 6), 0U);
    }
    EXPECT_GT(compare_last_in_patches(triangles, kith::sqrt3{}, levels, partitions::grown(triangles, 3, 2), 3), 0U);
}

namespace {

/// A dual split that makes the faces of vertices first. The owner of an edge at its ends would then follow from these
/// faces.
struct vertices_first {
    static constexpr auto columns()
    {
        return kith::columns(kith::new_vertices(kith::per_corner),
                             kith::new_edges(kith::per_side, kith::per_end),
                             kith::new_faces(kith::per_vertex.of_degree([](const auto& v) { return v.valence(); }),
                                             kith::per_face.of_degree(kith::same_degree{}),
                                             kith::quads(kith::per_edge)));
    }
};

} // namespace

TEST(refine_tile, makes_the_last_steps_in_patches_where_faces_have_several_degrees)
{
    static_assert(kith::owners_keep_descendants<kith::doo_sabin>);
    static_assert(not kith::owners_keep_descendants<vertices_first>);
    const auto triangles = native(shapes::shaken(shapes::torus_of_all_valences()));
    const auto open = native(shapes::shaken(shapes::grid(7, 9)));
    const int levels = under_sanitizers ? 2 : 3;
    const auto parts = partitions::grown(triangles, 4, 2);
    EXPECT_GT(compare_last_in_patches(triangles, kith::doo_sabin{}, 3, parts, 4), 0U);
    EXPECT_GT(compare_last_in_patches(triangles, kith::mid_edge{}, levels + 1, parts, 4), 0U);
    EXPECT_GT(compare_last_in_patches(open, kith::nasri_hasbini{}, levels - 1, partitions::grown(open, 4, 2), 4), 0U);
}

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
        const auto name = name_of(scheme);
        const int levels = name == "sqrt3" or name == "mid-edge" or name == "4-8" ? 6 : 4;
        if (mesh.face_count() <= 20 and name != "nasri-hasbini") {
            EXPECT_EQ(tiles_differ(mesh, scheme, levels, partitions::scattered(mesh.face_count(), 3, 4), 3), "");
        }
    });
}

TEST(refine_tile, leaves_rings_of_ghosts_where_asked)
{
    for_each_reaching_scheme_and_shape([](const auto& scheme, const mesh3d& mesh) {
        for (const int rings : {1, 2})
            EXPECT_EQ(tiles_differ(mesh, scheme, 2, partitions::scattered(mesh.face_count(), 4, 3), 4, rings), "")
                << rings;
    });
}

TEST(refine_tile, reaches_no_farther_than_it_must)
{
    using namespace shapes;
    const auto triangles = {shaken(triangulated(torus(11, 13))),
                            with_flips(shaken(triangulated(torus(11, 13))), 1, 2000),
                            with_flips(shaken(triangulated(grid(11, 12))), 2, 2000)};
    const auto polygons = {shaken(torus(11, 13)),
                           with_joins(with_flips(shaken(triangulated(grid(11, 12))), 4, 2000), 5, 3000)};
    const auto run = [](const auto& scheme, const mesh3d& mesh, bool is_here = true) {
        SCOPED_TRACE(name_of(scheme));
        for (int rings = 0; rings <= (under_sanitizers ? 0 : 3); ++rings)
            EXPECT_EQ(rings_that_suffice(mesh, scheme, rings, 5) == reach_of(scheme, rings), is_here) << rings;
    };
    for (const auto& shape : triangles) {
        const auto mesh = native(shape);
        const bool is_open = count(mesh.topology()).boundary_edges != 0;
        run(kith::loop{}, mesh);
        run(kith::linear_triangles{}, mesh);
        run(kith::butterfly{}, mesh);
        if (is_open) // only at a boundary odd steps trisect edges
            run(kith::sqrt3{}, of_generation(mesh, 1));
    }
    for (const auto& shape : polygons) {
        const auto mesh = native(shape);
        run(kith::catmull_clark{}, mesh);
        run(kith::linear{}, mesh);
        run(kith::doo_sabin{}, mesh);
        run(kith::doo_sabin{.boundary = kith::doo_sabin_boundary::clamped}, mesh);
        run(kith::doo_sabin{.boundary = kith::doo_sabin_boundary::drop}, mesh);
        run(kith::nasri_hasbini{}, mesh);
        run(kith::mid_edge{}, mesh);
        run(kith::four_eight{}, kith::tri_quad(mesh));
        const bool is_irregular = mesh.topology().degree == 0; // Kobbelt's masks reach farther on irregular meshes
        run(kith::kobbelt{},
            is_irregular ? of_generation(kith::refine(mesh, kith::linear{}, 1), 0) : mesh,
            is_irregular);
    }
}

TEST(refine_tile, leaves_edges_and_ghosts_out_at_the_end)
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
        const kith::catmull_clark scheme{.corners = kith::boundary_corner::kept, .sharpness = sharpened(mesh, method)};
        EXPECT_EQ(tiles_differ(mesh, scheme, 3, partitions::scattered(mesh.face_count(), 5, 1), 5), "");
        EXPECT_EQ(tiles_differ(mesh, scheme, 3, partitions::blocks(mesh.face_count(), 3), 3), "");
    }
}

TEST(refine_tile, keeps_a_scheme_of_its_own)
{
    const auto mesh = native(shapes::shaken(shapes::torus(6, 8)));
    const auto scheme = [&] { return kith::catmull_clark{.sharpness = sharpened(mesh, kith::crease_method::chaikin)}; };
    const auto whole = kith::refine(mesh, scheme(), 2);
    const kith::partition parts{partitions::blocks(mesh.face_count(), 3), 3};
    kith::tiled_refinement refinement(mesh, scheme(), 2, parts); // the scheme no longer exists when tiles are cut
    kith::mesh_checksum sum;
    for (std::size_t t = 0; t < refinement.tiles(); ++t)
        sum += kith::checksum(refinement.refine(t));
    EXPECT_EQ(sum, kith::checksum(whole));
}

TEST(refine_tile, takes_any_order_of_vertices_faces_and_corners)
{
    for_each_reaching_scheme_and_shape([]<class Scheme>(const Scheme& scheme, const mesh3d& mesh) {
        if (kith::marks_edges<Scheme> and has_double_edges(mesh)) // faces do not tell double edges apart
            return;
        for (const std::uint32_t seed : {1, 2}) {
            const auto other = shuffled<Scheme>(mesh, seed);
            const std::size_t faces = other.face_count();
            EXPECT_EQ(tiles_differ(other, scheme, 2, partitions::scattered(faces, 5, seed), 7), "") << seed;
            EXPECT_EQ(tiles_differ(other, scheme, 2, partitions::grown(other, 4, seed), 4), "") << seed;
            if (faces <= 30) {
                EXPECT_EQ(tiles_differ(other, scheme, 2, one_part_per_face(faces), faces), "") << seed;
            }
        }
    });
}

TEST(refine_tile, takes_valences_from_3_to_17_polygons_and_creases)
{
    const auto triangles = native(shapes::shaken(shapes::torus_of_all_valences()));
    const auto polygons = native(shapes::with_joins(shapes::shaken(shapes::torus_of_all_valences()), 22, 10000));
    for (const auto& mesh : {triangles, polygons}) {
        std::set<std::size_t> valences;
        const kith::level_of<mesh3d> level(mesh);
        for (const auto v : level.vertices())
            valences.insert(v.valence());
        for (std::size_t n = 3; n <= 17; ++n)
            EXPECT_TRUE(valences.contains(n)) << n;
    }
    EXPECT_EQ(polygons.topology().degree, 0);

    const auto run = [](const auto& scheme, const mesh3d& mesh) {
        SCOPED_TRACE(name_of(scheme));
        EXPECT_EQ(tiles_differ(mesh, scheme, 2, partitions::grown(mesh, 5, 1), 5), "");
        if (not under_sanitizers) { // under sanitizers only small meshes are scattered
            EXPECT_EQ(tiles_differ(mesh, scheme, 2, partitions::scattered(mesh.face_count(), 3, 1), 3), "");
        }
    };
    for (const auto method : {kith::crease_method::uniform, kith::crease_method::chaikin}) {
        run(kith::catmull_clark{.corners = {}, .sharpness = sharpened(polygons, method)}, polygons);
        run(kith::loop{.weights = {}, .corners = {}, .sharpness = sharpened(triangles, method)}, triangles);
    }
    run(kith::sqrt3{}, triangles);
    run(kith::butterfly{}, triangles);
    run(kith::doo_sabin{}, polygons);
    run(kith::mid_edge{}, polygons);
    run(kith::nasri_hasbini{}, polygons);
    run(kith::four_eight{}, kith::tri_quad(polygons));
    run(kith::kobbelt{}, of_generation(kith::refine(polygons, kith::linear{}, 1), 0));
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
