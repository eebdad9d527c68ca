// SPDX-License-Identifier: BSD-3-Clause
#include "support/error_text.hpp"

#include <kith/core/mesh/make_mesh.hpp>
#include <kith/io/text/file_error.hpp>
#include <kith/read_mesh.hpp>
#include <kith/write_mesh.hpp>

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

namespace {

using kith::io::mesh_format;
using json = nlohmann::json;

std::string written(mesh_format format, const kith::io::written_mesh& what)
{
    require_writable(format, what);
    std::ostringstream out;
    write_mesh(out, format, what);
    return out.str();
}

/// A file of glTF in its binary form, taken apart.
struct glb_file {
    json head;
    std::string bytes; ///< of the arrays

    explicit glb_file(const std::string& file)
    {
        EXPECT_EQ(file.substr(0, 4), "glTF");
        EXPECT_EQ(number_at(file, 4), 2);
        EXPECT_EQ(number_at(file, 8), file.size());
        const std::size_t head_size = number_at(file, 12);
        EXPECT_EQ(file.substr(16, 4), "JSON");
        head = json::parse(file.substr(20, head_size));
        EXPECT_EQ(number_at(file, 20 + head_size), file.size() - 28 - head_size);
        EXPECT_EQ(file.substr(24 + head_size, 4), std::string("BIN\0", 4));
        bytes = file.substr(28 + head_size);
        EXPECT_EQ(head["buffers"][0]["byteLength"], bytes.size());
    }

    static std::uint32_t number_at(const std::string& text, std::size_t place)
    {
        std::uint32_t result = 0;
        std::memcpy(&result, text.data() + place, sizeof result);
        return result;
    }
    template <class Number>
    [[nodiscard]] std::vector<Number> array(std::size_t accessor) const
    {
        const json &a = head["accessors"][accessor], &view = head["bufferViews"][a["bufferView"].get<std::size_t>()];
        std::vector<Number> result(view["byteLength"].get<std::size_t>() / sizeof(Number));
        std::memcpy(
            result.data(), bytes.data() + view["byteOffset"].get<std::size_t>(), result.size() * sizeof(Number));
        return result;
    }
    [[nodiscard]] const json& part(std::size_t i) const { return head["meshes"][0]["primitives"][i]; }
    [[nodiscard]] std::vector<float> of_vertices(const char* what) const
    {
        return array<float>(part(0)["attributes"][what].get<std::size_t>());
    }
    [[nodiscard]] std::vector<std::uint32_t> triangles(std::size_t part_number) const
    {
        return array<std::uint32_t>(part(part_number)["indices"].get<std::size_t>());
    }
};

/// Two quads that share the edge between vertices 1 and 2.
kith::basic_mesh<> two_quads()
{
    const std::vector<std::array<double, 3>> points{{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 0}, {3, 0, 0}, {3, 2, -1}};
    const std::vector<std::array<int, 4>> faces{{0, 1, 2, 3}, {1, 4, 5, 2}};
    return kith::make_mesh(points, faces);
}

TEST(write_glb, has_points_triangles_and_bounds)
{
    const auto mesh = two_quads();
    const glb_file file(written(mesh_format::glb, {.mesh = mesh}));
    EXPECT_EQ(file.of_vertices("POSITION"),
              (std::vector<float>{0, 0, 0, 1, 0, 0, 1, 2, 0, 0, 2, 0, 3, 0, 0, 3, 2, -1}));
    EXPECT_EQ(file.triangles(0), (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3, 1, 4, 5, 1, 5, 2}));
    const json& points = file.head["accessors"][0];
    EXPECT_EQ(points["min"], json::parse("[0, 0, -1]"));
    EXPECT_EQ(points["max"], json::parse("[3, 2, 0]"));
    EXPECT_FALSE(file.head.contains("materials"));
}

TEST(write_glb, splits_vertices_whose_corners_differ)
{
    const auto mesh = two_quads();
    kith::io::mesh_attributes all; // vertex 1 has two texture coordinates, vertex 2 has one
    all.corners.push_back({"u", {4, true, true}, {0, .5, .5, 0, .25, 1, 1, .5}});
    all.corners.push_back({"v", {4, true, true}, {0, 0, 1, 1, 0, 0, .75, 1}});
    const glb_file file(written(mesh_format::glb, {.mesh = mesh, .attributes = &all}));
    EXPECT_EQ(file.of_vertices("POSITION"),
              (std::vector<float>{0, 0, 0, 1, 0, 0, 1, 2, 0, 0, 2, 0, 3, 0, 0, 3, 2, -1, 1, 0, 0}));
    EXPECT_EQ(file.of_vertices("TEXCOORD_0"), // the second coordinate grows downward
              (std::vector<float>{0, 1, .25, 1, .5, 0, 0, 0, 1, 1, 1, .25, .5, 1}));
    EXPECT_EQ(file.triangles(0), (std::vector<std::uint32_t>{0, 6, 2, 0, 2, 3, 1, 4, 5, 1, 5, 2}));
}

TEST(write_glb, has_a_part_for_each_material_that_faces_have)
{
    const auto mesh = two_quads();
    kith::io::mesh_attributes all;
    all.faces.push_back({"material", {1, false, false}, {2, 0}, {"", "unused", "red \"paint\""}});
    const glb_file file(written(mesh_format::glb, {.mesh = mesh, .attributes = &all}));
    ASSERT_EQ(file.head["meshes"][0]["primitives"].size(), 2);
    EXPECT_FALSE(file.part(0).contains("material"));
    EXPECT_EQ(file.triangles(0), (std::vector<std::uint32_t>{1, 4, 5, 1, 5, 2}));
    EXPECT_EQ(file.part(1)["material"], 0);
    EXPECT_EQ(file.triangles(1), (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
    ASSERT_EQ(file.head["materials"].size(), 1);
    EXPECT_EQ(file.head["materials"][0]["name"], "red \"paint\"");
}

TEST(write_glb, has_colors_in_linear_light_and_normals_of_length_1)
{
    const auto mesh = two_quads();
    kith::io::mesh_attributes all;
    for (const auto name : {"red", "green", "blue"})
        all.vertices.push_back({name, {1, false, false}, {0, 188, 255, 10, 128, 64}});
    const std::vector<std::array<double, 3>> normals(6, {0, 3, 4});
    const glb_file file(written(mesh_format::glb, {.mesh = mesh, .normals = normals, .attributes = &all}));
    const auto colors = file.of_vertices("COLOR_0");
    ASSERT_EQ(colors.size(), 24);
    EXPECT_EQ(colors[0], 0);
    EXPECT_NEAR(colors[4], 0.502886, 1e-6); // by the formula of sRGB
    EXPECT_EQ(colors[8], 1);
    EXPECT_NEAR(colors[12], 10 / 255. / 12.92, 1e-7);
    EXPECT_EQ(colors[15], 1); // opaque
    const auto unit = file.of_vertices("NORMAL");
    EXPECT_EQ(unit[15], 0);
    EXPECT_FLOAT_EQ(unit[16], .6F);
    EXPECT_FLOAT_EQ(unit[17], .8F);
}

TEST(write_glb, has_normals_of_both_sides_of_a_sharp_edge)
{
    const auto mesh = two_quads();
    std::vector<std::array<double, 3>> normals(4, {0, 0, 1});
    normals.insert(normals.end(), 4, {1, 0, 0});
    const glb_file file(written(mesh_format::glb, {.mesh = mesh, .corner_normals = normals}));
    EXPECT_EQ(file.of_vertices("POSITION").size(), 3 * 8); // both ends of the edge twice
    const auto unit = file.of_vertices("NORMAL");
    for (const std::uint32_t v : file.triangles(0)) {
        const auto first = std::vector<float>(unit.begin() + 3 * v, unit.begin() + 3 * v + 3);
        EXPECT_TRUE(first == std::vector<float>({0, 0, 1}) or first == std::vector<float>({1, 0, 0})) << v;
    }
}

TEST(write_glb, refuses_places_beyond_floats_and_is_not_read)
{
    auto mesh = two_quads();
    mesh.points()[1][2] = 1e39;
    EXPECT_EQ(error_text<kith::io::file_error>([&] { require_writable(mesh_format::glb, {.mesh = mesh}); }),
              "vertex 1 is too far away for the floats of .glb; write .vtp, .off, .obj or .ply");
    EXPECT_EQ(error_text<kith::io::file_error>([] { (void)kith::io::read_mesh_file("a.glb"); }),
              "a.glb: the extension decides the format and must be .off, .obj, .ply, .stl, .vtu, .pvtu, .vtp or .pvtp");
}

} // namespace
