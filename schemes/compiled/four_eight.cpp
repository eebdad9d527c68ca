// SPDX-License-Identifier: BSD-3-Clause
#include <kith/four_eight.hpp>

#include <kith/compiled_refine.hpp>

namespace kith {

KITH_COMPILE_SCHEME(four_eight)
KITH_COMPILE_FLOATS(four_eight)
KITH_COMPILE_PATCHES(four_eight)

} // namespace kith
