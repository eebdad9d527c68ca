// SPDX-License-Identifier: BSD-3-Clause
#include <kith/in_place/compiled.hpp>

namespace kith {

KITH_FLOATS_IN_PLACE(template)

} // namespace kith
