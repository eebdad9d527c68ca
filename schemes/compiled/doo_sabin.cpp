// SPDX-License-Identifier: BSD-3-Clause
#include <kith/doo_sabin.hpp>

#include <kith/compiled_refine.hpp>

namespace kith {

KITH_COMPILE_SCHEME(doo_sabin)
KITH_COMPILE_FLOATS(doo_sabin)
KITH_COMPILE_PATCHES(doo_sabin)

} // namespace kith
