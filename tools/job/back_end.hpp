// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "attribute_fields.hpp"
#include "job_memory.hpp"
#include "schemes.hpp"

#include <kith/core/mesh/basic_mesh.hpp>
#include <kith/engine/strategy/strategy.hpp>
#include <kith/fields/field.hpp>
#include <kith/io/format/mesh_tags.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace kith::tool {

/// Whether a face is a hole; so are those that come from it. Empty: there are none.
using hole_field = field<field_on::faces, bool, from_parent<>>;

struct refine_request {
    any_scheme scheme;
    int levels = 0;
    memory_limit memory;
    bool with_tags = false;      ///< the sharpness that is left is wanted
    bool limit = false;          ///< the last level at its place on the limit surface, with the normals there
    bool corner_normals = false; ///< and with normals of the corners, which differ on the sides of sharp edges
    hole_field holes{};          ///< the faces that are left out in the end, if there are any
    attribute_fields attributes{};
    attribute_counts counted{}; ///< of them
};

struct refined_mesh {
    basic_mesh<> mesh; ///< of the last level; its edges need not be known
    std::uint64_t edges = 0;
    storage<std::array<double, 3>> normals{};        ///< of the vertices, if the limit was asked for
    storage<std::array<double, 3>> corner_normals{}; ///< of the corners of the faces, if they were asked for
    io::mesh_tags tags{};                            ///< the sharpness that is left, if it was asked for
    hole_field holes{};                              ///< if there are any
    attribute_fields attributes{};
};

/// Refine on one kind of mesh each, level by level, and give the last level back as the native one.
/// Errors: mesh_error, as kith::refine, but all memory is counted that the job needs.
refined_mesh refine_native(basic_mesh<> control, const refine_request& request);
refined_mesh refine_cgal(basic_mesh<> control, const refine_request& request);
refined_mesh refine_openmesh(basic_mesh<> control, const refine_request& request);

/// Returns how refine_native makes the last level, and why. Values at corners may need single steps all the same.
/// Errors: those of strategy_of.
strategy strategy_of_native(const basic_mesh<>& control, const refine_request& request);

} // namespace kith::tool
