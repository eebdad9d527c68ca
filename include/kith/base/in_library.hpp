// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Functions that are no templates and that nobody waits for, such as the texts of errors, are compiled once where a
// program links kith::compiled_schemes: their headers define them KITH_IN_LIBRARY, and only #ifdef KITH_HAS_BODIES.
#ifdef KITH_COMPILED_SCHEMES
#define KITH_IN_LIBRARY
#else
#define KITH_IN_LIBRARY inline
#define KITH_HAS_BODIES
#endif
