// SPDX-License-Identifier: BSD-3-Clause
// Tests what a page of `kith view` draws; view_test.py uses whole pages.
#include "viewer/drawing.hpp"

#include <kith/catmull_clark.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace kith::viewer {

namespace {

mesh_type cube()
{
    const std::vector<point> points{
        {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
    const std::vector<std::vector<int>> faces{
        {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}};
    return make_mesh(points, faces);
}

/// Returns level 3 of a cube, projected to a sphere of this radius.
surface_of_scheme<catmull_clark> sphere(double radius)
{
    surface_of_scheme<catmull_clark> refined(cube());
    refined.refine_to(3);
    std::vector<point> points;
    for (const auto v : refined.elements(3).vertices()) {
        point p = v.point();
        const double length = std::hypot(p[0] - .5, p[1] - .5, p[2] - .5);
        for (double& x : p)
            x = (x - .5) / length * radius;
        points.push_back(p);
    }
    const auto& faces = refined.elements(3);
    std::vector<std::vector<std::size_t>> lists;
    for (const auto f : faces.faces()) {
        std::vector<std::size_t>& list = lists.emplace_back();
        for (const auto v : f.vertices())
            list.push_back(v.index());
    }
    return surface_of_scheme<catmull_clark>(make_mesh(points, lists));
}

TEST(Viewer, CurvaturesOfASphereAreThoseOfItsRadius)
{
    const auto ball = sphere(2);
    const auto gaussian = values_of(ball, 0, coloring::gaussian, {}).values;
    for (std::size_t v = 0; v < gaussian.size(); ++v) // angles do not converge at irregular vertices: those of the cube
        EXPECT_NEAR(gaussian[v], 1. / 4, v < 8 ? .08 : .02);
    for (const double h : values_of(ball, 0, coloring::mean, {}).values)
        EXPECT_NEAR(h, -1. / 2, .04);
}

TEST(Viewer, ARayMeetsTheFaceNearestToItsBegin)
{
    const surface_of_scheme<catmull_clark> box(cube());
    EXPECT_EQ(face_at(box.elements(0), {.5, -3, .4}, {0, 1, 0}, {}), 2);
    EXPECT_EQ(face_at(box.elements(0), {.5, 3, .4}, {0, -1, 0}, {}), 4);
    EXPECT_EQ(face_at(box.elements(0), {.5, -3, 1.4}, {0, 1, 0}, {}), std::nullopt);
}

TEST(Viewer, NormalsAreSmoothExceptAtSharpEdges)
{
    surface_of_scheme<catmull_clark> box(cube());
    const auto normals = [&](bool is_smooth) {
        std::vector<drawn_normal> result;
        for (const drawn_corner& c : triangles_of(box, 0, is_smooth, {}))
            if (c.position == std::array<float, 3>{1, 1, 1})
                result.push_back(c.normal);
        return result;
    };
    const drawn_normal diagonal{73, 73, 73, 0}; // 127 / sqrt(3)
    for (const auto& normal : normals(true))
        EXPECT_EQ(normal, diagonal);
    for (const auto& normal : normals(false))
        EXPECT_EQ(int(normal[0]) + normal[1] + normal[2], 127);
    creases sharpness;
    for (const auto e : box.elements(0).vertices()[7].edges())
        sharpness.sharpen_edge(e.index(), 1);
    box.sharpen(sharpness);
    for (const auto& normal : normals(true))
        EXPECT_EQ(int(normal[0]) + normal[1] + normal[2], 127);
}

TEST(Viewer, DescendantsOfAFaceHaveItsColor)
{
    surface_of_scheme<catmull_clark> box(cube());
    box.refine_to(2);
    const std::vector<double> given{3, 1, 4, 1, 5, 9};
    const shown_values shown = values_of(box, 2, coloring::face_number, given);
    ASSERT_EQ(shown.values.size(), 96);
    const auto colors = colors_of(box.elements(2), shown, palette::numbers, {0, 0});
    for (std::size_t f = 0; f < 96; ++f) {
        const auto parent = box.ancestor(2, {element_kind::face, f}, 0);
        EXPECT_EQ(shown.values[f], given[parent.number]);
        EXPECT_EQ(colors[6 * f + 5], color_of(given[parent.number], palette::numbers, {0, 0}));
    }
}

TEST(Viewer, RangesLeaveOutWhatIsNoNumber)
{
    const double none = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(range_of(std::vector{none, 2., -3.}, false), (std::array{-3., 2.}));
    EXPECT_EQ(range_of(std::vector{none, 2., -3.}, true), (std::array{-3., 3.}));
    EXPECT_EQ(range_of(std::vector{none}, true), std::nullopt);
    std::vector<double> many(40, 1);
    many[7] = 1000; // less than a twentieth
    EXPECT_EQ(range_of(many, true), (std::array{-1., 1.}));
}

} // namespace

} // namespace kith::viewer
