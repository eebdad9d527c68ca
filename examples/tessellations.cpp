// SPDX-License-Identifier: BSD-3-Clause
// Draws tessellations of a limit surface: of Catmull-Clark with creases, in triangles by a large chord error and by a
// small one; or, if a file is given, of Loop's scheme for its triangle mesh by a chord error, a part of its height. The
// longest extent of that mesh is upright.
// Sample runs: tessellations > docs/tessellations.svg, tessellations hand.off 85 > docs/hand.svg

#include "creased_cubes.hpp"

#include <kith/loop.hpp>
#include <kith/picture.hpp>
#include <kith/read_mesh.hpp>
#include <kith/surface.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <iostream>

/// Returns the extents of a mesh along the axes.
std::array<double, 3> extents(const kith::basic_mesh<>& mesh)
{
    std::array<double, 3> least = mesh.point(0), most = least;
    for (const auto& p : mesh.points())
        for (std::size_t k = 0; k < 3; ++k) {
            least[k] = std::min(least[k], p[k]);
            most[k] = std::max(most[k], p[k]);
        }
    return {most[0] - least[0], most[1] - least[1], most[2] - least[2]};
}

template <class Scheme>
kith::picture::panel drawn(const kith::basic_mesh<>& control, const Scheme& scheme, double error, double line)
{
    const auto fine = tessellate(control, scheme, {.chord_error = error});
    auto surface = kith::picture::surface_of(fine.mesh);
    surface.paint = {.8F, .9F, 1};
    surface.edges = {.width = line, .ink = {.13F, .27F, .4F}};
    surface.closed = control.corner_count() == 2 * control.edge_count(); // without a boundary
    return {.items = {surface}};
}

int main(int count, char** words)
{
    kith::picture::sheet out{.view = {146, 30}, .width = 660, .height = 300};
    if (count == 3) {
        const auto soup = kith::io::read_mesh_file(words[1]);
        const auto control = kith::make_mesh(soup.points, soup.faces);
        const auto size = extents(control);
        const auto longest = std::ranges::max_element(size);
        out.view.up = int(longest - size.begin());
        out.width = 330;
        out.panels = {drawn(control, kith::loop{}, *longest / std::atof(words[2]), .2)};
    } else {
        const creased_cubes cubes;
        out.panels = {drawn(cubes.control, cubes.creased, .1, .4), drawn(cubes.control, cubes.creased, .02, .4)};
    }
    kith::picture::write_svg(std::cout, out);
}
