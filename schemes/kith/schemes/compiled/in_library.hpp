// SPDX-License-Identifier: BSD-3-Clause

// Declares that the steps of a scheme are compiled in kith::compiled_schemes. Each header of a scheme includes this
// file at its end, so there is no #pragma once. Before that it defines KITH_SCHEME, the type of the scheme. It also
// defines KITH_SCHEME_OF_DOUBLES if the library has the scheme for doubles alone. The file that compiles the scheme
// defines KITH_COMPILE_HERE, too.
#ifdef KITH_COMPILED_SCHEMES

#include <kith/compiled_refine.hpp>

#ifdef KITH_COMPILE_HERE
#define KITH_HOW template
#else
#define KITH_HOW extern template
#endif

namespace kith {

KITH_SCHEME_STEPS(KITH_HOW, KITH_SCHEME)
#ifndef KITH_SCHEME_OF_DOUBLES
KITH_STEPS_OVER(KITH_HOW, KITH_SCHEME, float)
#endif

} // namespace kith

#undef KITH_HOW
#endif

#undef KITH_SCHEME
#undef KITH_SCHEME_OF_DOUBLES
