// SPDX-License-Identifier: BSD-3-Clause
#include <kith/core/base/for_parts.hpp>
#include <kith/core/mesh/make_mesh.hpp>
#include <kith/picture.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

using namespace kith::picture;

namespace {

using pixel = std::array<std::uint8_t, 4>;
constexpr color red{1, 0, 0, 1}, green{0, 1, 0, 1}, blue{0, 0, 1, 1};
constexpr pixel white_pixel{255, 255, 255, 255}, red_pixel{255, 0, 0, 255}, green_pixel{0, 255, 0, 255};

/// Returns a rectangle that faces the viewer of `from_the_front`, who sees it as x and z.
surface rectangle(double left, double right, double bottom, double top, double depth, const color& paint)
{
    return {.points = {{left, -depth, bottom}, {right, -depth, bottom}, {right, -depth, top}, {left, -depth, top}},
            .corners = {0, 1, 2, 3},
            .first = {0, 4},
            .paint = paint,
            .light = shading::none};
}

sheet from_the_front(std::vector<panel> panels, int width, int height, int samples = 1)
{
    return {.panels = std::move(panels), .view = {0, 0}, .width = width, .height = height, .samples = samples};
}

std::size_t count(const image& image, const pixel& what)
{
    return std::size_t(std::ranges::count(image.pixels, what));
}

/// Returns the points of a sphere as triangles, with or without normals.
surface sphere(int rings, bool is_smooth)
{
    surface result{.first = {0}, .paint = {.5F, .5F, .5F, 1}, .closed = true};
    for (int i = 0; i <= rings; ++i)
        for (int j = 0; j < 2 * rings; ++j) {
            const double a = std::numbers::pi * i / rings, b = std::numbers::pi * j / rings;
            result.points.push_back({std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), -std::cos(a)});
        }
    const auto number = [&](int i, int j) { return std::uint32_t(i * 2 * rings + j % (2 * rings)); };
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < 2 * rings; ++j)
            for (const auto& t : {std::array{number(i, j), number(i, j + 1), number(i + 1, j + 1)},
                                  std::array{number(i, j), number(i + 1, j + 1), number(i + 1, j)}}) {
                result.corners.insert(result.corners.end(), t.begin(), t.end());
                result.first.push_back(std::uint32_t(result.corners.size()));
            }
    if (is_smooth)
        result.normals = result.points;
    return result;
}

} // namespace

TEST(picture, a_rectangle_covers_exactly_its_pixels)
{
    // The border is two hundredths of 100 pixels on each side, so a square of 92 pixels remains.
    const image image = draw(from_the_front({{.items = {rectangle(0, 1, 0, 1, 0, red)}}}, 120, 100));
    for (std::size_t y = 0; y < 100; ++y)
        for (std::size_t x = 0; x < 120; ++x) {
            const bool is_inside = 14 <= x and x < 106 and 4 <= y and y < 96;
            EXPECT_EQ(image.at(x, y), is_inside ? red_pixel : white_pixel) << x << ' ' << y;
        }
}

TEST(picture, two_triangles_share_no_sample_and_leave_none_out)
{
    surface half_open = rectangle(0, 1, 0, 1, 0, {1, 0, 0, .4F});
    const image whole = draw(from_the_front({{.items = {half_open}}}, 101, 97, 2));
    half_open.corners = {0, 1, 2, 2, 3, 0};
    half_open.first = {0, 3, 6};
    const image cut = draw(from_the_front({{.items = {half_open}}}, 101, 97, 2));
    EXPECT_EQ(whole.pixels, cut.pixels);
    EXPECT_EQ(count(whole, {255, 153, 153, 255}), count(cut, {255, 153, 153, 255}));
    EXPECT_GT(count(whole, {255, 153, 153, 255}), 80U * 80U);
}

TEST(picture, what_is_nearer_hides_in_any_order)
{
    const surface near = rectangle(.25, .75, .25, .75, 1, green), far = rectangle(0, 1, 0, 1, 0, red);
    const image one = draw(from_the_front({{.items = {near, far}}}, 100, 100));
    const image other = draw(from_the_front({{.items = {far, near}}}, 100, 100));
    EXPECT_EQ(one.pixels, other.pixels);
    EXPECT_EQ(count(one, green_pixel), 46U * 46U);
    EXPECT_EQ(count(one, red_pixel), 92U * 92U - 46U * 46U);
    EXPECT_EQ(one.at(50, 50), green_pixel);
}

TEST(picture, views_have_the_axes_that_their_names_say)
{
    // Lines from the origin along x (red), y (green) and z (blue).
    panel axes;
    for (int k = 0; k < 3; ++k) {
        lines axis{
            .points = {{0, 0, 0}, {0, 0, 0}}, .segments = {{0, 1}}, .ink = std::array{red, green, blue}[k], .width = 3};
        axis.points[1][std::size_t(k)] = 1;
        axes.items.emplace_back(axis);
    }
    const auto at_end = [&](view v, std::size_t x, std::size_t y) {
        sheet s = from_the_front({axes}, 100, 100);
        s.view = v;
        return draw(s).at(x, y);
    };
    const pixel blue_pixel{0, 0, 255, 255};
    EXPECT_EQ(at_end({0, 0, 2}, 90, 94), red_pixel); // front: x to the right, z upward
    EXPECT_EQ(at_end({0, 0, 2}, 5, 10), blue_pixel);
    EXPECT_EQ(at_end({90, 0, 2}, 90, 94), green_pixel); // from the right: y to the right
    EXPECT_EQ(at_end({0, 90, 2}, 5, 10), green_pixel);  // from above: y upward
    EXPECT_EQ(at_end({0, 0, 1}, 90, 94), red_pixel);    // y upward, from the front
    EXPECT_EQ(at_end({0, 0, 1}, 5, 10), green_pixel);
    EXPECT_EQ(at_end({0, 0, 0}, 90, 94), green_pixel); // x upward: y to the right
    EXPECT_EQ(at_end({0, 0, 0}, 5, 10), red_pixel);
}

TEST(picture, a_sphere_is_lit_smoothly_and_the_same_on_all_sides)
{
    sheet s = from_the_front({{.items = {sphere(40, true)}}}, 200, 200, 2);
    const image front = draw(s);
    // The lamp is in the direction (-.45, .65, .75): half of the light; the other half is everywhere.
    const double facing = .75 / std::sqrt(.45 * .45 + .65 * .65 + .75 * .75);
    const double half = std::sqrt((1 + facing) / 2); // cosine between the normal and the direction halfway to the lamp
    const double expected = 255 * (.5 * (.5 + .5 * facing) + .16 * std::pow(half, 32));
    EXPECT_NEAR(front.at(100, 100)[0], expected, 1.5);
    EXPECT_GT(front.at(60, 50)[0], front.at(140, 150)[0]); // light from the upper left
    s.view = {90, 0};
    EXPECT_NEAR(draw(s).at(100, 100)[0], expected, 1.5);
    // A sphere of triangles turned inside out looks alike, since both sides are lit.
    surface inside_out = sphere(40, true);
    for (std::size_t i = 0; i < inside_out.corners.size(); i += 3)
        std::swap(inside_out.corners[i], inside_out.corners[i + 1]);
    for (point& n : inside_out.normals)
        n = {-n[0], -n[1], -n[2]};
    inside_out.closed = false;
    s.view = {0, 0};
    s.panels[0].items[0] = inside_out;
    EXPECT_NEAR(draw(s).at(100, 100)[0], expected, 1.5);
}

TEST(picture, the_bytes_do_not_depend_on_threads)
{
    surface ball = sphere(60, false);
    ball.edges.width = 1;
    sheet s = from_the_front({{.items = {ball}, .title = "a sphere"}}, 333, 207, 3);
    s.view = {};
    s.legend = {.title = "legend", .entries = {{red, "1"}, {blue, "2"}}, .is_scale = true};
    kith::set_threads(1);
    const image alone = draw(s);
    kith::set_threads(3);
    const image together = draw(s);
    kith::set_threads(0);
    EXPECT_EQ(alone.pixels, together.pixels);
}

TEST(picture, lines_on_a_surface_are_seen_and_lines_behind_are_as_faint_as_said)
{
    const surface wall = rectangle(0, 1, 0, 1, 0, white);
    lines line{.points = {{.2, 0, .5}, {.8, 0, .5}}, .segments = {{0, 1}}, .ink = black, .width = 2};
    const auto darkest = [&](double depth, double hidden) {
        for (point& p : line.points)
            p[1] = -depth;
        line.hidden = hidden;
        return std::ranges::min(draw(from_the_front({{.items = {wall, line}}}, 100, 100)).pixels)[0];
    };
    EXPECT_EQ(darkest(0, 0), 0);
    EXPECT_EQ(darkest(.5, 0), 0);
    EXPECT_EQ(darkest(-.5, 0), 255);
    EXPECT_EQ(darkest(-.5, .2), 204);
}

TEST(picture, a_transparent_background_stays_transparent_and_edges_are_mixed)
{
    surface triangle = rectangle(0, 1, 0, 1, 0, red);
    triangle.corners = {0, 1, 2};
    triangle.first = {0, 3};
    sheet s = from_the_front({{.items = {triangle}}}, 101, 101, 4);
    s.background = transparent;
    const image image = draw(s);
    EXPECT_EQ(image.at(0, 0), pixel{});
    EXPECT_EQ(image.at(60, 60), red_pixel);
    bool has_mixed = false;
    for (const pixel& p : image.pixels) {
        EXPECT_TRUE(p[3] == 0 or (p[0] == 255 and p[1] == 0)); // no dark rim
        has_mixed = has_mixed or (p[3] != 0 and p[3] != 255);
    }
    EXPECT_TRUE(has_mixed);
}

TEST(picture, svg_has_polygons_from_back_to_front)
{
    surface two = rectangle(0, 1, 0, 1, 1, red);
    const surface far = rectangle(0, 1, 0, 1, 0, green);
    sheet s = from_the_front({{.items = {two, far}, .title = "a < b"}}, 100, 100);
    std::ostringstream out;
    write_svg(out, s);
    const std::string text = out.str();
    EXPECT_LT(text.find("#00ff00"), text.find("#ff0000"));
    EXPECT_NE(text.find(">a &lt; b</text>"), std::string::npos);
    EXPECT_TRUE(text.ends_with("</svg>\n"));
}

TEST(picture, a_mesh_becomes_a_surface_with_its_edges)
{
    const auto mesh = kith::make_mesh(std::vector<point>{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}, {2, 0, 0}},
                                      std::vector<std::vector<int>>{{0, 1, 2, 3}, {1, 4, 2}});
    const surface s = surface_of(mesh);
    EXPECT_EQ(s.first, (std::vector<std::uint32_t>{0, 4, 7}));
    EXPECT_EQ(s.corners, (std::vector<std::uint32_t>{0, 1, 2, 3, 1, 4, 2}));
    EXPECT_EQ(edges_of(mesh).segments.size(), 6U);
}

TEST(picture, what_is_incomplete_or_no_number_is_refused_or_left_out)
{
    surface wrong = rectangle(0, 1, 0, 1, 0, red);
    wrong.corners[2] = 4;
    EXPECT_THROW(draw(from_the_front({{.items = {wrong}}}, 9, 9)), std::invalid_argument);
    wrong.corners[2] = 2;
    wrong.normals.resize(3);
    EXPECT_THROW(draw(from_the_front({{.items = {wrong}}}, 9, 9)), std::invalid_argument);
    EXPECT_THROW(draw(from_the_front({}, 0, 9)), std::invalid_argument);
    EXPECT_EQ(count(draw(from_the_front({}, 9, 7)), white_pixel), 63U);

    surface broken = rectangle(0, 1, 0, 1, 0, green);
    broken.points.push_back({std::numeric_limits<double>::quiet_NaN(), 0, 0});
    broken.corners.insert(broken.corners.end(), {0, 1, 4});
    broken.first.push_back(7);
    EXPECT_EQ(count(draw(from_the_front({{.items = {broken}}}, 50, 50)), green_pixel), 46U * 46U);
}

TEST(picture, a_texture_lies_by_its_coordinates)
{
    const auto texture = std::make_shared<const image>(image{2, 1, {red_pixel, green_pixel}});
    EXPECT_EQ(color_at(*texture, 0, .5), red);
    EXPECT_EQ(color_at(*texture, 1, 0), green);
    EXPECT_EQ(color_at(*texture, .5, 1), mix(red, green, .5F));
    EXPECT_EQ(color_at(*texture, -1.75, 7), red); // as .25
    EXPECT_EQ(color_at(*texture, NAN, 0), gray);
    const image upright{1, 2, {red_pixel, green_pixel}};
    EXPECT_EQ(color_at(upright, 0, 1), red);
    EXPECT_EQ(color_at(upright, 0, 0), green);

    auto shape = rectangle(0, 4, 0, 1, 0, blue);
    shape.texture = texture;
    shape.corner_textures = {{0, 0}, {4, 0}, {4, 1}, {0, 1}}; // four times side by side
    const image drawn = draw(from_the_front({{{shape}}}, 400, 100));
    std::size_t first = 0;
    while (drawn.at(first, 50) == white_pixel)
        ++first;
    const auto width = double(400 - 2 * first);
    const auto at = [&](double share) { return drawn.at(first + std::size_t(width * share), 50); };
    for (const double left : {0., .25, .5, .75}) {
        EXPECT_EQ(at(left + .03), red_pixel) << left;
        EXPECT_EQ(at(left + .21), green_pixel) << left;
    }
    std::ostringstream svg;
    shape.corner_textures = {{0, 0}, {.4F, 0}, {.4F, 1}, {0, 1}};
    write_svg(svg, from_the_front({{{shape}}}, 80, 20));
    EXPECT_NE(svg.str().find("fill='#ff0000'"), std::string::npos);
    shape.corner_textures.pop_back();
    EXPECT_THROW(draw(from_the_front({{{shape}}}, 80, 20)), std::invalid_argument);
}

TEST(picture, png_is_read_as_it_was_written)
{
    if (not writes_png())
        GTEST_SKIP() << "this build has no libpng";
    const image written{2, 2, {{1, 2, 3, 255}, {4, 5, 6, 128}, red_pixel, white_pixel}};
    std::stringstream file;
    write_png(file, written);
    const image read = read_png(file);
    EXPECT_EQ(read.width, 2U);
    EXPECT_EQ(read.pixels, written.pixels);
    const std::string bytes = file.str();
    for (const std::string& damaged : {std::string(), std::string("no picture"), bytes.substr(0, bytes.size() / 2)}) {
        std::istringstream in(damaged);
        EXPECT_THROW(read_png(in), std::runtime_error) << damaged.size();
    }
}

TEST(picture, png_has_the_signature_and_the_size)
{
    if (not writes_png())
        GTEST_SKIP();
    std::ostringstream out;
    write_png(out, draw(from_the_front({{.items = {sphere(9, true)}}}, 70, 30)));
    const std::string bytes = out.str();
    EXPECT_EQ(bytes.substr(0, 8), "\x89PNG\r\n\x1a\n");
    EXPECT_EQ(bytes.substr(16, 8), std::string("\0\0\0\x46\0\0\0\x1e", 8));
    std::ostringstream closed;
    closed.setstate(std::ios::badbit);
    EXPECT_THROW(write_png(closed, draw(from_the_front({}, 3, 3))), std::runtime_error);
}
