// SPDX-License-Identifier: BSD-3-Clause
#include <kith/mid_edge.hpp>

#include <kith/compiled_refine.hpp>

namespace kith {

KITH_COMPILE_SCHEME(mid_edge)
KITH_COMPILE_FLOATS(mid_edge)
KITH_COMPILE_PATCHES(mid_edge)

} // namespace kith
