// SPDX-License-Identifier: BSD-3-Clause
#include "support/error_text.hpp"
#include "support/native_shape.hpp"
#include "support/shapes.hpp"
#include "support/tiles.hpp"
#include "support/vtu_files.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/doo_sabin.hpp>
#include <kith/refine_in_tiles.hpp>
#include <kith/tiles/output/ply_file.hpp>
#include <kith/tiles/output/vtu_pieces.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <unistd.h>

namespace {

using point = std::array<double, 3>;
namespace fs = vtu_files::fs;
using vtu_files::directory;
using vtu_files::for_each_changed_byte;
using vtu_files::vtu_reader;

/// Compares the elements in a file, by their numbers in the whole mesh, with the mesh refined as a whole. Counts the
/// faces that are found.
template <class Mesh>
void expect_part_of(const vtu_reader& file, const std::vector<std::int64_t>& point_ids,
                    const std::vector<std::int64_t>& cell_ids, const Mesh& whole, std::vector<int>& found)
{
    const auto points = file.array<point>("NumberOfComponents=\"3\"");
    const auto corners = file.array<std::int64_t>("Name=\"connectivity\"");
    const auto ends = file.array<std::int64_t>("Name=\"offsets\"");
    const auto types = file.array<std::uint8_t>("Name=\"types\"");
    ASSERT_EQ(points.size(), point_ids.size());
    ASSERT_EQ(ends.size(), cell_ids.size());
    ASSERT_EQ(types.size(), cell_ids.size());
    for (std::size_t v = 0; v < points.size(); ++v)
        EXPECT_EQ(std::memcmp(&points[v], &whole.point(std::size_t(point_ids[v])), sizeof(point)), 0) << point_ids[v];
    std::size_t corner = 0;
    for (std::size_t c = 0; c < ends.size(); ++c) {
        const auto face = whole.face(std::size_t(cell_ids[c]));
        ASSERT_EQ(std::size_t(ends[c]), corner + face.size());
        EXPECT_EQ(types[c], face.size() == 3 ? 5 : face.size() == 4 ? 9 : 7);
        for (const auto v : face)
            EXPECT_EQ(point_ids[std::size_t(corners[corner++])], std::int64_t(v));
        ++found[std::size_t(cell_ids[c])];
    }
}

template <class Scheme>
void expect_pieces_of(const shapes::shape& shape, const Scheme& scheme, int levels)
{
    const auto control = native(shape);
    const auto whole = kith::refine(control, scheme, levels);
    const kith::partition parts{partitions::scattered(control.face_count(), 3, 7), 4}; // the last part is empty
    kith::tiled_refinement tiles(control, scheme, levels, parts);
    const directory here;
    const kith::vtu_pieces pieces(here.path.string(), "beside", 4, levels, true);
    auto index = kith::offset_file::create((here.path / "index.pvtu").string(), pieces.size());
    pieces.write_frame(index);
    std::vector<int> found(whole.face_count());
    for (std::uint32_t t = 0; t < 4; ++t) {
        EXPECT_FALSE(pieces.is_there(t));
        pieces.write_tile(index, tiles.refine(t), {t, 9});
        EXPECT_TRUE(pieces.is_there(t));
        const vtu_reader file(here.path / (std::to_string(t) + ".vtu"));
        const auto cell_ids = file.array<std::int64_t>("Name=\"GlobalCellIds\"");
        expect_part_of(file, file.array<std::int64_t>("Name=\"GlobalPointIds\""), cell_ids, whole, found);
        const auto parents = file.array<std::int64_t>("Name=\"parent\"");
        ASSERT_EQ(parents.size(), cell_ids.size());
        for (const auto parent : parents)
            EXPECT_EQ(parts.part_of[std::size_t(parent)], t);
        EXPECT_EQ(file.array<std::uint8_t>("Name=\"level\""), std::vector<std::uint8_t>(parents.size(), levels));
        EXPECT_EQ(file.array<std::uint32_t>("Name=\"tile\""), std::vector<std::uint32_t>(parents.size(), t));
        EXPECT_EQ(file.array<std::uint32_t>("Name=\"rank\""), std::vector<std::uint32_t>(parents.size(), 9));
    }
    EXPECT_EQ(found, std::vector<int>(whole.face_count(), 1));
}

} // namespace

TEST(vtu_pieces, hold_each_face_once_with_the_bits_and_numbers_of_the_whole)
{
    for (const int levels : {0, 1, 2}) {
        expect_pieces_of(shapes::grid(), kith::catmull_clark{}, levels);
        expect_pieces_of(shapes::l_shape(), kith::doo_sabin{}, levels);
        expect_pieces_of(shapes::tetrahedron(), kith::doo_sabin{}, levels);
    }
}

TEST(vtu_pieces, are_named_in_the_index)
{
    const directory here;
    const kith::vtu_pieces pieces(here.path.string(), "beside", 2, 1, false);
    auto file = kith::offset_file::create((here.path / "index").string(), pieces.size());
    pieces.write_frame(file);
    std::ifstream in(here.path / "index");
    const std::string text(std::istreambuf_iterator<char>(in), {});
    EXPECT_EQ(text.size(), pieces.size());
    EXPECT_NE(text.find("<Piece Source=\"beside/0.vtu\"/>\n<Piece Source=\"beside/1.vtu\"/>\n</PUnst"), text.npos);
    EXPECT_NE(text.find("<PPointData GlobalIds=\"GlobalPointIds\">"), text.npos);
    EXPECT_EQ(text.find("\"tile\""), text.npos);
}

TEST(offset_file, says_that_it_ends_early)
{
    const directory here;
    auto file = kith::offset_file::create((here.path / "file").string(), 8);
    std::array<char, 9> bytes{};
    EXPECT_NO_THROW(file.read(0, bytes.data(), 8));
    const std::string text = error_text<kith::write_error>([&] { file.read(0, bytes.data(), 9); });
    EXPECT_NE(text.find("file: cannot be read back (it ends early)"), text.npos) << text;
}

TEST(vtu_file, holds_what_any_reader_finds)
{
    const auto control = native(shapes::grid());
    const kith::doo_sabin scheme;
    const auto whole = kith::refine(control, scheme, 2);
    const kith::partition parts{partitions::blocks(control.face_count(), 3), 3};
    kith::tiled_refinement tiles(control, scheme, 2, parts);
    const kith::vtu_file layout(tiles.whole().counts(2), 2, false);
    const directory here;
    auto file = kith::offset_file::create((here.path / "whole.vtu").string(), layout.size());
    layout.write_frame(file);
    for (std::uint32_t t = 0; t < 3; ++t)
        layout.write_tile(file, tiles.refine(t), {t, 0});
    const vtu_reader reader(here.path / "whole.vtu");
    std::vector<std::int64_t> point_ids(whole.vertex_count()), cell_ids(whole.face_count());
    std::iota(point_ids.begin(), point_ids.end(), 0);
    std::iota(cell_ids.begin(), cell_ids.end(), 0);
    std::vector<int> found(whole.face_count());
    expect_part_of(reader, point_ids, cell_ids, whole, found);
    EXPECT_EQ(found, std::vector<int>(whole.face_count(), 1));
    EXPECT_NE(reader.head().find("NumberOfPoints=\"" + std::to_string(whole.vertex_count()) + "\""), std::string::npos);
}

namespace {

/// Changes every byte. Expects that the tile to which the byte belongs reports it, and that the sum of the file
/// changes.
template <class Layout>
void expect_differences(const Layout& layout, kith::tiled_refinement<point, std::uint32_t, kith::doo_sabin>& tiles,
                        std::size_t begin, std::size_t end)
{
    const directory here;
    const auto path = here.path / "whole";
    auto file = kith::offset_file::create(path.string(), layout.size());
    kith::summed_bytes frame(&file);
    layout.write_frame(frame);
    kith::byte_sum written = frame.sum();
    std::vector<kith::tile<point>> parts;
    for (std::uint32_t t = 0; t < 3; ++t) {
        parts.push_back(tiles.refine(t));
        kith::summed_bytes summed(&file);
        layout.write_tile(summed, parts.back(), {t, t});
        EXPECT_EQ(layout.difference(file, parts.back(), t), std::nullopt);
        EXPECT_NE(kith::sum_of_bytes(file, 0, layout.size()), written); // bytes of this tile are missing
        written += summed.sum();
    }
    for (const std::uint64_t cut : {std::uint64_t(0), std::uint64_t(1), std::uint64_t(302), layout.size() - 3}) {
        kith::byte_sum in_two = kith::sum_of_bytes(file, 0, cut);
        in_two += kith::sum_of_bytes(file, cut, layout.size());
        EXPECT_EQ(in_two, written);
    }
    for_each_changed_byte(path, begin, end, [&](std::size_t at, bool is_changed) {
        EXPECT_EQ(kith::sum_of_bytes(file, 0, layout.size()) == written, not is_changed) << at;
        std::size_t found = 0;
        for (std::uint32_t t = 0; t < 3; ++t)
            found += layout.difference(file, parts[t], t) == "byte " + std::to_string(at) + " of " + path.string();
        EXPECT_EQ(found, is_changed ? 1U : 0U) << at;
    });
}

} // namespace

TEST(stitched_file, finds_every_byte_that_is_another_one)
{
    const auto control = native(shapes::tetrahedron());
    const kith::partition parts{partitions::blocks(control.face_count(), 3), 3};
    kith::tiled_refinement tiles(control, kith::doo_sabin{}, 1, parts);
    const auto counts = tiles.whole().counts(1);
    const kith::ply_file ply(counts);
    expect_differences(ply, tiles, ply.size() - 24 * counts.vertices - counts.faces - 4 * counts.corners, ply.size());
    const kith::vtu_file vtu(counts, 1, false);
    const std::size_t tail = std::string("\n</AppendedData>\n</VTKFile>\n").size();
    expect_differences(vtu, tiles, vtu.size() - tail - counts.faces, vtu.size() - tail); // of the last array
}

TEST(vtu_pieces, finds_bytes_that_are_others_and_pieces_that_end_early)
{
    const auto control = native(shapes::grid());
    kith::tiled_refinement tiles(control, kith::doo_sabin{}, 1, {partitions::blocks(control.face_count(), 2), 2});
    const directory here;
    const kith::vtu_pieces pieces(here.path.string(), "beside", 2, 1, false);
    auto index = kith::offset_file::create((here.path / "index.pvtu").string(), pieces.size());
    const auto part = tiles.refine(1);
    pieces.write_tile(index, part, {1, 0});
    EXPECT_EQ(pieces.difference(index, part, 1), std::nullopt);
    const kith::byte_sum sum = pieces.sum_of_own_file(1);
    EXPECT_NE(sum, kith::byte_sum());
    EXPECT_EQ(pieces.sum_of_own_file(0), kith::byte_sum()); // this file does not exist
    const auto path = here.path / "1.vtu";
    fs::copy_file(path, here.path / "0.vtu");
    EXPECT_NE(pieces.sum_of_own_file(0), sum); // the file of another piece
    const std::size_t size = fs::file_size(path);
    for_each_changed_byte(path, size - 300, size, [&](std::size_t at, bool is_changed) {
        const auto differs = pieces.difference(index, part, 1);
        EXPECT_EQ(differs.value_or("nothing"),
                  is_changed ? "byte " + std::to_string(at) + " of " + path.string() : "nothing");
        EXPECT_EQ(pieces.sum_of_own_file(1) == sum, not is_changed) << at;
    });
    fs::resize_file(path, size + 1);
    EXPECT_NE(pieces.sum_of_own_file(1), sum);
    fs::resize_file(path, size - 1);
    EXPECT_NE(pieces.sum_of_own_file(1), sum);
    EXPECT_EQ(pieces.difference(index, part, 1), "the size of " + path.string());
}

TEST(stitched_file, refuses_vertices_without_a_finite_place)
{
    const auto control = native(shapes::cube());
    kith::tiled_refinement tiles(control, kith::doo_sabin{}, 1, {partitions::blocks(control.face_count(), 2), 2});
    const auto counts = tiles.whole().counts(1);
    const directory here;
    auto file = kith::offset_file::create((here.path / "file").string(), 1);
    for (const double large : {HUGE_VAL, -HUGE_VAL, std::nan("")}) {
        auto part = tiles.refine(1);
        kith::storage<point> points(part.mesh.points());
        points[3][2] = large;
        part.mesh = kith::basic_mesh<>(std::move(points), part.mesh.topology(), 1);
        const auto expect_refusal = [&](const kith::stitched_file& layout) {
            EXPECT_EQ(error_text<kith::mesh_error>([&] { layout.write_tile(file, part, {1, 0}); }),
                      "vertex " + std::to_string(part.vertex_ids[3]) +
                          " would not have finite coordinates; the coordinates of the input are too large");
        };
        expect_refusal(kith::vtu_file(counts, 1, false));
        expect_refusal(kith::ply_file(counts));
        expect_refusal(kith::vtu_pieces(here.path.string(), "beside", 2, 1, false));
    }
    EXPECT_FALSE(fs::exists(here.path / "1.vtu"));
}
