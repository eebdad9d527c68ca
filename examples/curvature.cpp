// SPDX-License-Identifier: BSD-3-Clause
// Draws the curvature of a limit surface of Catmull-Clark, smooth and with creases, in triangles that stay within a
// chord error. Colours show the Gaussian curvature: red where the surface is a dome, blue where it is a saddle.
// Sample run: curvature > docs/curvature.svg

#include "creased_cubes.hpp"
#include "painted_triangles.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/surface.hpp>

#include <array>
#include <cmath>
#include <cstddef>

using point = std::array<double, 3>;

/// Returns red, green and blue between 0 and 1: blue for the value -1, white for 0 and red for 1.
std::array<double, 3> color_of(double value)
{
    const double strength = std::fmin(std::abs(value), 1), weak = 1 - .75 * strength;
    return value < 0 ? std::array{weak, weak, 1.} : std::array{1., weak, weak};
}

void draw(const kith::basic_mesh<point>& control, const kith::catmull_clark& scheme, double left)
{
    const auto fine = tessellate(control, scheme, {.segments = 6, .chord_error = .01});
    const auto at = kith::surface_locator(control, scheme).locate(fine.places);
    const auto curvatures = curvatures_of(at.evaluate(control.points(), kith::derivatives::second));
    painting::triangles triangles;
    for (std::size_t f = 0; f < fine.mesh.face_count(); ++f) {
        double sum = 0, known = 0;
        for (const auto v : fine.mesh.face(f))
            if (std::isfinite(curvatures[v].gaussian)) { // irregular vertices have no curvature
                sum += curvatures[v].gaussian;
                ++known;
            }
        constexpr double strongest = 6;
        triangles.add(fine, f, color_of(known > 0 ? sum / known / strongest : 0));
    }
    triangles.print(left);
}

int main()
{
    const creased_cubes cubes;
    painting::begin(660, 300, "stroke:currentColor;stroke-width:.6");
    draw(cubes.control, {}, 0);
    draw(cubes.control, cubes.creased, 330);
    painting::end();
}
