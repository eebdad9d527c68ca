// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#ifdef KITH_COMPILED_SCHEMES

#include <kith/compiled_refine.hpp>

namespace kith {

KITH_COMPILED_SCHEME(nasri_hasbini)
KITH_COMPILED_PATCHES(nasri_hasbini)

} // namespace kith

#endif
