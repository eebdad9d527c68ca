// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#ifdef KITH_COMPILED_SCHEMES

#include <kith/compiled_refine.hpp>

namespace kith {

KITH_COMPILED_SCHEME(kobbelt)
KITH_COMPILED_FLOATS(kobbelt)
KITH_COMPILED_ORDER(kobbelt)
KITH_COMPILED_PATCHES(kobbelt)

} // namespace kith

#endif
