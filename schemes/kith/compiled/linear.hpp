// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#ifdef KITH_COMPILED_SCHEMES

#include <kith/compiled_refine.hpp>

namespace kith {

KITH_COMPILED_SCHEME(linear)
KITH_COMPILED_FLOATS(linear)
KITH_COMPILED_SCHEME(linear_triangles)
KITH_COMPILED_FLOATS(linear_triangles)

} // namespace kith

#endif
