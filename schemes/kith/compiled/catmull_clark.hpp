// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#ifdef KITH_COMPILED_SCHEMES

#include <kith/compiled_refine.hpp>

namespace kith {

KITH_COMPILED_SCHEME(catmull_clark)
KITH_COMPILED_FLOATS(catmull_clark)
KITH_COMPILED_ORDER(catmull_clark)
KITH_COMPILED_PATCHES(catmull_clark)

} // namespace kith

#endif
