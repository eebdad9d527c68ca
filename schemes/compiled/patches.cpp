// SPDX-License-Identifier: BSD-3-Clause
#include <kith/compiled_refine.hpp>

namespace kith {

KITH_STEP_PARTS(template, double)
KITH_STEP_PARTS(template, float)
KITH_STEP_NUMBERS(template)
KITH_PATCH_PARTS(template, double)
KITH_PATCH_PARTS(template, float)
KITH_PATCH_NUMBERS(template)

} // namespace kith
