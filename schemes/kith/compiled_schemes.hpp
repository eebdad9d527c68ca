// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "butterfly.hpp"
#include "catmull_clark.hpp"
#include "doo_sabin.hpp"
#include "four_eight.hpp"
#include "interpolatory_sqrt3.hpp"
#include "kobbelt.hpp"
#include "linear.hpp"
#include "loop.hpp"
#include "mid_edge.hpp"
#include "nasri_hasbini.hpp"
#include "sqrt3.hpp"
#include "tri_quad.hpp"
#include "unified.hpp"

#include <kith/refine_in_patches.hpp>
#include <kith/refine_in_surface_order.hpp>

#include <array>
#include <cstdint>

/// All schemes, and their steps on native meshes of doubles compiled once: where this is included they are left to the
/// one file of the program that says `#define KITH_COMPILE_SCHEMES` before. Files that refine by many schemes then compile
/// in half the time; the results are the same bits. Nothing else in kith needs it.

namespace kith {

#ifdef KITH_COMPILE_SCHEMES
#define KITH_STEP template
#else
#define KITH_STEP extern template
#endif
#define KITH_STEPS(Scheme)                                                                                             \
    KITH_STEP basic_mesh<> refine_mesh<connect::everything>(                                                           \
        const basic_mesh<>&, const Scheme&, numbering_of<Scheme, std::uint32_t>&);                                     \
    KITH_STEP basic_mesh<> refine_mesh<connect::faces>(                                                                \
        const basic_mesh<>&, const Scheme&, numbering_of<Scheme, std::uint32_t>&);

KITH_STEPS(butterfly)
KITH_STEPS(catmull_clark)
KITH_STEPS(doo_sabin)
KITH_STEPS(four_eight)
KITH_STEPS(interpolatory_sqrt3)
KITH_STEPS(kobbelt)
KITH_STEPS(linear)
KITH_STEPS(linear_triangles)
KITH_STEPS(loop)
KITH_STEPS(mid_edge)
KITH_STEPS(nasri_hasbini)
KITH_STEPS(sqrt3)
KITH_STEPS(unified)
KITH_STEPS(detail::centroid_split)
KITH_STEPS(detail::diagonal_split)

#undef KITH_STEPS

#define KITH_ORDERED_LEVELS(Scheme) KITH_STEP basic_mesh<> refine_in_surface_order(const basic_mesh<>&, Scheme, int);

KITH_ORDERED_LEVELS(butterfly)
KITH_ORDERED_LEVELS(catmull_clark)
KITH_ORDERED_LEVELS(interpolatory_sqrt3)
KITH_ORDERED_LEVELS(kobbelt)
KITH_ORDERED_LEVELS(loop)
KITH_ORDERED_LEVELS(sqrt3)

#undef KITH_ORDERED_LEVELS

#ifdef KITH_HAS_LANES
#define KITH_PATCHES(Scheme) KITH_STEP class patch_refinement<std::array<double, 3>, std::uint32_t, Scheme>;

KITH_PATCHES(butterfly)
KITH_PATCHES(catmull_clark)
KITH_PATCHES(kobbelt)
KITH_PATCHES(loop)
KITH_PATCHES(sqrt3)

#undef KITH_PATCHES
#endif
#undef KITH_STEP

} // namespace kith
