// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "refine.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

/// KITH_COMPILED_REFINE(scheme, mesh): `refine` of this type of mesh by this scheme is compiled once, in the one file
/// of the program that says `#define KITH_COMPILE_SCHEMES` before it includes this; the others take little longer than
/// their mesh library's header. At namespace scope, after the mesh's adapter; the results are the same bits.
#ifdef KITH_COMPILE_SCHEMES
#define KITH_COMPILED_REFINE(Scheme, ...)                                                                              \
    template __VA_ARGS__ kith::refine(const __VA_ARGS__&, const Scheme&, int, const kith::refine_options&);
#else
#define KITH_COMPILED_REFINE(Scheme, ...)                                                                              \
    extern template __VA_ARGS__ kith::refine(const __VA_ARGS__&, const Scheme&, int, const kith::refine_options&);
#endif

/// KITH_COMPILED_SCHEME(scheme), in the folder `compiled` of the schemes: a program that links kith::compiled_schemes,
/// which defines KITH_COMPILED_SCHEMES, finds the steps on native meshes of doubles there, and compiles only what reads
/// and writes its own meshes, if their coordinates are doubles. The results are the same bits. KITH_COMPILED_FLOATS: so
/// for floats, but for the schemes that take longest to compile. KITH_COMPILED_ORDER, KITH_COMPILED_PATCHES: the order
/// of the surface and patches, for the schemes that have them. KITH_PATCH_PARTS: what patches of all schemes share;
/// KITH_PATCH_NUMBERS: what of it does not depend on the type of coordinates.

#define KITH_STEPS_OVER(How, Scheme, Number)                                                                           \
    How basic_mesh<std::array<Number, 3>> refine_mesh<connect::everything>(                                            \
        const basic_mesh<std::array<Number, 3>>&, const Scheme&, numbering_of<Scheme, std::uint32_t>&);                \
    How void refine_mesh_into(level_writer<std::array<Number, 3>, std::uint32_t>&,                                     \
                              const basic_mesh<std::array<Number, 3>>&,                                                \
                              const Scheme&,                                                                           \
                              numbering_of<Scheme, std::uint32_t>&);                                                   \
    How void detail::refine_levels_into(level_writer<std::array<Number, 3>, std::uint32_t>&,                           \
                                        basic_mesh<std::array<Number, 3>>,                                             \
                                        Scheme,                                                                        \
                                        int,                                                                           \
                                        const refine_options&);                                                        \
    How void detail::require_control_level(                                                                            \
        const Scheme&, const named_level<std::array<Number, 3>, std::uint32_t>&, int);
#define KITH_SCHEME_STEPS(How, Scheme)                                                                                 \
    KITH_STEPS_OVER(How, Scheme, double)                                                                               \
    How basic_mesh<> refine_mesh<connect::faces>(                                                                      \
        const basic_mesh<>&, const Scheme&, numbering_of<Scheme, std::uint32_t>&);                                     \
    How basic_mesh<> refine(const basic_mesh<>&, const Scheme&, int, const refine_options&);
#define KITH_ORDERED_LEVELS(How, Scheme) How basic_mesh<> refine_in_surface_order(basic_mesh<>, Scheme, int, connect);
#ifdef KITH_HAS_LANES
#define KITH_PATCHES(How, Scheme)                                                                                      \
    How std::optional<patched_level<std::array<double, 3>, std::uint32_t>> make_patches(                               \
        const basic_mesh<>&,                                                                                           \
        const face_classes<std::uint32_t>&,                                                                            \
        const Scheme&,                                                                                                 \
        const patch_plan&,                                                                                             \
        const patch_costs&,                                                                                            \
        bool,                                                                                                          \
        const patch_output_kind<double, std::uint32_t, Scheme>&);                                                      \
    How class patch_refinement<std::array<double, 3>, std::uint32_t, Scheme>;
#define KITH_PATCH_PARTS(How, Number)                                                                                  \
    How class lane_program_maker<Number>;                                                                              \
    How class template_assembler<Number, std::uint32_t>;                                                               \
    How class submesh_cutter<recorded<Number>, std::uint32_t>;                                                         \
    How class submesh_cutter<std::array<Number, 3>, std::uint32_t>;                                                    \
    How class patch_filler<std::array<Number, 3>, std::uint32_t>;                                                      \
    How class patched_level<std::array<Number, 3>, std::uint32_t>;
#define KITH_PATCH_NUMBERS(How)                                                                                        \
    How class face_walk<std::uint32_t>;                                                                                \
    How class face_classes<std::uint32_t>;                                                                             \
    How class state_marks<std::uint32_t>;                                                                              \
    How class sources_of_part<std::uint32_t>;                                                                          \
    How struct part_of_whole<affine_number<std::uint32_t>>;                                                            \
    How struct part_of_whole<owned_number<std::uint32_t>>;                                                             \
    How double share_of_classes(const connectivity<std::uint32_t>&, int, std::size_t);                                 \
    How void allocate_faces(                                                                                           \
        connectivity<std::uint32_t>&, const connectivity<std::uint32_t>&, std::span<const column_bases>);
#else
#define KITH_PATCHES(How, Scheme)
#define KITH_PATCH_PARTS(How, Number)
#define KITH_PATCH_NUMBERS(How)
#endif

#define KITH_COMPILED_SCHEME(Scheme) KITH_SCHEME_STEPS(extern template, Scheme)
#define KITH_COMPILED_FLOATS(Scheme) KITH_STEPS_OVER(extern template, Scheme, float)
#define KITH_COMPILED_ORDER(Scheme) KITH_ORDERED_LEVELS(extern template, Scheme)
#define KITH_COMPILED_PATCHES(Scheme) KITH_PATCHES(extern template, Scheme)
// The same in the files of kith::compiled_schemes.
#define KITH_COMPILE_SCHEME(Scheme) KITH_SCHEME_STEPS(template, Scheme)
#define KITH_COMPILE_FLOATS(Scheme) KITH_STEPS_OVER(template, Scheme, float)
#define KITH_COMPILE_ORDER(Scheme) KITH_ORDERED_LEVELS(template, Scheme)
#define KITH_COMPILE_PATCHES(Scheme) KITH_PATCHES(template, Scheme)

#ifdef KITH_COMPILED_SCHEMES
namespace kith {
KITH_PATCH_PARTS(extern template, double)
KITH_PATCH_PARTS(extern template, float)
KITH_PATCH_NUMBERS(extern template)
} // namespace kith
#endif
