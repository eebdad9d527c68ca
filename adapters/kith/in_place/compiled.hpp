// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "carried_properties.hpp"
#include "refine_in_place.hpp"

#include <kith/presets.hpp>

#include <array>
#include <functional>
#include <optional>

/// How meshes with properties are refined for the dialects, by all schemes; kith::compiled_dialects has it, which is
/// linked with kith::compiled_cgal and kith::compiled_openmesh and defines KITH_COMPILED_DIALECTS.
/// KITH_FLOATS_IN_PLACE: by those that kith::compiled_schemes has for floats.
#define KITH_REFINE_IN_PLACE(How, Number, Scheme)                                                                      \
    How std::optional<in_place::refined<std::array<Number, 3>>> in_place::refine(                                      \
        in_place::native_mesh<std::array<Number, 3>>,                                                                  \
        Scheme&,                                                                                                       \
        int,                                                                                                           \
        in_place::carried_values<double>&,                                                                             \
        bool,                                                                                                          \
        const std::function<bool(double)>&);
#define KITH_MANY_IN_PLACE(How, Number)                                                                                \
    KITH_REFINE_IN_PLACE(How, Number, butterfly)                                                                       \
    KITH_REFINE_IN_PLACE(How, Number, catmull_clark)                                                                   \
    KITH_REFINE_IN_PLACE(How, Number, doo_sabin)                                                                       \
    KITH_REFINE_IN_PLACE(How, Number, four_eight)                                                                      \
    KITH_REFINE_IN_PLACE(How, Number, interpolatory_sqrt3)                                                             \
    KITH_REFINE_IN_PLACE(How, Number, kobbelt)                                                                         \
    KITH_REFINE_IN_PLACE(How, Number, linear)                                                                          \
    KITH_REFINE_IN_PLACE(How, Number, linear_triangles)                                                                \
    KITH_REFINE_IN_PLACE(How, Number, loop)                                                                            \
    KITH_REFINE_IN_PLACE(How, Number, mid_edge)                                                                        \
    KITH_REFINE_IN_PLACE(How, Number, sqrt3)
#define KITH_FLOATS_IN_PLACE(How) KITH_MANY_IN_PLACE(How, float)
#define KITH_DOUBLES_IN_PLACE(How)                                                                                     \
    KITH_MANY_IN_PLACE(How, double)                                                                                    \
    KITH_REFINE_IN_PLACE(How, double, nasri_hasbini)                                                                   \
    KITH_REFINE_IN_PLACE(How, double, unified)

#ifdef KITH_COMPILED_DIALECTS

namespace kith {

KITH_DOUBLES_IN_PLACE(extern template)
KITH_FLOATS_IN_PLACE(extern template)

} // namespace kith

#endif
