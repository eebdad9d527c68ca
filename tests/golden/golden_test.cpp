// SPDX-License-Identifier: BSD-3-Clause
#include "golden_suite.hpp"

INSTANTIATE_TYPED_TEST_SUITE_P(native, golden_files, all_schemes_on<native_mesh<double>>);
INSTANTIATE_TYPED_TEST_SUITE_P(native_float, golden_files, all_schemes_on<native_mesh<float>>);
