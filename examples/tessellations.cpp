// SPDX-License-Identifier: BSD-3-Clause
// A picture of tessellations: a limit surface of Catmull-Clark with creases, in triangles by a large chord error and by
// a small one.
// Sample run: tessellations > docs/tessellations.svg

#include "creased_cubes.hpp"
#include "painted_triangles.hpp"

#include <kith/surface.hpp>

#include <array>
#include <cstddef>

int main()
{
    const creased_cubes cubes;
    painting::begin(660, 300, "stroke:#246;stroke-width:.4");
    double left = 0;
    for (const double error : {.1, .02}) {
        const auto fine = tessellate(cubes.control, cubes.creased, {.chord_error = error});
        painting::triangles triangles;
        for (std::size_t f = 0; f < fine.mesh.face_count(); ++f)
            triangles.add(fine, f, {.8, .9, 1});
        triangles.print(left);
        left += 330;
    }
    painting::end();
}
