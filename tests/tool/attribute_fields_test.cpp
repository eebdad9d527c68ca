// SPDX-License-Identifier: BSD-3-Clause
#include "job/attribute_fields.hpp"
#include "support/native_shape.hpp"

#include <kith/butterfly.hpp>
#include <kith/catmull_clark.hpp>
#include <kith/doo_sabin.hpp>
#include <kith/hierarchy.hpp>
#include <kith/linear.hpp>
#include <kith/refine_in_tiles.hpp>
#include <kith/refine_with_fields.hpp>
#include <kith/tiles/refine/pack.hpp>
#include <kith/tri_quad.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <random>
#include <span>
#include <string>
#include <tuple>
#include <vector>

namespace {

using namespace kith;

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr ply_number u8{1, false, false}, f32{4, true, true}, f64{8, true, true};

std::vector<double> random_values(std::size_t count, unsigned seed)
{
    std::mt19937_64 engine(seed);
    std::vector<double> result;
    for (std::size_t i = 0; i < count; ++i)
        result.push_back(double(engine() % 100000) / 1024);
    return result;
}

/// Returns attributes for a mesh: the coordinates of its vertices, and numbers of all kinds.
io::mesh_attributes attributes_for(const basic_mesh<>& mesh)
{
    io::mesh_attributes result;
    for (std::size_t i = 0; i < 3; ++i) {
        result.vertices.push_back({std::string(1, "abc"[i]), f64, {}, {}});
        for (const auto& p : mesh.points())
            result.vertices[i].values.push_back(p[i]);
    }
    result.vertices.push_back({"weight", f32, random_values(mesh.vertex_count(), 1), {}});
    result.vertices.push_back({"red", u8, {}, {}});
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v)
        result.vertices[4].values.push_back(v % 3 == 0 ? 255 : 0);
    result.corners.push_back({"u", f64, random_values(mesh.corner_count(), 2), {}});
    result.corners.push_back({"v", f64, random_values(mesh.corner_count(), 3), {}});
    result.corners[1].values[0] = none;
    result.faces.push_back({"area", f64, random_values(mesh.face_count(), 4), {}});
    result.faces.push_back({"material", {4, false, true}, std::vector<double>(mesh.face_count(), 1), {"", "red"}});
    return result;
}

bool are_same(double a, double b)
{
    return a == b or (std::isnan(a) and std::isnan(b));
}

/// Compares carried attributes with the points, and with each attribute carried over a hierarchy by itself.
template <class Scheme>
void expect_carried(const basic_mesh<>& mesh, const Scheme& scheme)
{
    constexpr int depth = 2;
    const auto control = attributes_for(mesh);
    tool::attribute_fields fields(control, mesh);
    const auto fine = refine_with_fields(mesh, scheme, depth, std::tie(fields));
    const auto found = fields.at_level(control);
    hierarchy<basic_mesh<>, Scheme> levels(mesh, scheme);
    levels.refine(depth);

    ASSERT_EQ(found.vertices.size(), control.vertices.size());
    for (std::size_t a = 0; a < found.vertices.size(); ++a) {
        const auto& attribute = found.vertices[a];
        ASSERT_EQ(attribute.values.size(), fine.vertex_count());
        EXPECT_EQ(attribute.name, control.vertices[a].name);
        const auto alone = levels.carry(0, depth, std::span<const double>(control.vertices[a].values));
        for (std::size_t v = 0; v < fine.vertex_count(); ++v) {
            ASSERT_EQ(attribute.values[v], io::as_stored(attribute.type, alone[v])) << attribute.name << " " << v;
            if (a < 3) {
                ASSERT_EQ(attribute.values[v], fine.point(v)[a]);
            }
        }
    }
    ASSERT_EQ(found.corners.size(), control.corners.size());
    for (std::size_t a = 0; a < found.corners.size(); ++a) {
        ASSERT_EQ(found.corners[a].values.size(), fine.corner_count());
        const auto alone = levels.carry(0, depth, on_corners(control.corners[a].values));
        for (std::size_t c = 0; c < fine.corner_count(); ++c)
            ASSERT_TRUE(are_same(found.corners[a].values[c], alone[c])) << c;
    }
    ASSERT_EQ(found.faces.size(), 2);
    EXPECT_EQ(found.faces[1].labels, control.faces[1].labels);
    std::size_t orphans = 0;
    const auto area = levels.carry(
        0, depth, on_faces(control.faces[0].values, from_parent<std::identity, double>{{}, -1}));
    for (std::size_t f = 0; f < fine.face_count(); ++f) {
        const bool has_parent = area[f] != -1;
        orphans += not has_parent;
        ASSERT_TRUE(are_same(found.faces[0].values[f], has_parent ? area[f] : none)) << f;
        ASSERT_EQ(found.faces[1].values[f], has_parent ? 1 : 0);
    }
    constexpr bool bears_on_edges = std::same_as<Scheme, doo_sabin>;
    EXPECT_EQ(orphans != 0, bears_on_edges);
}

TEST(attribute_fields, are_carried_as_fields_are)
{
    const auto house = native(shapes::shaken(shapes::house())), open = native(shapes::shaken(shapes::open_house()));
    const auto umbrella = native(shapes::shaken(shapes::umbrella(7)));
    expect_carried(house, catmull_clark());
    expect_carried(open, catmull_clark());
    expect_carried(house, doo_sabin());
    expect_carried(umbrella, butterfly());
    expect_carried(umbrella, linear_triangles());
    expect_carried(native(shapes::shaken(shapes::grid())), linear());
}

TEST(attribute_fields, whole_numbers_stay_in_their_range)
{
    const auto mesh = native(shapes::umbrella(7));
    const auto control = attributes_for(mesh);
    tool::attribute_fields fields(control, mesh);
    (void)refine_with_fields(mesh, butterfly(), 2, std::tie(fields));
    const auto found = fields.at_level(control);
    std::size_t at_ends = 0;
    for (const double x : found.vertices[4].values) {
        EXPECT_TRUE(x >= 0 and x <= 255 and x == std::floor(x));
        at_ends += x == 0 or x == 255;
    }
    EXPECT_GT(at_ends, mesh.vertex_count()); // where the masks exceed the range
}

TEST(attribute_fields, go_into_the_mesh_that_4_8_starts_from)
{
    for (const auto& shape : {shapes::grid(), shapes::house()}) {
        const auto mesh = native(shapes::shaken(shape));
        const auto control = attributes_for(mesh);
        tool::attribute_fields fields(control, mesh);
        const auto made = tri_quad(mesh, std::tie(fields));
        const auto found = fields.at_level(control);
        ASSERT_EQ(found.vertices[0].values.size(), made.vertex_count());
        for (std::size_t v = 0; v < made.vertex_count(); ++v)
            for (std::size_t i = 0; i < 3; ++i)
                ASSERT_EQ(found.vertices[i].values[v], made.point(v)[i]);
        ASSERT_EQ(found.faces[1].values, std::vector<double>(made.face_count(), 1));
        ASSERT_EQ(found.corners[0].values.size(), made.corner_count());
        // A corner at an old vertex has the value of this vertex in the old face with the same area.
        for (std::size_t f = 0; f < made.face_count(); ++f) {
            std::size_t parent = 0;
            while (control.faces[0].values[parent] != found.faces[0].values[f])
                ++parent;
            const auto old = mesh.face(parent);
            for (std::size_t i = 0; i < 3; ++i)
                for (std::size_t j = 0; j < old.size(); ++j)
                    if (made.face(f)[i] == old[j]) {
                        ASSERT_EQ(found.corners[0].values[3 * f + i],
                                  control.corners[0].values[mesh.topology().first_corner(parent) + j]);
                    }
        }
    }
}

/// Compares the attributes in tiles, in the form that messages take, with the values of the whole level.
template <class Scheme>
void expect_in_tiles(const basic_mesh<>& mesh, const Scheme& scheme)
{
    constexpr int depth = 2;
    constexpr std::size_t parts = 3;
    const auto control = attributes_for(mesh);
    const auto kinds = tool::kinds_of(control);
    EXPECT_TRUE(kinds.vertices[0].values.empty() and kinds.faces[1].labels == control.faces[1].labels);
    tool::attribute_fields fields(control, mesh);
    const auto carrying = with_fields(scheme, fields);
    (void)refine_with_fields(mesh, scheme, depth, std::tie(fields));
    const auto whole = fields.at_level(control);

    std::vector<std::uint32_t> part_of;
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        part_of.push_back(std::uint32_t(f % parts));
    tiled_refinement refinement(mesh, carrying, depth, {part_of, parts});
    std::size_t owned = 0;
    for (std::size_t number = 0; number < parts; ++number)
        refinement.refine_levels(number, [&](auto&& kept) {
            packer out;
            kept.scheme.field().pack(out);
            const auto message = out.take();
            tool::attribute_fields sent(attributes_for(native(shapes::grid())), native(shapes::grid()));
            unpacker in(message);
            sent.unpack(in);
            EXPECT_TRUE(in.is_at_end());
            const auto here = kept.scheme.field().at_level(kinds), there = sent.at_level(kinds);
            const auto& part = kept.part;
            const auto expect = [&](const auto& of_tile, const auto& received, const auto& of_whole, auto id_of) {
                ASSERT_EQ(of_tile.size(), of_whole.size());
                for (std::size_t a = 0; a < of_tile.size(); ++a)
                    for (std::size_t x = 0; x < of_tile[a].values.size(); ++x) {
                        ASSERT_TRUE(are_same(of_tile[a].values[x], received[a].values[x])) << of_tile[a].name;
                        if (kept.level == depth) {
                            ASSERT_TRUE(are_same(of_tile[a].values[x], of_whole[a].values[id_of(x)]))
                                << of_tile[a].name << " " << x;
                        }
                    }
            };
            std::vector<std::size_t> corners;
            for (std::size_t f = 0; f < part.mesh.face_count(); ++f)
                for (std::size_t k = 0; k < part.mesh.face(f).size(); ++k)
                    corners.push_back(part.corner_id(f, k));
            EXPECT_EQ(here.vertices[0].values.size(), part.mesh.vertex_count());
            expect(here.vertices, there.vertices, whole.vertices, [&](std::size_t v) { return part.vertex_ids[v]; });
            expect(here.faces, there.faces, whole.faces, [&](std::size_t f) { return part.face_ids[f]; });
            expect(here.corners, there.corners, whole.corners, [&](std::size_t c) { return corners[c]; });
            owned += kept.level == depth ? owned_count(part.face_marks) : 0;
        });
    EXPECT_EQ(owned, whole.faces[0].values.size());
}

TEST(attribute_fields, are_those_of_the_whole_in_tiles_and_messages)
{
    expect_in_tiles(native(shapes::shaken(shapes::open_house())), catmull_clark());
    expect_in_tiles(native(shapes::shaken(shapes::house())), doo_sabin());
    expect_in_tiles(native(shapes::shaken(shapes::grid())), catmull_clark());
}

TEST(attribute_fields, a_message_has_the_values_of_the_control_faces_that_it_needs)
{
    const auto mesh = native(shapes::grid());
    const tool::attribute_fields fields(attributes_for(mesh), mesh);
    std::vector<std::uint32_t> numbers{0};
    const auto size_of_part = [&] {
        packer out;
        fields.of_part(part_numbers<std::uint32_t>{{}, {}, numbers, 4}).pack(out);
        return out.take().size();
    };
    const std::size_t one = size_of_part();
    numbers = {0, 2};
    EXPECT_EQ(size_of_part() - one, 4 + 2 * 8 + 4 * 4 * 8); // the face, its numbers, and the values of its corners
}

TEST(attribute_fields, normals_are_taken_out)
{
    io::mesh_attributes attributes{{{"nx", f32, {}, {}}, {"u", f32, {}, {}}}, {}, {{"nz", f64, {}, {}}}, {}};
    EXPECT_TRUE(tool::take_normals(attributes));
    EXPECT_FALSE(tool::take_normals(attributes));
    ASSERT_EQ(attributes.vertices.size(), 1);
    EXPECT_EQ(attributes.vertices[0].name, "u");
}

} // namespace
