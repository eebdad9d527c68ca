// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#ifdef KITH_COMPILED_SCHEMES

#include <kith/compiled_refine.hpp>

namespace kith {

KITH_COMPILED_SCHEME(doo_sabin)
KITH_COMPILED_FLOATS(doo_sabin)
KITH_COMPILED_PATCHES(doo_sabin)

} // namespace kith

#endif
