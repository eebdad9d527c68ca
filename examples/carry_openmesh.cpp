// SPDX-License-Identifier: BSD-3-Clause
// Refines a mesh of OpenMesh. Its colours, texture coordinates with seams, labels and marked edges are carried along.
// Sample run: carry_openmesh

#include "dressed_cube_openmesh.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/make_creases.hpp>
#include <kith/openmesh_properties.hpp>

int main()
{
    const mesh cube = dressed_cube();
    const kith::catmull_clark scheme{.sharpness = kith::creases_from_features(cube)};
    const auto [smooth, report] = kith::refine_with_properties(cube, scheme, 3);
    return report.left_out.empty() and is_dressed(smooth) ? 0 : 1;
}
