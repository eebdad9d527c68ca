// SPDX-License-Identifier: BSD-3-Clause
#include <kith/tiles/output/ply_file.hpp>

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
#include <kith/refine.hpp>
#include <kith/tiles/number/largest_degree.hpp>
#include <kith/tiles/ply/ply_header.hpp>
#include <kith/tiles/refine/cut_tiles.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace vtu_files;
using uv_type = std::array<float, 2>;

const std::vector<kith::file_array> arrays{{"material", kith::field_on::faces, "Int16", 1, 2},
                                           {"heat", kith::field_on::vertices, "Float64", 1, 8},
                                           {"texcoord", kith::field_on::corners, "Float32", 2, 8},
                                           {"marks", kith::field_on::vertices, "UInt8", 1, 1}};

template <class Scheme>
auto with_values(const Scheme& scheme, const mesh3d& mesh)
{
    std::vector<std::int16_t> material;
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        material.push_back(std::int16_t(f % 5) - 2);
    std::vector<double> heat;
    kith::storage<bool> marks(mesh.vertex_count());
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        heat.push_back(1 / double(v + 3));
        marks[v] = v % 2 == 0;
    }
    std::vector<std::array<float, 2>> uv;
    for (std::size_t c = 0; c < mesh.corner_count(); ++c)
        uv.push_back({float(c), 1 / float(c + 1)});
    return kith::with_fields(scheme,
                             kith::on_faces(material, kith::from_parent<std::identity, std::int16_t>{{}, 77}),
                             kith::on_vertices(heat, kith::by_mask{}),
                             kith::on_corners(uv),
                             kith::on_vertices(marks, kith::from_vertex{}));
}

template <class Scheme>
std::vector<kith::value_bytes> values(const Scheme& scheme)
{
    return {std::as_bytes(scheme.template field<0>().values()),
            std::as_bytes(scheme.template field<1>().values()),
            std::as_bytes(scheme.template field<2>().values()),
            std::as_bytes(scheme.template field<3>().values())};
}

kith::partition in_blocks(const mesh3d& mesh, std::size_t parts)
{
    return {partitions::blocks(mesh.face_count(), parts), parts};
}

template <class Tiles>
void write(const kith::ply_file& layout, const fs::path& path, const Tiles& tiles)
{
    auto file = kith::offset_file::create(path.string(), layout.size());
    layout.write_frame(file);
    for (std::size_t t = tiles.size(); t-- > 0;)
        layout.write_tile(file, tiles[t].part, {std::uint32_t(t), 0}, values(tiles[t].scheme));
    file.close();
}

/// A reader of numbers, one after the other.
class reader {
public:
    explicit reader(std::string bytes) : bytes_(std::move(bytes)) { at_ = bytes_.find("end_header\n") + 11; }

    template <class T>
    T next()
    {
        T result;
        std::memcpy(&result, bytes_.data() + at_, sizeof result);
        at_ += sizeof result;
        return result;
    }
    [[nodiscard]] bool is_at_end() const { return at_ == bytes_.size(); }

private:
    std::string bytes_;
    std::size_t at_;
};

template <class Scheme>
void expect_fields(const Scheme& plain, int levels)
{
    const auto house = native(shapes::shaken(shapes::open_house())); // faces of several degrees
    const auto scheme = with_values(plain, house);
    kith::hierarchy whole(house, scheme);
    whole.refine(levels);
    const auto& mesh = whole.finest();
    const auto& last = whole.scheme(levels);
    const directory here;
    std::string first;
    for (const std::size_t parts : {1, 3, 5}) {
        const kith::ply_file layout(counts_of(mesh), false, arrays);
        write(layout, here.path / "file", last_tiles(house, scheme, levels, in_blocks(house, parts)));
        const std::string bytes = bytes_of(here.path / "file");
        ASSERT_EQ(bytes.size(), layout.size());
        if (parts != 1) {
            EXPECT_TRUE(bytes == first);
            continue;
        }
        first = bytes;
        EXPECT_NE(bytes.find("property double z\nproperty double heat\nproperty uchar marks\nelement face"),
                  std::string::npos);
        EXPECT_NE(bytes.find("property list uchar int vertex_indices\nproperty list uchar float texcoord\n"
                             "property short material\nend_header\n"),
                  std::string::npos);
        reader in(bytes);
        for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
            EXPECT_EQ(in.next<shapes::point>(), mesh.point(v));
            EXPECT_EQ(in.next<double>(), last.template field<1>()[v]);
            EXPECT_EQ(in.next<std::uint8_t>(), last.template field<3>()[v] ? 1 : 0);
        }
        for (std::size_t f = 0, c = 0; f < mesh.face_count(); ++f) {
            const std::size_t degree = mesh.face(f).size();
            EXPECT_EQ(in.next<std::uint8_t>(), degree);
            for (const auto v : mesh.face(f))
                EXPECT_EQ(in.next<std::int32_t>(), std::int32_t(v));
            EXPECT_EQ(in.next<std::uint8_t>(), 2 * degree);
            for (std::size_t k = 0; k < degree; ++k)
                EXPECT_EQ(in.next<uv_type>(), last.template field<2>()[c++]);
            EXPECT_EQ(in.next<std::int16_t>(), last.template field<0>()[f]);
        }
        EXPECT_TRUE(in.is_at_end());
    }
}

} // namespace

TEST(ply_file, holds_fields_where_any_reader_finds_them_the_same_bytes_for_all_tiles)
{
    expect_fields(kith::catmull_clark(), 0);
    expect_fields(kith::catmull_clark(), 2);
    expect_fields(kith::doo_sabin(), 2);
}

TEST(ply_file, finds_every_value_that_is_another_one)
{
    const auto torus = native(shapes::shaken(shapes::torus(3, 4)));
    const auto scheme = with_values(kith::catmull_clark(), torus);
    const auto tiles = last_tiles(torus, scheme, 1, in_blocks(torus, 3));
    const directory here;
    const kith::ply_file layout(counts_of(kith::refine(torus, kith::catmull_clark(), 1)), false, arrays);
    const fs::path path = here.path / "file";
    write(layout, path, tiles);
    auto file = kith::offset_file::open(path.string());
    const std::size_t of_face = 1 + 4 * 4 + 1 + 4 * 8 + 2;
    for_each_changed_byte(path, layout.size() - 12 * of_face, layout.size(), [&](std::size_t at, bool is_changed) {
        std::size_t found = 0;
        for (std::size_t t = 0; t < tiles.size(); ++t)
            found += layout.difference(file, tiles[t].part, std::uint32_t(t), values(tiles[t].scheme)) ==
                     "byte " + std::to_string(at) + " of " + path.string();
        EXPECT_EQ(found, is_changed ? 1U : 0U) << at;
    });
}

TEST(ply_file, says_words_in_comments)
{
    const auto cube = native(shapes::cube());
    kith::file_array groups{"smoothing group", kith::field_on::faces, "Int32", 1, 4, {"", "left side", "7"}};
    const kith::ply_file layout(counts_of(cube), false, {groups}, {"mtllib my paint.mtl", "TextureFile skin.png"});
    const directory here;
    auto file = kith::offset_file::create((here.path / "file").string(), layout.size());
    layout.write_frame(file);
    file.close();
    const std::string begin =
        "ply\nformat binary_little_endian 1.0\ncomment written by kith\ncomment mtllib my paint.mtl\ncomment "
        "TextureFile skin.png\n"
        "comment word smoothing_group 1 left side\ncomment word smoothing_group 2 7\nelement vertex 8\n";
    const std::string bytes = bytes_of(here.path / "file");
    EXPECT_EQ(bytes.substr(0, begin.size()), begin);
    EXPECT_NE(bytes.find("\nproperty int smoothing_group\nend_header\n"), std::string::npos);
    const auto comments = kith::read_ply_header(bytes).comments;
    EXPECT_EQ(kith::words_in_ply(comments, groups.name), groups.words);
    EXPECT_EQ(kith::words_in_ply(comments, "group"), std::vector<std::string>());
    EXPECT_EQ(kith::file_lines_in_ply(comments),
              (std::vector<std::string>{"mtllib my paint.mtl", "TextureFile skin.png"}));
}

TEST(ply_file, refuses_what_the_format_has_no_room_for)
{
    using enum kith::field_on;
    const auto text = [](std::vector<kith::file_array> fields) {
        return error_text<kith::mesh_error>([&] { kith::ply_file({4, 6, 4, 12}, false, std::move(fields)); });
    };
    EXPECT_EQ(text(arrays), "no error");
    EXPECT_EQ(text({{"owner", vertices, "UInt64", 1, 8}}),
              "the field \"owner\" has numbers of type UInt64, which PLY has not; write .vtu");
    for (const kith::file_array& flow :
         {kith::file_array{"flow", vertices, "Float32", 3, 12}, kith::file_array{"flow", faces, "Float32", 3, 12}})
        EXPECT_NE(text({flow}).find("the field \"flow\" has no place in PLY"), std::string::npos);
    const auto is_taken = [&](const std::string& name, kith::field_on on) {
        const auto said = text(
            {{"heat", vertices, "Float32", 1, 4}, {"a b", faces, "Float32", 1, 4}, {name, on, "Float32", 1, 4}});
        return said.find("\"" + name + "\": the name is empty, or") != std::string::npos;
    };
    for (const std::string name : {"", "x", "z", "heat"})
        EXPECT_TRUE(is_taken(name, vertices)) << name;
    for (const std::string name : {"", "vertex_indices", "a_b"})
        EXPECT_TRUE(is_taken(name, faces)) << name;
    EXPECT_TRUE(is_taken("a b", corners));
    for (const std::string name : {"nx", "a b"})
        EXPECT_FALSE(is_taken(name, vertices)) << name;
    EXPECT_FALSE(is_taken("heat", faces));
    EXPECT_NE(text({arrays[2], {"more", corners, "Float32", 1, 4}}).find("the field \"more\" has no place in PLY"),
              std::string::npos);

    const auto cube = native(shapes::cube());
    auto tiles = last_tiles(cube, with_values(kith::catmull_clark(), cube), 0, in_blocks(cube, 1));
    tiles[0].scheme.template field<2>()[5][1] = std::numeric_limits<float>::quiet_NaN();
    const directory here;
    EXPECT_EQ(error_text<kith::mesh_error>(
                  [&] { write(kith::ply_file(counts_of(cube), false, arrays), here.path / "file", tiles); }),
              "face 1 would have no texcoord; the numbers of the input are too large");

    std::vector<shapes::point> points;
    std::vector<int> face;
    for (int i = 0; i < 128; ++i) {
        points.push_back({double(i), double(i * i), 0});
        face.push_back(i);
    }
    const auto disk = kith::make_mesh(points, std::vector<std::vector<int>>{face});
    EXPECT_EQ(
        error_text<kith::mesh_error>([&] {
            write(kith::ply_file(counts_of(disk), false, arrays),
                  here.path / "file",
                  last_tiles(disk, with_values(kith::catmull_clark(), disk), 0, in_blocks(disk, 1)));
        }),
        "face 0 has 128 corners, the lists of this file count 127; give ply_file the largest degree of all faces");
}

namespace {

/// Makes a cone over a polygon of n corners. The polygon is its base if `closed`; else the base is missing.
mesh3d cone(int n, bool closed)
{
    std::vector<shapes::point> points{{0, 0, 2}};
    std::vector<std::vector<int>> faces(closed ? 1 : 0);
    for (int i = 0; i < n; ++i) {
        points.push_back({std::cos(6.28 * i / n), std::sin(6.28 * i / n), 0});
        faces.push_back({0, 1 + i, 1 + (i + 1) % n});
        if (closed)
            faces[0].insert(faces[0].begin(), 1 + i);
    }
    return kith::make_mesh(points, faces);
}

/// Expects that largest_degree finds the largest degree of the refined mesh, from the mesh and from its tiles.
template <class Scheme>
void expect_largest_degree(const mesh3d& control, const Scheme& scheme, int levels)
{
    const auto mesh = kith::refine(control, scheme, levels);
    std::size_t largest = 0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        largest = std::max<std::size_t>(largest, mesh.face(f).size());
    const std::size_t told = kith::largest_degree(control, scheme, levels);
    EXPECT_EQ(told, largest);
    const auto parts = in_blocks(control, 3);
    kith::tile_cutter cutter(control, scheme, parts.part_of, parts.parts);
    std::size_t of_tiles = 0;
    for (std::size_t t = 0; t < 3; ++t)
        of_tiles = std::max(of_tiles, kith::largest_degree(cutter.cut(t, 1).part, scheme, levels));
    EXPECT_EQ(of_tiles, largest);
}

} // namespace

TEST(ply_file, knows_the_largest_degree_before_there_are_faces)
{
    for (const bool closed : {true, false}) {
        const mesh3d control = cone(300, closed);
        for (const int levels : {1, 2}) {
            expect_largest_degree(control, kith::doo_sabin(), levels);
            expect_largest_degree(control, kith::catmull_clark(), levels);
        }
        expect_largest_degree(control, kith::catmull_clark(), 0);
    }
}

/// A sink that writes into memory and records the writes.
struct bytes_in_memory final : kith::placed_bytes {
    void write(std::uint64_t offset, const void* data, std::size_t size) override
    {
        writes.push_back({offset, size});
        bytes.resize(std::max<std::size_t>(bytes.size(), offset + size));
        std::memcpy(bytes.data() + offset, data, size);
    }
    std::vector<std::pair<std::uint64_t, std::size_t>> writes{};
    std::vector<char> bytes{};
};

TEST(joined_writes, join_what_follows_and_write_every_byte_to_its_place)
{
    constexpr std::size_t mebibyte = std::size_t(1) << 20;
    const std::vector<char> large(3 * mebibyte / 2, 'l');
    std::vector<char> expected(4 * mebibyte, 0);
    bytes_in_memory memory;
    {
        kith::joined_writes out(memory);
        for (std::uint32_t i = 0; i < 1000; ++i) { // in two runs
            const std::uint64_t at = 4 * i + (i < 600 ? 0 : 16);
            out.put(at, i);
            std::memcpy(expected.data() + at, &i, sizeof i);
        }
        out.put(mebibyte, large.data(), large.size());
        std::ranges::copy(large, expected.begin() + mebibyte);
        out.put(mebibyte + large.size(), 'x');
        expected[mebibyte + large.size()] = 'x';
        for (std::size_t i = 0; i < mebibyte + 10; ++i)
            out.put(mebibyte + large.size() + 1 + i, char(i % 7));
        out.flush();
        out.flush();
    }
    for (std::size_t i = 0; i < mebibyte + 10; ++i)
        expected[mebibyte + large.size() + 1 + i] = char(i % 7);
    expected.resize(memory.bytes.size());
    EXPECT_TRUE(memory.bytes == expected);
    const std::vector<std::pair<std::uint64_t, std::size_t>> writes{{0, 2400},
                                                                    {2416, 1600},
                                                                    {mebibyte, large.size()},
                                                                    {mebibyte + large.size(), mebibyte},
                                                                    {2 * mebibyte + large.size(), 11}};
    EXPECT_EQ(memory.writes, writes);
}

TEST(ply_file, counts_the_corners_of_large_faces_in_wider_numbers)
{
    const directory here;
    for (const int n : {120, 200, 300, 40000}) {
        std::vector<shapes::point> points;
        std::vector<int> face;
        for (int i = 0; i < n; ++i) {
            points.push_back({double(i), double(i) * i, 0});
            face.push_back(i);
        }
        const auto disk = kith::make_mesh(points, std::vector<std::vector<int>>{face});
        const kith::ply_file layout(counts_of(disk), false, arrays, {}, std::uint64_t(n));
        write(layout,
              here.path / "file",
              last_tiles(disk, with_values(kith::catmull_clark(), disk), 0, in_blocks(disk, 1)));
        const std::string bytes = bytes_of(here.path / "file");
        ASSERT_EQ(bytes.size(), layout.size());
        const std::string corners = n > 255 ? "ushort" : "uchar", values = n == 40000 ? "uint"
                                                                           : n > 127  ? "ushort"
                                                                                      : "uchar";
        EXPECT_NE(
            bytes.find("property list " + corners + " int vertex_indices\nproperty list " + values + " float texcoord"),
            std::string::npos);
        reader in(bytes);
        for (int v = 0; v < n; ++v) {
            EXPECT_EQ(in.next<shapes::point>(), points[std::size_t(v)]);
            (void)in.next<double>(), (void)in.next<std::uint8_t>();
        }
        const auto count = [&](const std::string& type) {
            return type == "uchar"    ? std::size_t(in.next<std::uint8_t>())
                   : type == "ushort" ? std::size_t(in.next<std::uint16_t>())
                                      : std::size_t(in.next<std::uint32_t>());
        };
        EXPECT_EQ(count(corners), n);
        for (int v = 0; v < n; ++v)
            EXPECT_EQ(in.next<std::int32_t>(), v);
        EXPECT_EQ(count(values), 2 * n);
        for (int c = 0; c < n; ++c)
            EXPECT_EQ(in.next<uv_type>(), (uv_type{float(c), 1 / float(c + 1)}));
        (void)in.next<std::int16_t>();
        EXPECT_TRUE(in.is_at_end());
    }
}
