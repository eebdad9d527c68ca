// SPDX-License-Identifier: BSD-3-Clause
#include <kith/in_place/compiled.hpp>

namespace kith {

#define KITH_HOW template
KITH_SCHEMES(KITH_FLOATS_IN_PLACE)

} // namespace kith
