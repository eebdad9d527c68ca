// SPDX-License-Identifier: BSD-3-Clause
#include <kith/interpolatory_sqrt3.hpp>

#include <kith/compiled_refine.hpp>

namespace kith {

KITH_COMPILE_SCHEME(interpolatory_sqrt3)
KITH_COMPILE_FLOATS(interpolatory_sqrt3)
KITH_COMPILE_ORDER(interpolatory_sqrt3)

} // namespace kith
