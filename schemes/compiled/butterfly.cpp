// SPDX-License-Identifier: BSD-3-Clause
#include <kith/butterfly.hpp>

#include <kith/compiled_refine.hpp>

namespace kith {

KITH_COMPILE_SCHEME(butterfly)
KITH_COMPILE_FLOATS(butterfly)
KITH_COMPILE_ORDER(butterfly)
KITH_COMPILE_PATCHES(butterfly)

} // namespace kith
