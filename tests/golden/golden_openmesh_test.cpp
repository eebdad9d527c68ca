// SPDX-License-Identifier: BSD-3-Clause
#include "golden_suite.hpp"
#include "support/openmesh_mesh.hpp"

INSTANTIATE_TYPED_TEST_SUITE_P(poly_mesh, golden_files, all_schemes_on<poly_mesh>);
INSTANTIATE_TYPED_TEST_SUITE_P(poly_mesh_float, golden_files, two_schemes_on<poly_mesh_float>);
INSTANTIATE_TYPED_TEST_SUITE_P(tri_mesh, golden_files, triangle_schemes_on<tri_mesh>);
