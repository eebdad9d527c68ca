// SPDX-License-Identifier: BSD-3-Clause
// Draws the picture of the README: levels 0 to 3 of four schemes. Each face has the color of its ancestor on level 0.
// Sample run: picture > docs/picture.svg

#include "../tests/support/figures.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/doo_sabin.hpp>
#include <kith/hierarchy.hpp>
#include <kith/loop.hpp>
#include <kith/picture.hpp>
#include <kith/sqrt3.hpp>

#include <array>
#include <cstddef>
#include <iostream>
#include <optional>

using mesh = kith::basic_mesh<std::array<double, 3>>;

/// Makes three cubes in an L, of quads or, with each quad cut in two, of triangles.
mesh l_shape(bool triangles)
{
    const auto l = figures::cubes({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    const auto shape = triangles ? figures::triangulated(l) : l;
    return kith::make_mesh(shape.points, shape.faces);
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

template <class Scheme>
void draw_row(kith::picture::sheet& out, const mesh& control, const char* title)
{
    kith::hierarchy<mesh, Scheme> levels(control);
    levels.refine(3);
    for (int level = 0; level <= 3; ++level) {
        auto surface = kith::picture::surface_of(levels[level]);
        for (const auto f : levels.elements(level).faces()) {
            const auto number = ancestor(levels, level, f.handle());
            surface.face_colors.push_back(number ? kith::picture::color_of_number(*number) : kith::picture::white);
        }
        surface.edges.width = .4;
        surface.closed = true;
        out.panels.push_back({.items = {surface}, .title = level == 0 ? title : ""});
    }
}

int main()
{
    kith::picture::sheet out{.view = {-34, 30}, .width = 720, .height = 640, .columns = 4};
    draw_row<kith::catmull_clark>(out, l_shape(false), "Catmull-Clark");
    draw_row<kith::doo_sabin>(out, l_shape(false), "Doo-Sabin");
    draw_row<kith::loop>(out, l_shape(true), "Loop");
    draw_row<kith::sqrt3>(out, l_shape(true), "√3");
    kith::picture::write_svg(std::cout, out);
}
