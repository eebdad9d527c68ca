// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#ifdef KITH_COMPILED_SCHEMES

#include <kith/compiled_refine.hpp>

namespace kith {

KITH_COMPILED_SCHEME(interpolatory_sqrt3)
KITH_COMPILED_FLOATS(interpolatory_sqrt3)
KITH_COMPILED_ORDER(interpolatory_sqrt3)

} // namespace kith

#endif
