// SPDX-License-Identifier: BSD-3-Clause
#include <kith/face_varying.hpp>

#include "support/every_scheme.hpp"
#include "support/same_mesh.hpp"
#include "support/tiles.hpp"

#include <kith/hierarchy.hpp>
#include <kith/refine_in_tiles.hpp>
#include <kith/refine_with_fields.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <random>
#include <utility>
#include <vector>

/// A type of values without an order.
struct shade {
    double grey = 0;

    friend bool operator==(const shade&, const shade&) = default;
};
template <>
struct kith::affine<shade> : kith::affine<double> {
    static double load(const shade& s) { return s.grey; }
    static shade store(double total) { return {total}; }
};

namespace {

using enum kith::face_varying_linear;
using kith::boundary_corner;
using kith::catmull_clark;
using kith::face_varying;
using kith::face_varying_linear;

constexpr std::array all_choices{none, corners_only, corners_plus1, corners_plus2, boundaries, all};
constexpr std::array smooth_choices{none, corners_only, corners_plus1, corners_plus2};

std::size_t corner_of(const mesh3d& mesh, std::size_t face, std::size_t vertex)
{
    const auto vertices = mesh.face(face);
    const auto found = std::find(vertices.begin(), vertices.end(), vertex);
    EXPECT_NE(found, vertices.end());
    return mesh.topology().first_corner(face) + std::size_t(found - vertices.begin());
}

/// Numbers at the corners of a mesh, which Catmull-Clark refines by one step.
class numbers {
public:
    explicit numbers(const mesh3d& mesh) : mesh_(mesh), values_(mesh.corner_count())
    {
        for (std::size_t c = 0; c < values_.size(); ++c)
            values_[c] = double(mesh.topology().corner_vertex[c]);
    }
    numbers& set(std::size_t vertex, std::initializer_list<std::size_t> faces, double value)
    {
        for (const std::size_t f : faces)
            values_[corner_of(mesh_, f, vertex)] = value;
        return *this;
    }
    numbers& refine(face_varying_linear linear, const catmull_clark& scheme = {})
    {
        auto field = kith::on_corners(values_, face_varying{linear});
        kith::refine_with_fields(mesh_, scheme, 1, std::tie(field));
        fine_.assign(field.values().begin(), field.values().end());
        return *this;
    }
    /// Returns the refined number of a vertex in a face; `after` returns that of the edge to the next vertex.
    [[nodiscard]] double at(std::size_t face, std::size_t vertex) const
    {
        return fine_[4 * corner_of(mesh_, face, vertex)];
    }
    [[nodiscard]] double after(std::size_t face, std::size_t vertex) const
    {
        return fine_[4 * corner_of(mesh_, face, vertex) + 1];
    }

private:
    const mesh3d& mesh_;
    std::vector<double> values_, fine_;
};

/// Returns the edge between two vertices; 0 if there is none.
std::size_t edge_between(const mesh3d& mesh, std::size_t a, std::size_t b)
{
    const kith::level_of<mesh3d> level(mesh);
    for (const auto e : level.edges())
        if (std::minmax(e.org().index(), e.dst().index()) == std::minmax(a, b))
            return e.index();
    ADD_FAILURE();
    return 0;
}

/// Returns values with seams along random edges, one in `one_in`. The values on the sides of seams are random.
std::vector<double> cut_at_random(const mesh3d& mesh, std::uint32_t one_in, std::uint32_t seed)
{
    std::minstd_rand random(seed);
    const kith::level_of<mesh3d> level(mesh);
    std::vector<bool> is_cut(mesh.edge_count());
    for (std::size_t e = 0; e < is_cut.size(); ++e)
        is_cut[e] = random() % one_in == 0;
    std::vector<double> result(mesh.corner_count());
    for (const auto v : level.vertices()) {
        auto start = v.first_corner();
        if (not v.is_boundary())
            for (const auto c : v.corners())
                if (is_cut[c.next_edge().index()])
                    start = c;
        double value = double(random()) / 1e9;
        for (const auto c : start.fan_from_here()) {
            if (not(c == start) and is_cut[c.next_edge().index()])
                value = double(random()) / 1e9;
            result[c.index()] = value;
        }
    }
    return result;
}

/// Returns zeros on a grid of nine quads, except on the two sides of the edge from v5 to v9.
std::vector<double> seam_from_5_to_9(const mesh3d& mesh, std::array<double, 2> at_5, std::array<double, 2> at_9)
{
    std::vector<double> result(mesh.corner_count());
    for (std::size_t side = 0; side < 2; ++side) {
        for (const std::size_t face : {0, 3})
            result[corner_of(mesh, face + side, 5)] = at_5[side];
        for (const std::size_t face : {3, 6})
            result[corner_of(mesh, face + side, 9)] = at_9[side];
    }
    return result;
}

kith::creases some_creases(const mesh3d& mesh)
{
    kith::creases result;
    for (std::size_t e = 0; e < mesh.edge_count(); e += 3)
        result.sharpen_edge(e, e % 2 == 0 ? 1.25 : e % 5 == 0 ? kith::infinitely_sharp : 0.5);
    result.sharpen_vertex(1, 0.75);
    return result;
}

template <class Test>
void for_each_scheme(const Test& test)
{
    const auto run = [&](const auto& shapes, auto scheme) {
        for (const auto& [name, shape] : shapes) {
            const auto mesh = native(shape);
            if (mesh.face_count() >= 40)
                continue;
            SCOPED_TRACE(name_of(scheme) + " of " + name);
            for (const bool creased : {false, true})
                for (const auto corners : {boundary_corner::kept, boundary_corner::smoothed}) {
                    scheme.corners = corners;
                    scheme.sharpness = creased ? some_creases(mesh) : kith::creases();
                    test(scheme, mesh);
                }
        }
    };
    run(shapes::all_shapes(), catmull_clark{});
    run(shapes::triangle_shapes(), kith::loop{});
}

template <class A, class B>
bool same_values(const A& a, const B& b)
{
    return std::ranges::equal(
        a, b, [](double x, double y) { return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y); });
}

} // namespace

TEST(face_varying, without_seams_is_the_scheme_itself_bit_for_bit)
{
    for_each_scheme([](const auto& scheme, const mesh3d& mesh) {
        std::vector<double> weight, at_corners;
        for (const auto& p : mesh.points())
            weight.push_back(p[0] + 2 * p[1] - p[2]);
        for (const auto v : mesh.topology().corner_vertex)
            at_corners.push_back(weight[v]);
        for (const auto linear : smooth_choices) {
            if (linear != none and scheme.corners == boundary_corner::smoothed)
                continue;
            auto smooth = kith::on_vertices(weight, kith::by_mask{});
            auto field = kith::on_corners(at_corners, face_varying{linear});
            const auto fine = kith::refine_with_fields(mesh, scheme, 2, std::tie(smooth, field));
            std::vector<double> expected;
            for (const auto v : fine.topology().corner_vertex)
                expected.push_back(smooth[v]);
            EXPECT_TRUE(same_values(field.values(), expected));
        }
    });
}

TEST(face_varying, of_everything_linear_and_of_linear_schemes_is_linear_in_faces)
{
    const auto expect_linear = [](const auto& scheme, const mesh3d& mesh, face_varying_linear linear) {
        const auto values = cut_at_random(mesh, 3, 1);
        auto expected = kith::on_corners(values);
        auto field = kith::on_corners(values, face_varying{linear});
        kith::refine_with_fields(mesh, scheme, 2, std::tie(expected, field));
        EXPECT_TRUE(same_values(field.values(), expected.values()));
    };
    const auto mesh = native(shapes::shaken(shapes::open_house()));
    for (const auto linear : all_choices) {
        expect_linear(kith::linear{}, mesh, linear);
        expect_linear(kith::linear_triangles{}, native(shapes::triangulated(shapes::grid())), linear);
    }
    expect_linear(catmull_clark{}, mesh, all);
    expect_linear(kith::doo_sabin{}, mesh, all);
    auto field = kith::on_corners(cut_at_random(mesh, 3, 1), face_varying{corners_only});
    EXPECT_THROW(kith::refine_with_fields(mesh, kith::doo_sabin{}, 1, std::tie(field)), kith::mesh_error);
}

// Two unit squares side by side, each with the whole texture, have a seam along their common edge.
TEST(face_varying, of_two_charts)
{
    const auto mesh = native(
        {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}}, {{0, 1, 4, 3}, {1, 2, 5, 4}}});
    using uv = std::array<double, 2>;
    const std::vector<uv> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const auto refined = [&](face_varying_linear linear, boundary_corner corners, int levels) {
        auto field = kith::on_corners(square, face_varying{linear});
        kith::refine_with_fields(mesh, catmull_clark{.corners = corners, .sharpness = {}}, levels, std::tie(field));
        return std::vector<uv>(field.values().begin(), field.values().end());
    };
    for (const auto linear : all_choices) {
        const auto kept = refined(linear, boundary_corner::kept, 1);
        const auto smoothed = refined(linear, boundary_corner::smoothed, 1);
        // The vertices, the middles of the next edges, and that of the face.
        EXPECT_EQ(kept[0], (uv{0, 0}));
        EXPECT_EQ(kept[4], linear == none ? (uv{.875, .125}) : (uv{1, 0}));
        EXPECT_EQ(kept[16], linear == none ? (uv{.125, .125}) : (uv{0, 0}));
        EXPECT_EQ(smoothed[0], linear == none ? (uv{.125, .125}) : (uv{0, 0}));
        EXPECT_EQ(kept[5], (uv{1, .5}));
        EXPECT_EQ(kept[13], (uv{0, .5}));
        EXPECT_EQ(kept[1], (uv{.5, 0}));
        EXPECT_EQ(kept[2], (uv{.5, .5}));
        // The middle of the seam, once more: between the vertices of level 1.
        const auto twice = refined(linear, boundary_corner::kept, 2);
        EXPECT_EQ(twice[4 * 5], linear == none ? (uv{.96875, .5}) : (uv{1, .5}));
    }
}

// A seam ends at v5, an inner vertex of a grid of nine quads. Its faces are 0 (from v0), 1 (v1), 3 (v4) and 4 (v5).
TEST(face_varying, where_a_seam_ends)
{
    const auto mesh = native(shapes::grid(3, 3));
    for (const auto linear : all_choices) {
        numbers values(mesh);
        values.set(1, {0}, 100).refine(linear); // the other side has 1
        const bool stays = linear == corners_plus2 or linear == boundaries or linear == all;
        const double expected = stays ? 5 : .75 * 5 + .125 * (100 + 1);
        for (const std::size_t f : {0, 1, 3, 4})
            EXPECT_EQ(values.at(f, 5), expected);
        EXPECT_EQ(values.at(0, 1), linear == none ? .75 * 100 + .125 * (5 + 0) : 100);
        EXPECT_EQ(values.at(1, 1), linear == none ? .75 * 1 + .125 * (2 + 5) : 1);
        EXPECT_EQ(values.after(0, 1), 52.5);
        EXPECT_EQ(values.after(1, 5), 3);
        // At the edge from v5 to v6, smooth, the other end of the seam counts on its own side only.
        EXPECT_EQ(values.after(4, 5), linear == all ? 5.5 : (5 + 6 + (1 + 2 + 6 + 5) / 4. + (5 + 6 + 10 + 9) / 4.) / 4);
    }
}

TEST(face_varying, where_two_or_three_values_meet)
{
    const auto mesh = native(shapes::grid(3, 3));
    for (const auto linear : all_choices) {
        const bool curves = linear == none or linear == corners_only;
        numbers two(mesh); // faces 0 and 3, left of v5, differ from 1 and 4
        two.set(5, {0, 3}, 50).refine(linear);
        const bool linear_boundary = linear == boundaries or linear == all;
        EXPECT_EQ(two.at(0, 5), linear_boundary ? 50 : .75 * 50 + .125 * (1 + 9));
        EXPECT_EQ(two.at(3, 5), two.at(0, 5));
        EXPECT_EQ(two.at(1, 5), linear_boundary ? 5 : .75 * 5 + .125 * (1 + 9));

        numbers corner(mesh); // face 0 differs from the three others
        corner.set(5, {0}, 50).refine(linear);
        EXPECT_EQ(corner.at(0, 5), linear == none ? .75 * 50 + .125 * (1 + 4) : 50);
        const bool follows = curves or linear == corners_plus1;
        EXPECT_EQ(corner.at(4, 5), follows ? .75 * 5 + .125 * (1 + 4) : 5);

        numbers three(mesh);
        three.set(5, {0}, 50).set(5, {1}, 60).refine(linear);
        EXPECT_EQ(three.at(0, 5), linear == none ? .75 * 50 + .125 * (1 + 4) : 50);
        EXPECT_EQ(three.at(3, 5), curves ? .75 * 5 + .125 * (4 + 6) : 5);

        numbers again(mesh); // one value in two opposite faces: the values of all faces stay
        again.set(5, {0}, 50).set(5, {4}, 50).refine(linear);
        EXPECT_EQ(again.at(0, 5), 50);
        EXPECT_EQ(again.at(4, 5), 50);
        EXPECT_EQ(again.at(1, 5), 5);
        EXPECT_EQ(again.at(3, 5), 5);
    }
}

TEST(face_varying, with_something_sharp_between_seams)
{
    const auto mesh = native(shapes::grid(3, 3));
    const auto with = [&](double sharpness) {
        catmull_clark scheme;
        scheme.sharpness.sharpen_edge(edge_between(mesh, 5, 4), sharpness); // between faces 0 and 3
        return scheme;
    };
    for (const auto linear : smooth_choices) {
        const bool depends = linear == corners_plus1 or linear == corners_plus2;
        const double curve = .75 * 50 + .125 * (1 + 9), other = .75 * 5 + .125 * (1 + 9);
        numbers values(mesh);
        values.set(5, {0, 3}, 50).refine(linear, with(.25));
        EXPECT_EQ(values.at(0, 5), .25 * 50 + .75 * curve);
        EXPECT_EQ(values.at(1, 5), depends ? .25 * 5 + .75 * other : other);
        for (const double sharpness : {1.5, kith::infinitely_sharp}) {
            values.refine(linear, with(sharpness));
            EXPECT_EQ(values.at(0, 5), 50);
            EXPECT_EQ(values.at(1, 5), depends ? 5 : other);
        }
        // A sharp edge under the seam itself changes nothing.
        catmull_clark under;
        under.sharpness.sharpen_edge(edge_between(mesh, 5, 1), 3);
        values.refine(linear, under);
        EXPECT_EQ(values.at(0, 5), curve);
        EXPECT_EQ(values.at(1, 5), other);
        // A sharp vertex holds all its values.
        catmull_clark held;
        held.sharpness.sharpen_vertex(5, .5);
        values.refine(linear, held);
        EXPECT_EQ(values.at(0, 5), .5 * 50 + .5 * curve);
        EXPECT_EQ(values.at(1, 5), .5 * 5 + .5 * other);
        held.sharpness.sharpen_vertex(5, 2);
        values.refine(linear, held);
        EXPECT_EQ(values.at(1, 5), 5);
    }
}

TEST(face_varying, by_openmeshs_boundary_curve)
{
    const auto mesh = native(shapes::grid(3, 3));
    numbers values(mesh);
    values.set(5, {0, 3}, 50).refine(corners_only, {.boundary = kith::boundary_curve::thirds, .sharpness = {}});
    EXPECT_NEAR(values.at(0, 5), (4 * 50 + (1 + 9)) / 6., 1e-14);
}

TEST(face_varying, keeps_its_seams_and_makes_no_others)
{
    for_each_scheme([](const auto& scheme, const mesh3d& mesh) {
        const auto control = cut_at_random(mesh, 4, 7);
        kith::hierarchy levels(mesh, scheme);
        levels.refine(3);
        const auto differs = [](const auto& e, const auto& values) {
            const auto left = e.lcorner(), right = e.rcorner();
            return values[left.index()] != values[right.next().index()] or
                   values[left.next().index()] != values[right.index()];
        };
        for (const auto linear : all_choices) {
            const auto field = levels.carry(0, 3, kith::on_corners(control, face_varying{linear}));
            std::size_t wrong = 0;
            for (const auto e : levels.elements(3).edges()) {
                if (e.is_boundary())
                    continue;
                const auto from = levels.ancestor(3, e.handle(), 0);
                const bool was_seam = from.e and differs(kith::edge(levels.elements(0), *from.e), control);
                wrong += differs(e, field) != was_seam;
            }
            EXPECT_EQ(wrong, 0);
        }
    });
}

TEST(face_varying, knows_a_seam_whose_sides_say_the_same_by_chance)
{
    const auto mesh = native(shapes::grid(3, 3));
    for (const auto linear : smooth_choices) {
        const auto refined = [&](const std::vector<double>& values) {
            auto field = kith::on_corners(values, face_varying{linear});
            kith::refine_with_fields(mesh, catmull_clark{}, 3, std::tie(field));
            return field;
        };
        // From v5 to v9 one side goes up and the other one down: their middles are the same.
        const auto crossing = seam_from_5_to_9(mesh, {1, 3}, {3, 1}), other = seam_from_5_to_9(mesh, {4, 5}, {9, 2});
        std::vector<double> both;
        for (std::size_t c = 0; c < crossing.size(); ++c)
            both.push_back(crossing[c] + other[c]);
        const auto a = refined(crossing), b = refined(other), sum = refined(both);
        for (std::size_t c = 0; c < sum.size(); ++c)
            EXPECT_NEAR(sum[c], a[c] + b[c], 1e-13);
    }
}

TEST(face_varying, takes_values_without_an_order_and_those_that_are_no_numbers)
{
    const auto mesh = native(shapes::shaken(shapes::torus(5, 7)));
    auto values = cut_at_random(mesh, 3, 11);
    const kith::level_of<mesh3d> level(mesh);
    double value = 1; // opposite faces of the four have equal values
    for (const auto c : level.vertices()[12].corners())
        values[c.index()] = value = 3 - value;
    for (const auto linear : all_choices) {
        const auto refined = [&](const auto& list) {
            auto field = kith::on_corners(list, face_varying{linear});
            kith::refine_with_fields(mesh, catmull_clark{}, 2, std::tie(field));
            return field;
        };
        const auto expected = refined(values);
        std::vector<shade> shades;
        for (const double x : values)
            shades.push_back({x});
        const auto shaded = refined(shades);
        for (std::size_t c = 0; c < expected.size(); ++c)
            EXPECT_EQ(shaded[c].grey, expected[c]);

        // A face without values is a separate chart, like a face whose values differ from all others.
        auto holed = values, other = values;
        for (std::size_t c = 0; c < 4; ++c) {
            holed[c] = std::numeric_limits<double>::quiet_NaN();
            other[c] = 1000 + double(c);
        }
        const auto without = refined(holed), with = refined(other);
        for (std::size_t c = 0; c < with.size(); ++c)
            if (c < 4 * 16)
                EXPECT_TRUE(std::isnan(without[c]));
            else
                EXPECT_EQ(without[c], with[c]);
    }
}

TEST(face_varying, is_the_same_on_the_way_through_levels_tiles_and_messages)
{
    for_each_scheme([](const auto& scheme, const mesh3d& mesh) {
        const auto values = cut_at_random(mesh, 3, 5);
        for (const auto linear : {none, corners_plus1, boundaries}) {
            const auto given = kith::with_fields(scheme, kith::on_corners(values, face_varying{linear}));
            auto whole = given;
            const auto fine = kith::refine_with_fields(mesh, whole, 2);
            EXPECT_TRUE(same_bits(fine, kith::refine(mesh, scheme, 2)));
            kith::hierarchy levels(mesh, given);
            levels.refine(1);
            levels.refine(1);
            EXPECT_TRUE(same_values(levels.scheme(2).template field<0>().values(), whole.template field<0>().values()));
            EXPECT_TRUE(same_values(levels.carry(1, 2, levels.carry(0, 1, given.template field<0>())).values(),
                                    whole.template field<0>().values()));
            const std::size_t parts = 3;
            const auto part_of = partitions::scattered(mesh.face_count(), parts, 2);
            kith::tiled_refinement refinement(mesh, given, 2, {part_of, parts}, 1);
            for (std::size_t p = 0; p < parts; ++p) {
                kith::phase_seconds seconds;
                const auto job = refinement.refine_job(p, kith::connect::everything, seconds);
                const auto& field = job.scheme.template field<0>();
                std::vector<double> expected;
                for (std::size_t f = 0; f < job.part.mesh.face_count(); ++f)
                    for (std::size_t k = 0; k < job.part.mesh.face(f).size(); ++k)
                        expected.push_back(whole.template field<0>()[job.part.corner_id(f, k)]);
                EXPECT_TRUE(same_values(field.values(), expected));
                const auto bytes = kith::pack(job);
                EXPECT_EQ(kith::pack(kith::unpack<shapes::point, std::uint32_t>(bytes, given)), bytes);
            }
        }
    });
}

TEST(face_varying, goes_on_from_a_level_that_was_sent)
{
    const auto mesh = native(shapes::shaken(shapes::torus(5, 7)));
    const auto given = kith::with_fields(catmull_clark{},
                                         kith::on_corners(cut_at_random(mesh, 3, 5), face_varying{corners_only}));
    kith::hierarchy levels(mesh, given);
    levels.refine(2);
    const auto everything = partitions::blocks(levels[1].face_count(), 1);
    const auto job = kith::tile_cutter(levels[1], levels.scheme(1), everything, 1).cut(0, 1);
    auto sent = kith::unpack<shapes::point, std::uint32_t>(kith::pack(job), given);
    kith::refine_with_fields(sent.part.mesh, sent.scheme, 1);
    EXPECT_TRUE(same_values(sent.scheme.field<0>().values(), levels.scheme(2).field<0>().values()));
}

TEST(face_varying, is_joined_from_parts_of_a_level)
{
    const auto mesh = native(shapes::grid(3, 3));
    kith::hierarchy levels(mesh, catmull_clark{});
    levels.refine(2);
    const auto crossing = seam_from_5_to_9(mesh, {1, 3}, {3, 1}); // its seams do not follow from its values
    const auto whole = levels.carry(0, 1, kith::on_corners(crossing, face_varying{corners_plus1}));
    auto joined = kith::field<kith::field_on::corners, double, face_varying>(whole.rule());
    for (const std::uint32_t parity : {1, 0}) {
        std::vector<std::uint32_t> faces;
        for (std::uint32_t f = parity; f < levels[1].face_count(); f += 2)
            faces.push_back(f);
        const kith::part_numbers<std::uint32_t> part{{}, {}, faces, 4};
        joined.add_part(whole.of_part(part), part);
    }
    EXPECT_TRUE(same_values(joined.values(), whole.values()));
    EXPECT_TRUE(same_values(levels.carry(1, 2, joined).values(), levels.carry(1, 2, whole).values()));
    const auto forgotten = kith::on_corners(whole.values(), face_varying{corners_plus1});
    EXPECT_FALSE(same_values(levels.carry(1, 2, forgotten).values(), levels.carry(1, 2, whole).values()));
}
