// SPDX-License-Identifier: BSD-3-Clause
// A picture of curvature: a limit surface of Catmull-Clark, smooth and with creases, in triangles that stay within a
// chord error. Colours show the Gaussian curvature: red where the surface is a dome, blue where it is a saddle.
// Sample run: curvature > docs/curvature.svg

#include "../tests/figures.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/mesh/make_mesh.hpp>
#include <kith/surface.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <vector>

using point = std::array<double, 3>;

/// Turned towards the reader: right, up and out of the page.
point turn(const point& p)
{
    const double x = p[0] - 0.8, y = p[1] - 0.8, z = p[2] - 0.5;
    const double right = 0.56 * y - 0.83 * x, away = -0.56 * x - 0.83 * y;
    return {right, 0.87 * z + 0.5 * away, 0.87 * -away + 0.5 * z};
}

/// Returns red, green and blue, 0 to 255: blue for -1, white for 0 and red for 1, darker where there is less light.
std::array<int, 3> color_of(double value, double light)
{
    const double strength = std::fmin(std::abs(value), 1), weak = 1 - .75 * strength;
    const std::array<double, 3> color = value < 0 ? std::array{weak, weak, 1.} : std::array{1., weak, weak};
    const double shade = 255 * (.55 + .45 * light);
    return {int(color[0] * shade), int(color[1] * shade), int(color[2] * shade)};
}

void draw(const kith::basic_mesh<point>& control, const kith::catmull_clark& scheme, double left)
{
    struct triangle {
        std::array<point, 3> corners;
        double depth;
        std::array<int, 3> color;
    };
    const auto fine = tessellate(control, scheme, {.segments = 6, .chord_error = .01});
    const auto normals = fine.normals;
    const auto curvatures = curvatures_of(fine.at.evaluate(control.points(), kith::derivatives::second));
    std::vector<triangle> triangles;
    for (std::size_t f = 0; f < fine.mesh.face_count(); ++f) {
        triangle t{};
        double light = 0, sum = 0, known = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto v = fine.mesh.face(f)[k];
            t.corners[k] = turn(fine.mesh.point(v));
            t.depth += t.corners[k][2] / 3;
            light += (0.2 * normals[v][0] + 0.4 * normals[v][1] + 0.9 * normals[v][2]) / 3;
            if (std::isfinite(curvatures[v].gaussian)) { // not at irregular vertices
                sum += curvatures[v].gaussian;
                ++known;
            }
        }
        const auto& [a, b, c] = t.corners;
        if ((b[0] - a[0]) * (c[1] - a[1]) <= (b[1] - a[1]) * (c[0] - a[0]))
            continue; // seen from behind
        constexpr double strongest = 6;
        t.color = color_of(known > 0 ? sum / known / strongest : 0, std::fmax(light, 0));
        triangles.push_back(t);
    }
    std::ranges::sort(triangles, {}, &triangle::depth); // the painter's algorithm
    for (const auto& [corners, depth, color] : triangles) {
        std::printf("<path color='#%02x%02x%02x' d='M", unsigned(color[0]), unsigned(color[1]), unsigned(color[2]));
        for (const auto& p : corners)
            std::printf("%.1f %.1f ", left + 165 + 115 * p[0], 160 - 115 * p[1]);
        std::printf("z'/>\n");
    }
}

int main()
{
    const auto shape = figures::cubes({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    const auto control = kith::make_mesh(shape.points, shape.faces);
    kith::catmull_clark creased;
    const auto& topology = control.topology();
    for (std::uint32_t corner = 0; corner < topology.corners(); ++corner) {
        const point &a = control.point(topology.corner_vertex[corner]), &b = control.point(topology.target(corner));
        if (a[2] == 1 and b[2] == 1) // on top: sharp for ever, or for one step
            creased.sharpness.sharpen_edge(topology.corner_halfedge[corner] / 2,
                                           a[0] + b[0] > 2 ? kith::infinitely_sharp : 1);
    }
    std::printf("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 660 300'>\n<style>path{fill:currentColor;"
                "stroke:currentColor;stroke-width:.6;stroke-linejoin:round}</style>\n"
                "<rect width='660' height='300' fill='white'/>\n");
    draw(control, {}, 0);
    draw(control, creased, 330);
    std::printf("</svg>\n");
}
