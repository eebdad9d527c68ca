// SPDX-License-Identifier: BSD-3-Clause
#include <kith/unified.hpp>

#include <kith/compiled_refine.hpp>

namespace kith {

KITH_COMPILE_SCHEME(unified)

} // namespace kith
