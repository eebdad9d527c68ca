// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/surface.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <vector>

/// Functions for SVG pictures of surfaces around the point (0.8, 0.8, 0.5), seen from one side.
namespace painting {

using point = std::array<double, 3>;

/// Returns a point in the coordinates of the picture: right, up and out of the page.
inline point turn(const point& p)
{
    const double x = p[0] - 0.8, y = p[1] - 0.8, z = p[2] - 0.5;
    const double right = 0.56 * y - 0.83 * x, away = -0.56 * x - 0.83 * y;
    return {right, 0.87 * z + 0.5 * away, 0.87 * -away + 0.5 * z};
}

/// A list of triangles that are painted from back to front.
class triangles {
public:
    /// Adds a triangle of a tessellation. `color` is red, green and blue between 0 and 1; less light makes the triangle
    /// darker. A triangle that is seen from behind is left out.
    void add(const kith::tessellation<point>& from, std::size_t face, const std::array<double, 3>& color)
    {
        triangle made{};
        double light = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto v = from.mesh.face(face)[k];
            const auto& normal = from.normals[v];
            made.corners[k] = turn(from.mesh.point(v));
            made.depth += made.corners[k][2] / 3;
            light += (0.2 * normal[0] + 0.4 * normal[1] + 0.9 * normal[2]) / 3;
        }
        const auto& [a, b, c] = made.corners;
        if ((b[0] - a[0]) * (c[1] - a[1]) <= (b[1] - a[1]) * (c[0] - a[0]))
            return;
        const double shade = 255 * (.55 + .45 * std::fmax(light, 0));
        for (std::size_t i = 0; i < 3; ++i)
            made.color[i] = unsigned(color[i] * shade);
        all_.push_back(made);
    }
    /// Prints all triangles, moved to the right by `left`.
    void print(double left)
    {
        std::ranges::sort(all_, {}, &triangle::depth); // the painter's algorithm
        for (const auto& [corners, depth, color] : all_) {
            std::printf("<path color='#%02x%02x%02x' d='M", color[0], color[1], color[2]);
            for (const point& p : corners)
                std::printf("%.1f %.1f ", left + 165 + 115 * p[0], 160 - 115 * p[1]);
            std::printf("z'/>\n");
        }
    }

private:
    struct triangle {
        std::array<point, 3> corners;
        double depth;
        std::array<unsigned, 3> color;
    };

    std::vector<triangle> all_;
};

/// Prints the beginning of a picture; `lines` is the SVG style of its lines.
inline void begin(int width, int height, const char* lines)
{
    std::printf("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 %d %d'>\n<style>path{fill:currentColor;"
                "%s;stroke-linejoin:round}</style>\n<rect width='%d' height='%d' fill='white'/>\n",
                width,
                height,
                lines,
                width,
                height);
}
inline void end()
{
    std::printf("</svg>\n");
}

} // namespace painting
