// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#ifdef KITH_COMPILED_SCHEMES

#include <kith/compiled_refine.hpp>

namespace kith {

KITH_COMPILED_SCHEME(detail::centroid_split)
KITH_COMPILED_FLOATS(detail::centroid_split)
KITH_COMPILED_SCHEME(detail::diagonal_split)
KITH_COMPILED_FLOATS(detail::diagonal_split)

} // namespace kith

#endif
