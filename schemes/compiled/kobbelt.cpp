// SPDX-License-Identifier: BSD-3-Clause
#include <kith/kobbelt.hpp>

#include <kith/compiled_refine.hpp>

namespace kith {

KITH_COMPILE_SCHEME(kobbelt)
KITH_COMPILE_FLOATS(kobbelt)
KITH_COMPILE_ORDER(kobbelt)
KITH_COMPILE_PATCHES(kobbelt)

} // namespace kith
