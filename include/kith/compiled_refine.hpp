// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "refine.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

/// KITH_COMPILED_REFINE(scheme, mesh) makes a program compile `refine` of this type of mesh by this scheme in one file
/// only. That file says `#define KITH_COMPILE_SCHEMES` before it includes this header. The other files compile little
/// longer than the header of their mesh library. The macro stands at namespace scope, after the adapter of the mesh.
/// The results are the same bits.
#ifdef KITH_COMPILE_SCHEMES
#define KITH_COMPILED_REFINE(Scheme, ...)                                                                              \
    template __VA_ARGS__ kith::refine(const __VA_ARGS__&, const Scheme&, int, const kith::refine_options&);
#else
#define KITH_COMPILED_REFINE(Scheme, ...)                                                                              \
    extern template __VA_ARGS__ kith::refine(const __VA_ARGS__&, const Scheme&, int, const kith::refine_options&);
#endif

/// KITH_SCHEME_STEPS(How, Scheme) lists the steps of a scheme on native meshes of doubles; How is `template` or `extern
/// template`. A program that links kith::compiled_schemes, which defines KITH_COMPILED_SCHEMES, finds the steps there.
/// It compiles only the code that reads and writes its own meshes. The results are the same bits. KITH_STEPS_OVER lists
/// the steps that depend on the type of coordinates. KITH_PATCH_PARTS lists the code that the patches of all schemes
/// share. KITH_PATCH_NUMBERS lists the part of that code that has no coordinates.

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
        const Scheme&, const named_level<std::array<Number, 3>, std::uint32_t>&, int);                                 \
    KITH_PATCHES(How, Scheme, Number)
#define KITH_SCHEME_STEPS(How, Scheme)                                                                                 \
    KITH_STEPS_OVER(How, Scheme, double)                                                                               \
    How basic_mesh<> refine_mesh<connect::faces>(                                                                      \
        const basic_mesh<>&, const Scheme&, numbering_of<Scheme, std::uint32_t>&);                                     \
    How basic_mesh<> refine(const basic_mesh<>&, const Scheme&, int, const refine_options&);
/// KITH_STEP_PARTS(How, Number) lists the code that the steps of all schemes share. KITH_STEP_NUMBERS lists the part of
/// that code that has no coordinates.
#define KITH_STEP_PARTS(How, Number)                                                                                   \
    How void write_level(level_writer<std::array<Number, 3>, std::uint32_t>&,                                          \
                         const basic_mesh<std::array<Number, 3>, std::uint32_t>&);                                     \
    How basic_mesh<std::array<Number, 3>, std::uint32_t> detail::with_edges(                                           \
        const basic_mesh<std::array<Number, 3>, std::uint32_t>&);                                                      \
    How ordered_mesh<std::array<Number, 3>, std::uint32_t> in_surface_order(                                           \
        const basic_mesh<std::array<Number, 3>, std::uint32_t>&);                                                      \
    How class submesh_cutter<std::array<Number, 3>, std::uint32_t>;
#define KITH_STEP_NUMBERS(How)                                                                                         \
    How void detail::require_numbers<std::uint32_t>(std::size_t, std::size_t, const char*);                            \
    How bool is_scattered(const connectivity<std::uint32_t>&);                                                         \
    How class state_marks<std::uint32_t>;
#ifdef KITH_HAS_LANES
#define KITH_PATCHES(How, Scheme, Number)                                                                              \
    How std::shared_ptr<const part_recorder<Number, std::uint32_t>> recorder_of(                                       \
        const Scheme&, const patch_plan&, int, const patch_output_kind<Number, std::uint32_t, Scheme>&);
#define KITH_PATCH_PARTS(How, Number)                                                                                  \
    How class lane_program_maker<Number>;                                                                              \
    How class template_assembler<Number, std::uint32_t>;                                                               \
    How class submesh_cutter<recorded<Number>, std::uint32_t>;                                                         \
    How class patch_filler<std::array<Number, 3>, std::uint32_t>;                                                      \
    How class patched_level<std::array<Number, 3>, std::uint32_t>;
#define KITH_PATCH_NUMBERS(How)                                                                                        \
    How class face_walk<std::uint32_t>;                                                                                \
    How class face_classes<std::uint32_t>;                                                                             \
    How class sources_of_part<std::uint32_t>;                                                                          \
    How struct part_of_whole<affine_number<std::uint32_t>>;                                                            \
    How struct part_of_whole<owned_number<std::uint32_t>>;                                                             \
    How double share_of_classes(const connectivity<std::uint32_t>&, int, std::size_t);                                 \
    How void allocate_faces(                                                                                           \
        connectivity<std::uint32_t>&, const connectivity<std::uint32_t>&, std::span<const column_bases>);
#else
#define KITH_PATCHES(How, Scheme, Number)
#define KITH_PATCH_PARTS(How, Number)
#define KITH_PATCH_NUMBERS(How)
#endif

#ifdef KITH_COMPILED_SCHEMES
namespace kith {
KITH_STEP_PARTS(extern template, double)
KITH_STEP_PARTS(extern template, float)
KITH_STEP_NUMBERS(extern template)
KITH_PATCH_PARTS(extern template, double)
KITH_PATCH_PARTS(extern template, float)
KITH_PATCH_NUMBERS(extern template)
} // namespace kith
#endif
