// SPDX-License-Identifier: BSD-3-Clause
#include <kith/tiles/output/file_array.hpp>

#include "support/all_shapes.hpp"
#include "support/error_text.hpp"
#include "support/last_tiles.hpp"
#include "support/native_shape.hpp"
#include "support/tiles.hpp"
#include "support/vtu_files.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/doo_sabin.hpp>
#include <kith/fields/with_fields.hpp>
#include <kith/hierarchy.hpp>
#include <kith/refine_in_tiles.hpp>
#include <kith/tiles/output/tile_journal.hpp>
#include <kith/tiles/output/vtu_pieces.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace vtu_files;
using vector3 = std::array<float, 3>;

/// Returns the scheme with heat and flow at vertices, a material on faces, and marks of vertices.
template <class Scheme>
auto with_values(const Scheme& scheme, const mesh3d& mesh)
{
    std::vector<double> heat;
    std::vector<vector3> flow;
    kith::storage<bool> marks(mesh.vertex_count());
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        heat.push_back(1 / double(v + 3));
        flow.push_back({float(v), float(v % 3), -1});
        marks[v] = v % 2 == 0;
    }
    std::vector<std::int16_t> material;
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        material.push_back(std::int16_t(f % 5) - 2);
    return kith::with_fields(scheme,
                             kith::on_vertices(heat, kith::by_mask{}),
                             kith::on_vertices(flow),
                             kith::on_faces(material),
                             kith::on_vertices(marks, kith::from_vertex{}));
}

template <class Call>
auto with_names(const Call& call)
{
    return call(kith::field_named<0>("heat"),
                kith::field_named<1>("flow & <more>"),
                kith::field_named<2>("material"),
                kith::field_named<3>("marks"));
}

template <class Scheme>
std::vector<kith::file_array> arrays()
{
    return with_names([](const auto&... fields) { return kith::arrays_of<Scheme>(fields...); });
}
template <class Scheme>
std::vector<kith::value_bytes> values(const Scheme& scheme)
{
    return with_names([&](const auto&... fields) { return kith::values_of(scheme, fields...); });
}

template <class T, class Field>
void expect_values(const vtu_reader& file, const std::string& name, const Field& whole,
                   const std::vector<std::int64_t>& ids)
{
    const auto found = file.array<T>("Name=\"" + name + "\"");
    ASSERT_EQ(found.size(), ids.size()) << name;
    for (std::size_t x = 0; x < ids.size(); ++x)
        EXPECT_EQ(found[x], whole[std::size_t(ids[x])]) << name << " at " << ids[x];
}

template <class Scheme>
void expect_all_values(const vtu_reader& file, const Scheme& whole, const std::vector<std::int64_t>& point_ids,
                       const std::vector<std::int64_t>& cell_ids)
{
    expect_values<double>(file, "heat", whole.template field<0>(), point_ids);
    expect_values<vector3>(file, "flow &amp; &lt;more&gt;", whole.template field<1>(), point_ids);
    expect_values<std::int16_t>(file, "material", whole.template field<2>(), cell_ids);
    expect_values<std::uint8_t>(file, "marks", whole.template field<3>(), point_ids);
}

std::vector<std::int64_t> numbers(std::size_t count)
{
    std::vector<std::int64_t> result(count);
    for (std::size_t i = 0; i < count; ++i)
        result[i] = std::int64_t(i);
    return result;
}

} // namespace

TEST(field_files, hold_what_any_reader_finds_the_same_bytes_for_all_tiles)
{
    const auto expect = [](const auto& plain, int levels) {
        const auto house = native(shapes::shaken(shapes::open_house())); // faces of several degrees
        const auto scheme = with_values(plain, house);
        using scheme_type = std::remove_const_t<decltype(scheme)>;
        kith::hierarchy whole(house, scheme);
        whole.refine(levels);
        const auto counts = counts_of(whole.finest());
        const directory here;
        std::string first_bytes;
        kith::mesh_checksum first_sum;
        for (const std::size_t parts : {1, 3, 7}) {
            const auto tiles = last_tiles(
                house, scheme, levels, {partitions::scattered(house.face_count(), parts, 5), parts});
            const kith::vtu_file layout(counts, levels, false, false, arrays<scheme_type>());
            auto file = kith::offset_file::create((here.path / "whole.vtu").string(), layout.size());
            layout.write_frame(file);
            kith::mesh_checksum sum;
            for (const auto& kept : tiles) {
                layout.write_tile(file, kept.part, {std::uint32_t(kept.number), 0}, values(kept.scheme));
                sum += kith::checksum_of_values(kept.part, arrays<scheme_type>(), values(kept.scheme));
            }
            file.close();
            expect_all_values(vtu_reader(here.path / "whole.vtu"),
                              whole.scheme(levels),
                              numbers(counts.vertices),
                              numbers(counts.faces));
            const std::string bytes = bytes_of(here.path / "whole.vtu");
            if (parts == 1)
                first_bytes = bytes, first_sum = sum;
            EXPECT_TRUE(bytes == first_bytes) << parts << " parts";
            EXPECT_EQ(sum, first_sum) << parts << " parts";

            const kith::vtu_pieces pieces(
                here.path.string(), "beside", parts, levels, false, false, arrays<scheme_type>());
            auto index = kith::offset_file::create((here.path / "index.pvtu").string(), pieces.size());
            pieces.write_frame(index);
            for (const auto& kept : tiles) {
                pieces.write_tile(index, kept.part, {std::uint32_t(kept.number), 0}, values(kept.scheme));
                const vtu_reader piece(here.path / (std::to_string(kept.number) + ".vtu"));
                expect_all_values(piece,
                                  whole.scheme(levels),
                                  piece.array<std::int64_t>("Name=\"GlobalPointIds\""),
                                  piece.array<std::int64_t>("Name=\"GlobalCellIds\""));
            }
            index.close();
            const std::string head = bytes_of(here.path / "index.pvtu");
            EXPECT_NE(
                head.find("<PDataArray type=\"Float32\" Name=\"flow &amp; &lt;more&gt;\" NumberOfComponents=\"3\"/>"),
                std::string::npos);
            EXPECT_NE(head.find("<PDataArray type=\"Int16\" Name=\"material\"/>"), std::string::npos);
        }
    };
    expect(kith::catmull_clark{}, 2);
    expect(kith::doo_sabin{}, 2);
}

TEST(field_files, every_byte_that_is_another_one_is_found)
{
    const auto torus = native(shapes::shaken(shapes::torus(3, 4)));
    const auto scheme = with_values(kith::catmull_clark{}, torus);
    using scheme_type = std::remove_const_t<decltype(scheme)>;
    const auto tiles = last_tiles(torus, scheme, 1, {partitions::blocks(torus.face_count(), 3), 3});
    const auto counts = counts_of(kith::refine(torus, kith::catmull_clark{}, 1));
    const directory here;
    const auto expect_found =
        [&](const kith::stitched_file& layout, const fs::path& path, std::size_t bytes, std::size_t some_tiles) {
            auto file = kith::offset_file::create((here.path / "whole").string(), layout.size());
            layout.write_frame(file);
            for (std::size_t t = 0; t < some_tiles; ++t)
                layout.write_tile(file, tiles[t].part, {std::uint32_t(t), 0}, values(tiles[t].scheme));
            const std::size_t size = fs::file_size(path),
                              end = size - std::string("\n</AppendedData>\n</VTKFile>\n").size();
            for_each_changed_byte(path, end - bytes, end, [&](std::size_t at, bool is_changed) {
                std::size_t found = 0;
                for (std::size_t t = 0; t < some_tiles; ++t)
                    found += layout.difference(file, tiles[t].part, std::uint32_t(t), values(tiles[t].scheme)) ==
                             "byte " + std::to_string(at) + " of " + path.string();
                EXPECT_EQ(found, is_changed ? 1U : 0U) << at;
            });
        };
    // The last array is that of the materials.
    expect_found(
        kith::vtu_file(counts, 1, false, false, arrays<scheme_type>()), here.path / "whole", 2 * counts.faces, 3);
    expect_found(kith::vtu_pieces(here.path.string(), "beside", 3, 1, false, false, arrays<scheme_type>()),
                 here.path / "0.vtu",
                 2 * owned_count(tiles[0].part.face_marks),
                 1);
}

/// Shows that the file has the same bytes if each tile writes a share of the arrays that follow from the number of
/// cells. Tiles verify their shares, too.
TEST(field_files, shares_of_cells_that_are_alike_give_the_same_bytes)
{
    const auto torus = native(shapes::shaken(shapes::torus(3, 4)));
    const auto counts = counts_of(kith::refine(torus, kith::catmull_clark{}, 1));
    const directory here;
    const fs::path path = here.path / "whole.vtu";
    for (const std::size_t parts : {1, 3, 7}) {
        const auto tiles = last_tiles(
            torus, kith::catmull_clark{}, 1, {partitions::scattered(torus.face_count(), parts, 5), parts});
        const auto written = [&](const kith::vtu_file& layout) {
            auto file = kith::offset_file::create(path.string(), layout.size());
            layout.write_frame(file);
            for (const auto& kept : tiles)
                layout.write_tile(file, kept.part, {std::uint32_t(kept.number), 0});
            file.close();
            return bytes_of(path);
        };
        const kith::vtu_file shared(counts, 1, false, false, {}, kith::alike_cells{4, parts});
        const std::string expected = written(kith::vtu_file(counts, 1, false));
        EXPECT_TRUE(written(shared) == expected) << parts << " parts";
        auto file = kith::offset_file::open(path.string());
        const std::size_t end = fs::file_size(path) - std::string("\n</AppendedData>\n</VTKFile>\n").size();
        for_each_changed_byte(path, end - counts.faces, end, [&](std::size_t at, bool is_changed) { // the levels
            std::size_t found = 0;
            for (const auto& kept : tiles)
                found += shared.difference(file, kept.part, std::uint32_t(kept.number)) ==
                         "byte " + std::to_string(at) + " of " + path.string();
            EXPECT_EQ(found, is_changed ? 1U : 0U) << at;
        });
    }
}

TEST(field_files, a_journal_tells_values_that_are_others)
{
    const auto torus = native(shapes::shaken(shapes::torus(3, 4)));
    const auto scheme = with_values(kith::catmull_clark{}, torus);
    using scheme_type = std::remove_const_t<decltype(scheme)>;
    auto kept = std::move(last_tiles(torus, scheme, 1, {partitions::blocks(torus.face_count(), 1), 1})[0]);
    const auto counts = counts_of(kith::refine(torus, kith::catmull_clark{}, 1));
    const directory here;
    const kith::vtu_file layout(counts, 1, false, false, arrays<scheme_type>());
    const kith::tile_journal journal(layout.size(), 1, 17);
    auto file = kith::offset_file::create((here.path / "whole").string(), journal.end());
    layout.write_frame(file);
    layout.write_tile(file, kept.part, {0, 0}, values(kept.scheme));
    const auto finished = [&] {
        kith::finished_tile result{counts.faces, kith::checksum(kept.part)};
        result.checksum += kith::checksum_of_values(kept.part, arrays<scheme_type>(), values(kept.scheme));
        return result;
    };
    journal.add(file, 0, finished());
    const auto is_as_written = [&] {
        const auto known = journal.read(file, 0);
        return known and known->checksum == finished().checksum;
    };
    EXPECT_TRUE(is_as_written());
    for_each_changed_byte(here.path / "whole", layout.size(), journal.end(), [&](std::size_t, bool is_changed) {
        EXPECT_EQ(is_as_written(), not is_changed);
    });
    kept.scheme.template field<2>()[3] = 9;
    EXPECT_FALSE(is_as_written());
}

TEST(field_files, say_for_which_words_numbers_stand)
{
    using enum kith::field_on;
    const directory here;
    const std::vector<kith::file_array> with_words{{"a & b", faces, "UInt8", 1, 1, {"", "hi"}},
                                                   {"c", faces, "UInt8", 1, 1}};
    const kith::vtu_file layout({4, 6, 4, 12}, 0, false, false, with_words);
    auto file = kith::offset_file::create((here.path / "file").string(), layout.size());
    layout.write_frame(file);
    file.close();
    const std::string bytes = bytes_of(here.path / "file");
    EXPECT_NE(bytes.find("<UnstructuredGrid>\n<FieldData>\n<DataArray type=\"String\" Name=\"a &amp; b\" "
                         "NumberOfTuples=\"2\" format=\"ascii\">\n0\n104 105 0\n</DataArray>\n</FieldData>\n<Piece"),
              std::string::npos)
        << bytes.substr(0, 600);
}

TEST(field_files, refuses_names_that_are_taken_and_fields_without_values)
{
    const auto torus = native(shapes::torus(3, 4));
    const auto scheme = with_values(kith::catmull_clark{}, torus);
    using scheme_type = std::remove_const_t<decltype(scheme)>;
    const kith::global_counts counts = counts_of(torus);
    for (const std::string name : {"level", "", "heat"}) {
        const auto text = error_text<kith::mesh_error>([&] {
            kith::vtu_file(counts,
                           0,
                           false,
                           false,
                           kith::arrays_of<scheme_type>(kith::field_named<0>("heat"), kith::field_named<1>(name)));
        });
        EXPECT_NE(text.find("a field cannot be named \"" + name + "\""), std::string::npos) << text;
    }
    const auto text_of = [&](std::vector<kith::file_array> fields) {
        return error_text<kith::mesh_error>([&] { kith::vtu_file(counts, 0, false, false, std::move(fields)); });
    };
    using enum kith::field_on;
    EXPECT_EQ(text_of({{"red", vertices, "UInt8", 1, 1}, {"red", faces, "UInt8", 1, 1}}), "no error");
    EXPECT_EQ(text_of({{"uv", corners, "Float32", 2, 8}}),
              "the field \"uv\" is on edges or corners, where a file of VTK has no values; leave it out");
    const auto tile = std::move(last_tiles(torus, scheme, 0, {partitions::blocks(torus.face_count(), 1), 1})[0]);
    const directory here;
    const kith::vtu_file layout(counts, 0, false, false, arrays<scheme_type>());
    auto file = kith::offset_file::create((here.path / "file").string(), layout.size());
    const auto text = [&](const auto& values) {
        return error_text<kith::mesh_error>([&] { layout.write_tile(file, tile.part, {0, 0}, values); });
    };
    EXPECT_EQ(text(values(tile.scheme)), "no error");
    EXPECT_NE(text(std::vector<kith::value_bytes>{}).find("4 arrays of values, a tile has 0"), std::string::npos);
    const auto empty = kith::detail::scheme_of_part(scheme, kith::part_numbers<std::uint32_t>());
    EXPECT_EQ(
        text(values(empty)),
        "the field \"heat\" has 0 values in a tile of 12 vertices; give it values on the control mesh, and refine the "
        "last level with its edges");
}
