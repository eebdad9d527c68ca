// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "carried_properties.hpp"
#include "refine_in_place.hpp"

#include <kith/compiled_schemes.hpp>
#include <kith/presets.hpp>

#include <array>
#include <functional>
#include <optional>

/// Declares or instantiates the refinement in place of meshes with properties, which the dialects use, for one scheme.
/// The library kith::compiled_dialects has the instances for all schemes. It is linked with kith::compiled_cgal and
/// kith::compiled_openmesh and defines KITH_COMPILED_DIALECTS.
#define KITH_REFINE_IN_PLACE(How, Number, Scheme)                                                                      \
    How std::optional<in_place::refined<std::array<Number, 3>>> in_place::refine(                                      \
        in_place::native_mesh<std::array<Number, 3>>,                                                                  \
        Scheme&,                                                                                                       \
        int,                                                                                                           \
        in_place::carried_values<double>&,                                                                             \
        bool,                                                                                                          \
        const std::function<bool(double)>&);
// These make an instance of a line of the registry of schemes, or its declaration, as KITH_HOW says.
#define KITH_DOUBLES_IN_PLACE(type, header, numbers, paper) KITH_REFINE_IN_PLACE(KITH_HOW, double, type)
#define KITH_FLOATS_IN_PLACE(type, header, numbers, paper) KITH_FLOATS_IF_##numbers(type)
#define KITH_FLOATS_IF_floats(type) KITH_REFINE_IN_PLACE(KITH_HOW, float, type)
#define KITH_FLOATS_IF_doubles(type)

#ifdef KITH_COMPILED_DIALECTS

namespace kith {

#define KITH_HOW extern template
KITH_SCHEMES(KITH_DOUBLES_IN_PLACE)
KITH_SCHEMES(KITH_FLOATS_IN_PLACE)
#undef KITH_HOW

} // namespace kith

#endif
