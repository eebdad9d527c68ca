// SPDX-License-Identifier: BSD-3-Clause
#include <kith/sqrt3.hpp>

#include <kith/compiled_refine.hpp>

namespace kith {

KITH_COMPILE_SCHEME(sqrt3)
KITH_COMPILE_FLOATS(sqrt3)
KITH_COMPILE_ORDER(sqrt3)
KITH_COMPILE_PATCHES(sqrt3)

} // namespace kith
