// SPDX-License-Identifier: BSD-3-Clause
#include <kith/surface/surface_locator.hpp>

namespace kith {

template class surface_locator<catmull_clark>;
template class surface_locator<loop>;

} // namespace kith
