// SPDX-License-Identifier: BSD-3-Clause
// Draws the curvature of a limit surface of Catmull-Clark, smooth and with creases, in triangles that stay within a
// chord error. Colours show the Gaussian curvature: red where the surface is a dome, blue where it is a saddle.
// Sample run: curvature > docs/curvature.svg

#include "creased_cubes.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/picture.hpp>
#include <kith/surface.hpp>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <string>

constexpr double strongest = 6;

kith::picture::surface drawn(const kith::basic_mesh<>& control, const kith::catmull_clark& scheme)
{
    const auto fine = tessellate(control, scheme, {.segments = 6, .chord_error = .01});
    const auto at = kith::surface_locator(control, scheme).locate(fine.places);
    const auto curvatures = curvatures_of(at.evaluate(control.points(), kith::derivatives::second));
    auto surface = kith::picture::surface_of(fine.mesh);
    surface.closed = true;
    for (std::size_t f = 0; f < fine.mesh.face_count(); ++f) {
        double sum = 0, known = 0;
        for (const auto v : fine.mesh.face(f))
            if (std::isfinite(curvatures[v].gaussian)) { // irregular vertices have no curvature
                sum += curvatures[v].gaussian;
                ++known;
            }
        surface.face_colors.push_back(kith::picture::color_of_signed(known > 0 ? sum / known / strongest : 0));
    }
    return surface;
}

int main()
{
    const creased_cubes cubes;
    kith::picture::sheet out{.panels = {{.items = {drawn(cubes.control, {})}, .title = "smooth"},
                                        {.items = {drawn(cubes.control, cubes.creased)}, .title = "with creases"}},
                             .view = {146, 30},
                             .legend = {.title = "Gaussian", .is_scale = true},
                             .width = 760,
                             .height = 320};
    for (int i = -2; i <= 2; ++i)
        out.legend.entries.push_back({kith::picture::color_of_signed(i / 2.), std::to_string(int(strongest) * i / 2)});
    kith::picture::write_svg(std::cout, out);
}
