// SPDX-License-Identifier: BSD-3-Clause
#include "support/all_shapes.hpp"
#include "support/error_text.hpp"
#include "support/same_mesh.hpp"
#include "on_ranks.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/doo_sabin.hpp>
#include <kith/hierarchy.hpp>
#include <kith/mpi/ranks/gather.hpp>
#include <kith/mpi/ranks/repartition.hpp>

namespace {

/// The origin of each element of the last level in the whole mesh: its tuple and, for faces, the face of level 0.
struct parents {
    std::vector<std::pair<kith::tuple_kind, std::size_t>> of_vertex, of_edge, of_face;
    std::vector<std::size_t> root_of_face;
};

parents parents_of(const mesh3d& control, const kith::catmull_clark& scheme)
{
    parents result;
    mesh3d mesh = control;
    for (std::size_t f = 0; f < control.face_count(); ++f)
        result.root_of_face.push_back(f);
    for (int level = 0; level < 2; ++level) {
        const kith::level_of<mesh3d> elements(mesh);
        const kith::numbering_of<kith::catmull_clark, std::uint32_t> ids(elements, kith::catmull_clark::columns());
        const auto origins = [](const auto& of) {
            std::vector<std::pair<kith::tuple_kind, std::size_t>> list;
            for (std::size_t id = 0; id < of.total(); ++id)
                list.push_back(of.origin(id));
            return list;
        };
        const auto roots = result.root_of_face;
        result = {origins(ids.vertices), origins(ids.edges), origins(ids.faces), {}};
        for (const auto& [kind, corner] : result.of_face)
            result.root_of_face.push_back(roots[elements.corners()[corner].f().index()]);
        mesh = kith::refine(mesh, scheme, 1);
    }
    return result;
}

bool same(const kith::global_tuple& a, const std::pair<kith::tuple_kind, std::size_t>& b)
{
    return a.kind == b.first and a.id == b.second;
}

} // namespace

TEST(repartition, keeps_tiles_and_their_parents)
{
    const auto control = native(shapes::shaken(shapes::open_house()));
    const kith::catmull_clark scheme;
    const auto whole_mesh = kith::refine(control, scheme, 2);
    const auto expected = parents_of(control, scheme);
    const auto parts = scattered(control, 7, 1);
    kith::mpi::rank_refinement refinement(world(), control, scheme, 2, parts, 1);
    tiles3d tiles;
    refinement.refine(kith::mpi::sharing::manager,
                      [&](std::uint64_t number, tile3d&& part) { tiles.push_back({number, std::move(part)}); });
    std::vector<int> rank_of(parts.parts);
    for (std::size_t t = 0; t < rank_of.size(); ++t)
        rank_of[t] = int((3 * t + 1) % std::size_t(world().size()));
    tiles = kith::mpi::repartition(world(), std::move(tiles), rank_of);

    std::vector<int> vertices(whole_mesh.vertex_count()), edges(whole_mesh.edge_count()),
        faces(whole_mesh.face_count());
    const auto& numbers = refinement.whole().numbering(1);
    std::uint64_t last = 0;
    for (const auto& [number, part] : tiles) {
        EXPECT_EQ(rank_of[number], world().rank());
        EXPECT_GE(number, last);
        last = number;
        EXPECT_EQ(difference(part, whole_mesh, vertices, edges, faces), "");
        for (const auto id : part.vertex_ids)
            EXPECT_TRUE(same(numbers.vertices.origin(id), expected.of_vertex[id])) << id;
        for (const auto id : part.edge_ids)
            EXPECT_TRUE(same(numbers.edges.origin(id), expected.of_edge[id])) << id;
        for (std::size_t f = 0; f < part.face_ids.size(); ++f) {
            EXPECT_TRUE(same(numbers.faces.origin(part.face_ids[f]), expected.of_face[part.face_ids[f]]));
            EXPECT_EQ(part.root(f), expected.root_of_face[part.face_ids[f]]);
        }
    }
    const auto owners = world().sum(std::vector<std::uint64_t>(faces.begin(), faces.end()));
    EXPECT_TRUE(std::ranges::all_of(owners, [](std::uint64_t n) { return n == 1; }));
}

TEST(repartition, gives_ranks_about_as_many_faces_each)
{
    EXPECT_EQ(kith::mpi::balanced_ranks(std::vector<std::uint64_t>{5, 9, 5, 1, 0, 9}, 3),
              (std::vector<int>{2, 0, 2, 0, 1, 1}));
    const auto torus = native(shapes::shaken(shapes::torus(5, 7)));
    kith::partition parts{std::vector<std::uint32_t>(torus.face_count()), 8};
    for (std::size_t f = 0; f < torus.face_count(); ++f)
        parts.part_of[f] = f < 15 ? 0 : std::uint32_t(f % 8); // one part is far too large
    auto tiles = refined_tiles(torus, kith::catmull_clark{}, 1, parts, 1);
    const auto faces = kith::mpi::owned_faces(world(), std::span<const kith::numbered_tile<tile3d>>(tiles), 8);
    std::vector<std::uint64_t> expected(8);
    for (const auto part : parts.part_of)
        expected[part] += 4;
    EXPECT_EQ(faces, expected);
    tiles = kith::mpi::repartition(world(), std::move(tiles), kith::mpi::balanced_ranks(faces, world().size()));
    std::vector<std::uint64_t> load(std::size_t(world().size()));
    for (const auto& [number, part] : tiles)
        load[std::size_t(world().rank())] += faces[number];
    load = world().sum(load);
    EXPECT_EQ(std::reduce(load.begin(), load.end()), 4 * torus.face_count());
    const std::uint64_t fair = 4 * torus.face_count() / std::uint64_t(world().size());
    EXPECT_LE(std::ranges::max(load), std::max(expected[0], fair + fair / 3));
}

TEST(repartition, keeps_normals)
{
    const auto torus = native(shapes::torus(6, 6));
    auto tiles = refined_tiles(torus, kith::catmull_clark{}, 1, in_blocks(torus, 4), 0);
    const auto normal_of = [](kith::global_id v) { return std::array{double(v), 0.5, -double(v)}; };
    for (auto& [number, part] : tiles) {
        part.normals = kith::storage<std::array<double, 3>>(part.vertex_ids.size());
        std::ranges::transform(part.vertex_ids, part.normals.begin(), normal_of);
    }
    const std::vector<int> rank_of(4, world().size() - 1);
    tiles = kith::mpi::repartition(world(), std::move(tiles), rank_of);
    EXPECT_EQ(tiles.size(), world().rank() == world().size() - 1 ? 4U : 0U);
    for (const auto& [number, part] : tiles)
        EXPECT_TRUE(std::ranges::equal(part.normals, part.vertex_ids, {}, {}, normal_of)) << number;
    for (auto& [number, part] : tiles) {
        part.normals = kith::storage<std::array<double, 3>>(3);
        const auto bytes = kith::pack(kith::tile_job<tile3d, kith::catmull_clark>{std::move(part), {}});
        EXPECT_EQ(error_text<kith::pack_error>(
                      [&] { kith::unpack<std::array<double, 3>, std::uint32_t>(bytes, kith::catmull_clark{}); }),
                  "a message holds a tile that has more or fewer normals than vertices; its sender is at fault");
    }
}

TEST(repartition, refuses_ranks_that_do_not_exist)
{
    const auto torus = native(shapes::torus(5, 7));
    for (const std::vector<int>& rank_of : {std::vector<int>{0, 0}, std::vector<int>{0, 0, world().size()}}) {
        const std::string text = error_text<kith::mpi::phase_error>([&] {
            kith::mpi::repartition(
                world(), refined_tiles(torus, kith::catmull_clark{}, 1, in_blocks(torus, 3), 1), rank_of);
        });
        EXPECT_NE(text.find("tile 2"), std::string::npos) << text;
    }
}

TEST(gather, gives_one_rank_the_mesh_that_refine_makes)
{
    const auto expect = [](const auto& scheme, const mesh3d& control, int levels, const kith::partition& tiles) {
        kith::mpi::rank_refinement refinement(world(), control, scheme, levels, tiles);
        tiles3d parts;
        refinement.refine(kith::mpi::sharing::spmd,
                          [&](std::uint64_t number, tile3d&& part) { parts.push_back({number, std::move(part)}); });
        const auto gathered = kith::mpi::gather(
            world(), std::span<const kith::numbered_tile<tile3d>>(parts), refinement.whole().counts(levels), 1 << 20);
        if (world().is_root())
            EXPECT_TRUE(same_bits(gathered, kith::refine(control, scheme, levels, {kith::connect::faces})));
        else
            EXPECT_EQ(gathered.vertex_count(), 0U);
    };
    const auto house = native(shapes::shaken(shapes::open_house()));
    expect(kith::catmull_clark{}, house, 2, scattered(house, 9, 3));
    expect(kith::doo_sabin{}, house, 2, scattered(house, 3, 3)); // with faces of many degrees
    for (const std::size_t row : {6, 18}) {                      // some tiles have only quads
        const auto torus = native(shapes::shaken(shapes::torus_with_two_triangles(24, 24 * row)));
        expect(kith::doo_sabin{}, torus, 2, in_blocks(torus, 2));
        expect(kith::doo_sabin{}, torus, 2, in_blocks(torus, 7));
    }
}

TEST(rank_refinement, refuses_tiles_that_are_not_there)
{
    const auto torus = native(shapes::torus(5, 7));
    kith::mpi::rank_refinement refinement(world(), torus, kith::catmull_clark{}, 1, in_blocks(torus, 3));
    const auto refine = [&](const std::vector<std::uint64_t>& numbers) {
        return error_text<kith::mpi::phase_error>(
            [&] { refinement.refine(kith::mpi::sharing::spmd, numbers, [](std::uint64_t, tile3d&&) {}); });
    };
    EXPECT_EQ(refine({2}), "no error");
    EXPECT_NE(refine({1, 3}).find("tile 3 does not exist; there are 3"), std::string::npos) << refine({1, 3});
}

TEST(rank_refinement, refuses_tiles_whose_numbers_it_cannot_ask_for)
{
    const auto torus = native(shapes::torus(6, 6));
    const auto parts = in_blocks(torus, 3);
    const kith::catmull_clark scheme;
    const auto text = [&](const std::vector<std::uint64_t>& numbers) {
        kith::tile_cutter cutter(torus, scheme, parts.part_of, parts.parts);
        auto tiles = cut_tiles_of_rank(cutter, parts.parts, kith::ring_schedule(scheme, 1, 0)[0]);
        for (auto& tile : tiles)
            tile.number = numbers[tile.number];
        return error_text<kith::mpi::phase_error>(
            [&] { kith::mpi::rank_refinement(world(), std::move(tiles), cutter.counts(), scheme, 1); });
    };
    EXPECT_EQ(text({2, 0, 1}), "no error");
    EXPECT_EQ(text({1, 2, 3}), "tile 3 does not exist, there are 3; number them from 0 to 2");
    EXPECT_EQ(text({0, 2, 2}), "tile 2 is held 2 times; give each tile a number of its own");
}

TEST(rank_refinement, uses_up_tiles_that_lay_on_their_ranks)
{
    const auto torus = native(shapes::torus(6, 6));
    const auto parts = in_blocks(torus, 5);
    const kith::catmull_clark scheme;
    kith::tile_cutter cutter(torus, scheme, parts.part_of, parts.parts);
    auto tiles = cut_tiles_of_rank(cutter, parts.parts, kith::ring_schedule(scheme, 1, 0)[0]);
    kith::mpi::rank_refinement refinement(world(), std::move(tiles), cutter.counts(), scheme, 1);
    const auto text = [&](const std::vector<std::uint64_t>& numbers) {
        return error_text<kith::mpi::phase_error>(
            [&] { refinement.refine(kith::mpi::sharing::spmd, numbers, [](std::uint64_t, tile3d&&) {}); });
    };
    EXPECT_EQ(text({0, 3}), "no error");
    EXPECT_EQ(text({1, 3, 4}), "tile 3 was already used on this rank; give its level 0 to another rank_refinement");
    EXPECT_EQ(text({1, 2, 4}), "no error");
    EXPECT_NE(text({1}).find("tile 1 was already used"), std::string::npos);
}

TEST(gather, refuses_what_is_too_large_or_not_all)
{
    const auto torus = native(shapes::torus(5, 7));
    auto tiles = refined_tiles(torus, kith::catmull_clark{}, 1, in_blocks(torus, 3), 1);
    const kith::global_counts counts{140, 280, 140, 560};
    const auto text = [&](std::uint64_t limit) {
        return error_text<kith::mpi::phase_error>(
            [&] { kith::mpi::gather(world(), std::span<const kith::numbered_tile<tile3d>>(tiles), counts, limit); });
    };
    EXPECT_EQ(text(140 * 24 + 560 * 4), "no error");
    EXPECT_EQ(
        text(140 * 24 + 560 * 4 - 1),
        "the level has 140 vertices and 140 faces, 5600 bytes on one rank, and the limit is 5599; gather a coarser "
        "level, or write the tiles into one file");
    std::erase_if(tiles, [](const auto& tile) { return tile.number == 1; });
    EXPECT_NE(text(1 << 20).find("give all tiles of the level"), std::string::npos);
}
