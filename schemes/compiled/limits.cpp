// SPDX-License-Identifier: BSD-3-Clause
#include <kith/limits/limit_surface.hpp>

namespace kith {

KITH_LIMIT_PARTS(template)

} // namespace kith
