// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#ifdef KITH_COMPILED_SCHEMES

#include <kith/compiled_refine.hpp>

namespace kith {

KITH_COMPILED_SCHEME(four_eight)
KITH_COMPILED_FLOATS(four_eight)
KITH_COMPILED_PATCHES(four_eight)

} // namespace kith

#endif
