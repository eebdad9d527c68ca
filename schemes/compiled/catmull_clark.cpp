// SPDX-License-Identifier: BSD-3-Clause
#include <kith/catmull_clark.hpp>

#include <kith/compiled_refine.hpp>

namespace kith {

KITH_COMPILE_SCHEME(catmull_clark)
KITH_COMPILE_FLOATS(catmull_clark)
KITH_COMPILE_ORDER(catmull_clark)
KITH_COMPILE_PATCHES(catmull_clark)

} // namespace kith
