// SPDX-License-Identifier: BSD-3-Clause
#include "support/all_shapes.hpp"
#include "support/error_text.hpp"
#include "support/last_tiles.hpp"
#include "support/same_mesh.hpp"
#include "support/some_fields.hpp"
#include "support/vtu_files.hpp"
#include "on_ranks.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/doo_sabin.hpp>
#include <kith/hierarchy.hpp>
#include <kith/mpi/ranks/gather.hpp>
#include <kith/mpi/ranks/repartition.hpp>
#include <kith/mpi/ranks/write_level.hpp>
#include <kith/refine_in_tiles.hpp>

#include <algorithm>
#include <fstream>
#include <numeric>

namespace {

namespace fs = vtu_files::fs;

/// A directory that all ranks see, and that is removed after the test. Collective.
class shared_directory {
public:
    shared_directory()
    {
        std::vector<std::byte> name;
        if (world().is_root()) {
            made_.emplace();
            const std::string text = made_->path.string();
            const auto bytes = std::as_bytes(std::span(text));
            name.assign(bytes.begin(), bytes.end());
        }
        for (const std::byte b : world().broadcast(std::move(name)))
            path_ += char(b);
    }
    [[nodiscard]] fs::path path() const { return path_; }

private:
    std::optional<vtu_files::directory> made_;
    std::string path_;
};

/// Returns the number of files that a job began and did not finish.
int unfinished_in(const fs::path& directory)
{
    return int(std::ranges::count_if(fs::directory_iterator(directory), [](const auto& entry) {
        return entry.path().filename().string().find(".incomplete") != std::string::npos;
    }));
}

template <class Scheme>
using kept_tiles = std::vector<kith::kept_tile<tile3d, Scheme>>;

/// Returns all levels of this rank's tiles after moving them to other ranks than those that refined them. Collective.
template <class Scheme>
kept_tiles<Scheme> kept_and_moved(const mesh3d& mesh, const Scheme& given, int levels, const kith::partition& parts)
{
    const auto without = some_fields::without_values(given);
    kith::mpi::rank_refinement refinement(world(), mesh, world().is_root() ? given : without, levels, parts, 0);
    auto kept = refinement.keep_levels(kith::mpi::sharing::spmd);
    const auto faces = kith::mpi::owned_faces(world(), kept, levels, parts.parts);
    EXPECT_EQ(std::reduce(faces.begin(), faces.end()), refinement.whole().counts(levels).faces);
    return kith::mpi::repartition(world(), std::move(kept), kith::mpi::balanced_ranks(faces, world().size()), without);
}

/// Expects that all points, faces and fields are those of the level that was refined as a whole.
template <class Gathered, class Levels>
void expect_gathered(const Gathered& gathered, const Levels& levels, int level)
{
    if (not world().is_root()) {
        EXPECT_EQ(gathered.mesh.vertex_count(), 0U);
        return;
    }
    ASSERT_EQ(gathered.mesh.vertex_count(), levels[level].vertex_count());
    ASSERT_EQ(gathered.mesh.face_count(), levels[level].face_count());
    for (std::size_t v = 0; v < gathered.mesh.vertex_count(); ++v)
        EXPECT_EQ(gathered.mesh.point(v), levels[level].point(v));
    for (std::size_t f = 0; f < gathered.mesh.face_count(); ++f)
        EXPECT_TRUE(std::ranges::equal(gathered.mesh.face(f), levels[level].face(f)));
    EXPECT_EQ(some_fields::difference(gathered.scheme, levels.scheme(level)), "");
    if constexpr (kith::scheme_with_creases<std::remove_cvref_t<decltype(gathered.scheme)>>) {
        EXPECT_EQ(gathered.scheme.sharpness.edges(), levels.scheme(level).sharpness.edges());
        EXPECT_EQ(gathered.scheme.sharpness.vertices(), levels.scheme(level).sharpness.vertices());
    }
}

} // namespace

TEST(gather, gives_one_rank_the_fields_and_creases_with_the_mesh)
{
    const auto house = native(shapes::shaken(shapes::open_house())); // faces of several degrees
    const auto expect = [&](const auto& plain) {
        const auto given = some_fields::with_some_fields(plain, house);
        kith::hierarchy levels(house, given);
        levels.refine(2);
        const auto kept = kept_and_moved(house, given, 2, scattered(house, 5, 3));
        for (const int level : {0, 1, 2})
            expect_gathered(
                kith::mpi::gather(
                    world(), kept, level, counts_of(levels[level]), 1 << 20, some_fields::without_values(given)),
                levels,
                level);
        const auto text = error_text<kith::mpi::phase_error>([&] {
            kith::mpi::gather(world(), kept, 2, counts_of(levels[2]), 10000, some_fields::without_values(given));
        });
        EXPECT_NE(text.find("and the limit is 10000"), std::string::npos) << text;
    };
    kith::catmull_clark creased;
    for (std::size_t e = 0; e < house.edge_count(); e += 3)
        creased.sharpness.sharpen_edge(e, e % 2 == 0 ? 1.5 : kith::infinitely_sharp);
    creased.sharpness.sharpen_vertex(2, 3.5);
    expect(creased);
    expect(kith::doo_sabin{});
}

TEST(write_level, writes_the_bytes_of_one_tile_on_any_ranks)
{
    const auto house = native(shapes::shaken(shapes::open_house()));
    const auto given = some_fields::with_some_fields(kith::catmull_clark{}, house);
    using scheme_type = std::remove_const_t<decltype(given)>;
    const auto names = [](const auto& call) {
        return call(kith::field_named<0>("material"), kith::field_named<4>("weight"), kith::field_named<5>("place"));
    };
    const shared_directory here;
    const auto kept = kept_and_moved(house, given, 2, scattered(house, 5, 3));
    kith::tiled_refinement whole(house, given, 2, in_blocks(house, 1));
    for (const int level : {1, 2}) {
        const auto counts = whole.whole().counts(level);
        const fs::path path = here.path() / "fine.vtu";
        names([&](const auto&... fields) {
            kith::mpi::write_level(world(), path.string(), kept, level, counts, fields...);
            if (not world().is_root())
                return;
            const kith::vtu_file layout(counts, level, false, false, kith::arrays_of<scheme_type>(fields...));
            auto file = kith::offset_file::create((here.path() / "alone.vtu").string(), layout.size());
            layout.write_frame(file);
            whole.refine_levels(0, [&](const auto& tile) {
                if (tile.level == level)
                    layout.write_tile(file, tile.part, {0, 0}, kith::values_of(tile.scheme, fields...));
            });
            EXPECT_TRUE(vtu_files::bytes_of(path) == vtu_files::bytes_of(here.path() / "alone.vtu"));
            EXPECT_EQ(unfinished_in(here.path()), 0);
        });
    }
    const auto counts = whole.whole().counts(2);
    names([&](const auto&... fields) {
        kith::mpi::write_level(world(), (here.path() / "fine.pvtu").string(), kept, 2, counts, fields...);
    });
    std::size_t cells = 0;
    for (int t = 0; world().is_root() and t < 5; ++t) {
        const vtu_files::vtu_reader piece(here.path() / "fine.pieces" / (std::to_string(t) + ".vtu"));
        cells += piece.array<int>("Name=\"material\"").size();
    }
    EXPECT_EQ(cells, world().is_root() ? counts.faces : 0);
}

TEST(write_level, says_what_is_wrong_and_leaves_nothing)
{
    const auto torus = native(shapes::torus(3, 4));
    const auto given = kith::with_fields(kith::catmull_clark{}, kith::on_vertices(std::vector<double>(12, 1.5)));
    kith::mpi::rank_refinement refinement(world(), torus, given, 1, in_blocks(torus, 3), 0);
    auto kept = refinement.keep_levels(kith::mpi::sharing::spmd);
    const auto counts = refinement.whole().counts(1);
    const shared_directory here;
    const auto text = [&](const std::string& name, int level) {
        return error_text<kith::mpi::phase_error>([&] {
            kith::mpi::write_level(
                world(), (here.path() / name).string(), kept, level, counts, kith::field_named<0>("heat"));
        });
    };
    EXPECT_EQ(text("a.vtu", 1), "no error");
    EXPECT_NE(text("a.obj", 1).find("name such a file"), std::string::npos);
    EXPECT_NE(text("a.vtu", 0).find("own 12 faces, the level has 48"), std::string::npos);
    EXPECT_NE(text("nowhere/a.vtu", 1).find("cannot be opened"), std::string::npos);
    for (auto& tile : kept)
        tile.number = 3 * tile.number + 2;
    EXPECT_EQ(text("c.vtu", 1), "no error");
    EXPECT_TRUE(text("c.pvtu", 1).ends_with("does not exist, there are 3; number them from 0 to 2"))
        << text("c.pvtu", 1);
    EXPECT_FALSE(fs::exists(here.path() / "c.pvtu"));
    for (auto& tile : kept)
        tile.scheme = some_fields::without_values(tile.scheme);
    EXPECT_NE(text("b.vtu", 1).find("the field \"heat\" has 0 values"), std::string::npos);
    EXPECT_NE(text("b.pvtu", 1).find("number them from 0 to 2"), std::string::npos);
    for (auto& tile : kept)
        tile.number /= 3;
    EXPECT_NE(text("b.pvtu", 1).find("the field \"heat\" has 0 values"), std::string::npos);
    EXPECT_NE(text(world().is_root() ? "b.vtu" : "c.vtu", 1)
                  .find(world().size() == 1 ? "has 0 values" : "differs from rank 0"),
              std::string::npos);
    if (world().is_root()) {
        EXPECT_FALSE(fs::exists(here.path() / "b.vtu"));
        EXPECT_FALSE(fs::exists(here.path() / "b.pvtu"));
        EXPECT_EQ(unfinished_in(here.path()), 0);
    }
}

TEST(write_level, of_several_jobs_with_one_path_do_not_disturb_each_other)
{
    const auto torus = native(shapes::shaken(shapes::torus(5, 6)));
    const auto given = kith::with_fields(kith::catmull_clark{}, kith::on_vertices(std::vector<double>(30, 1.5)));
    const shared_directory here;
    const auto write = [&](kith::mpi::communicator& comm, const std::string& name) {
        kith::mpi::rank_refinement refinement(comm, torus, given, 2, in_blocks(torus, 4), 0);
        const auto kept = refinement.keep_levels(kith::mpi::sharing::spmd);
        kith::mpi::write_level(
            comm, (here.path() / name).string(), kept, 2, refinement.whole().counts(2), kith::field_named<0>("heat"));
    };
    write(world(), "alone.vtu");
    write(world(), "alone.pvtu");
    MPI_Comm jobs = MPI_COMM_NULL; // each rank is a job of its own
    MPI_Comm_split(MPI_COMM_WORLD, world().rank(), 0, &jobs);
    {
        kith::mpi::communicator alone(jobs);
        for (int times = 0; times < 5; ++times)
            for (const char* name : {"many.vtu", "many.pvtu"})
                EXPECT_EQ(error_text<std::exception>([&] { write(alone, name); }), "no error") << name;
    }
    MPI_Comm_free(&jobs);
    world().agree("");
    EXPECT_TRUE(vtu_files::bytes_of(here.path() / "many.vtu") == vtu_files::bytes_of(here.path() / "alone.vtu"));
    for (int t = 0; t < 4; ++t) {
        const std::string piece = std::to_string(t) + ".vtu";
        EXPECT_TRUE(vtu_files::bytes_of(here.path() / "many.pieces" / piece) ==
                    vtu_files::bytes_of(here.path() / "alone.pieces" / piece));
    }
    EXPECT_EQ(unfinished_in(here.path()), 0);
    world().agree("");
    if (world().is_root())
        std::ofstream(here.path() / "many.pieces" / "notes.txt") << "mine";
    EXPECT_NE(error_text<kith::mpi::phase_error>([&] { write(world(), "many.pvtu"); }).find("but holds notes.txt"),
              std::string::npos);
}
