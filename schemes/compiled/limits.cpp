// SPDX-License-Identifier: BSD-3-Clause
#include <kith/limit/limit_surface.hpp>

namespace kith {

KITH_LIMIT_PARTS(template)

} // namespace kith
