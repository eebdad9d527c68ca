// SPDX-License-Identifier: BSD-3-Clause
// Refines a CGAL mesh. Its colours, texture coordinates with seams, labels and constrained edges are carried by name.
// Sample run: carry_cgal

#include "dressed_cube_cgal.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/cgal_properties.hpp>
#include <kith/make_creases.hpp>

int main()
{
    mesh cube = dressed_cube();
    const auto constrained = cube.add_property_map<mesh::Edge_index, bool>("e:is_constrained").first;
    const kith::catmull_clark scheme{.sharpness = kith::make_creases(cube, constrained)};
    const auto [smooth, report] = kith::refine_with_properties(cube, scheme, 3);
    return report.left_out.empty() and is_dressed(smooth) ? 0 : 1;
}
