// SPDX-License-Identifier: BSD-3-Clause
#include "support/cgal_mesh.hpp"
#include "golden_suite.hpp"

INSTANTIATE_TYPED_TEST_SUITE_P(cartesian, golden_files, all_schemes_on<surface_mesh<CGAL::Simple_cartesian<double>>>);
INSTANTIATE_TYPED_TEST_SUITE_P(epick, golden_files, two_schemes_on<surface_mesh<epick>>);
