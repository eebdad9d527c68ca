// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#ifdef KITH_COMPILED_SCHEMES

#include <kith/compiled_refine.hpp>

namespace kith {

KITH_COMPILED_SCHEME(loop)
KITH_COMPILED_FLOATS(loop)
KITH_COMPILED_ORDER(loop)
KITH_COMPILED_PATCHES(loop)

} // namespace kith

#endif
