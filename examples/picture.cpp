// SPDX-License-Identifier: BSD-3-Clause
// Draws the picture of the README: levels 0 to 3 of four schemes. Each face has the color of its ancestor on level 0.
// Sample run: picture > docs/picture.svg

#include "../tests/support/figures.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/doo_sabin.hpp>
#include <kith/hierarchy.hpp>
#include <kith/loop.hpp>
#include <kith/sqrt3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <vector>

using point = std::array<double, 3>;
using mesh = kith::basic_mesh<point>;

/// Makes three cubes in an L, of quads or, with each quad cut in two, of triangles.
mesh l_shape(bool triangles)
{
    const auto l = figures::cubes({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    const auto shape = triangles ? figures::triangulated(l) : l;
    return kith::make_mesh(shape.points, shape.faces);
}

/// Returns a point in the coordinates of the picture: right, up and out of the page.
point turn(const point& p)
{
    const double x = p[0] - 0.8, y = p[1] - 0.8, z = p[2] - 0.5;
    const double right = 0.83 * x - 0.56 * y, away = 0.56 * x + 0.83 * y;
    return {right, 0.87 * z + 0.5 * away, 0.87 * -away + 0.5 * z};
}

/// Returns the ancestor of a face on level 0, unless an ancestor of the face was made by an edge or a vertex.
template <class Hierarchy, class Face>
std::optional<std::size_t> ancestor(const Hierarchy& levels, int level, Face f)
{
    for (; level > 0; --level) {
        const auto parents = levels.origin(level, f);
        if (not parents.f)
            return {};
        f = *parents.f;
    }
    return f.value;
}

template <class Hierarchy>
void draw(const Hierarchy& levels, int level, double left, double top)
{
    struct shape {
        double depth, light;
        std::optional<std::size_t> color;
        std::vector<point> corners;
    };
    std::vector<shape> shapes;
    for (const auto f : levels.elements(level).faces()) {
        shape s{0, 0, ancestor(levels, level, f.handle()), {}};
        for (const auto v : f.vertices())
            s.corners.push_back(turn(v.point()));
        point n{};
        for (std::size_t i = 0; i < s.corners.size(); ++i) {
            const point &a = s.corners[i], &b = s.corners[(i + 1) % s.corners.size()];
            for (std::size_t k = 0; k < 3; ++k)
                n[k] += (a[(k + 1) % 3] - b[(k + 1) % 3]) * (a[(k + 2) % 3] + b[(k + 2) % 3]);
            s.depth += a[2] / double(s.corners.size());
        }
        const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        if (n[2] <= 0)
            continue; // seen from behind
        s.light = std::max(0., (-0.4 * n[0] + 0.7 * n[1] + 0.6 * n[2]) / length);
        shapes.push_back(s);
    }
    std::ranges::sort(shapes, {}, &shape::depth); // the painter's algorithm
    for (const auto& s : shapes) {
        std::printf("<path fill='hsl(%d,%d%%,%d%%)' d='M",
                    s.color ? int(*s.color * 137 % 360) : 0,
                    s.color ? 45 : 0,
                    int(38 + 42 * s.light));
        for (const auto& p : s.corners)
            std::printf("%.1f %.1f ", left + 90 + 62 * p[0], top + 88 - 62 * p[1]);
        std::printf("z'/>\n");
    }
}

template <class Scheme>
void draw_row(const mesh& control, const char* title, double top)
{
    kith::hierarchy<mesh, Scheme> levels(control);
    levels.refine(3);
    std::printf("<text x='8' y='%.0f'>%s</text>\n", top + 16, title);
    for (int level = 0; level <= 3; ++level)
        draw(levels, level, 180 * level, top);
}

int main()
{
    std::printf(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 720 640' font-family='sans-serif' font-size='14'>\n"
        "<rect width='720' height='640' fill='white'/>\n<g stroke='#333' stroke-width='0.4' "
        "stroke-linejoin='round'>\n");
    draw_row<kith::catmull_clark>(l_shape(false), "Catmull-Clark", 0);
    draw_row<kith::doo_sabin>(l_shape(false), "Doo-Sabin", 160);
    draw_row<kith::loop>(l_shape(true), "Loop", 320);
    draw_row<kith::sqrt3>(l_shape(true), "sqrt(3)", 480);
    std::printf("</g>\n</svg>\n");
}
