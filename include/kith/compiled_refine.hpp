// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "refine.hpp"

/// KITH_COMPILED_REFINE(scheme, mesh): `refine` of this type of mesh by this scheme is compiled once, in the one file of the program
/// that says `#define KITH_COMPILE_SCHEMES` before it includes this; the others take little longer than their mesh library's
/// header. At namespace scope, after the mesh's adapter; the results are the same bits.
#ifdef KITH_COMPILE_SCHEMES
#define KITH_COMPILED_REFINE(Scheme, ...)                                                                              \
    template __VA_ARGS__ kith::refine(const __VA_ARGS__&, const Scheme&, int, const kith::refine_options&);
#else
#define KITH_COMPILED_REFINE(Scheme, ...)                                                                              \
    extern template __VA_ARGS__ kith::refine(const __VA_ARGS__&, const Scheme&, int, const kith::refine_options&);
#endif
