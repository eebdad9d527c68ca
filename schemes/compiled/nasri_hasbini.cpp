// SPDX-License-Identifier: BSD-3-Clause
#include <kith/nasri_hasbini.hpp>

#include <kith/compiled_refine.hpp>

namespace kith {

KITH_COMPILE_SCHEME(nasri_hasbini)
KITH_COMPILE_PATCHES(nasri_hasbini)

} // namespace kith
