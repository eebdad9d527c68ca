// SPDX-License-Identifier: BSD-3-Clause
#include "support/cgal_mesh.hpp"
#include "golden_suite.hpp"

INSTANTIATE_TYPED_TEST_SUITE_P(epeck, golden_files, all_schemes_on<surface_mesh<epeck>>);
