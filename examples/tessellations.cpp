// SPDX-License-Identifier: BSD-3-Clause
// Draws tessellations of a limit surface: of Catmull-Clark with creases, in triangles by a large chord error and by a
// small one; or, if a file is given, of Loop's scheme for its triangle mesh by one chord error.
// Sample runs: tessellations > docs/tessellations.svg, tessellations hand.off 0.02 > docs/hand.svg

#include "creased_cubes.hpp"
#include "painted_triangles.hpp"

#include <kith/loop.hpp>
#include <kith/read_mesh.hpp>
#include <kith/surface.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <vector>

using point = std::array<double, 3>;

/// Returns the points as the picture shows them: the longest extent is upright and has length 1.7.
std::vector<point> in_view(const std::vector<point>& points)
{
    point least = points[0], most = points[0];
    for (const point& p : points)
        for (std::size_t k = 0; k < 3; ++k) {
            least[k] = std::min(least[k], p[k]);
            most[k] = std::max(most[k], p[k]);
        }
    std::size_t up = 0;
    for (std::size_t k = 1; k < 3; ++k)
        if (most[k] - least[k] > most[up] - least[up])
            up = k;
    const double scale = 1.7 / (most[up] - least[up]);
    constexpr point centre{.8, .8, .5};
    std::vector<point> result(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t from = (up + 1 + k) % 3;
            result[i][k] = centre[k] + scale * (points[i][from] - (least[from] + most[from]) / 2);
        }
    return result;
}

template <class Scheme>
void draw(const kith::basic_mesh<point>& control, const Scheme& scheme, double error, double left)
{
    const auto fine = tessellate(control, scheme, {.chord_error = error});
    painting::triangles triangles;
    for (std::size_t f = 0; f < fine.mesh.face_count(); ++f)
        triangles.add(fine, f, {.8, .9, 1});
    triangles.print(left);
}

int main(int count, char** words)
{
    if (count == 3) {
        const auto soup = kith::io::read_mesh_file(words[1]);
        painting::begin(330, 300, "stroke:#246;stroke-width:.2");
        draw(kith::make_mesh(in_view(soup.points), soup.faces), kith::loop{}, std::atof(words[2]), 0);
    } else {
        const creased_cubes cubes;
        painting::begin(660, 300, "stroke:#246;stroke-width:.4");
        draw(cubes.control, cubes.creased, .1, 0);
        draw(cubes.control, cubes.creased, .02, 330);
    }
    painting::end();
}
