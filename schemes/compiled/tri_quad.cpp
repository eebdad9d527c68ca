// SPDX-License-Identifier: BSD-3-Clause
#include <kith/tri_quad.hpp>

#include <kith/compiled_refine.hpp>

namespace kith {

KITH_COMPILE_SCHEME(detail::centroid_split)
KITH_COMPILE_FLOATS(detail::centroid_split)
KITH_COMPILE_SCHEME(detail::diagonal_split)
KITH_COMPILE_FLOATS(detail::diagonal_split)

} // namespace kith
