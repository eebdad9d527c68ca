// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#ifdef KITH_COMPILED_SCHEMES

#include <kith/compiled_refine.hpp>

namespace kith {

KITH_COMPILED_SCHEME(sqrt3)
KITH_COMPILED_FLOATS(sqrt3)
KITH_COMPILED_ORDER(sqrt3)
KITH_COMPILED_PATCHES(sqrt3)

} // namespace kith

#endif
