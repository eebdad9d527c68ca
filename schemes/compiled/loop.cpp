// SPDX-License-Identifier: BSD-3-Clause
#include <kith/loop.hpp>

#include <kith/compiled_refine.hpp>

namespace kith {

KITH_COMPILE_SCHEME(loop)
KITH_COMPILE_FLOATS(loop)
KITH_COMPILE_ORDER(loop)
KITH_COMPILE_PATCHES(loop)

} // namespace kith
