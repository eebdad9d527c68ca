// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#ifdef KITH_COMPILED_SCHEMES

#include <kith/compiled_refine.hpp>

namespace kith {

KITH_COMPILED_SCHEME(mid_edge)
KITH_COMPILED_FLOATS(mid_edge)
KITH_COMPILED_PATCHES(mid_edge)

} // namespace kith

#endif
