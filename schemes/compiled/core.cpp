// SPDX-License-Identifier: BSD-3-Clause
#define KITH_HAS_BODIES
#include <kith/level/validate.hpp>

namespace kith::detail {

template class read_connectivity<std::uint32_t>;

} // namespace kith::detail
