// SPDX-License-Identifier: BSD-3-Clause
#include <kith/linear.hpp>

#include <kith/compiled_refine.hpp>

namespace kith {

KITH_COMPILE_SCHEME(linear)
KITH_COMPILE_FLOATS(linear)
KITH_COMPILE_SCHEME(linear_triangles)
KITH_COMPILE_FLOATS(linear_triangles)

} // namespace kith
