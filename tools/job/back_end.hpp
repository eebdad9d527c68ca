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

/// A field that is true on holes; faces that come from a hole are holes. It is empty if there are no holes.
using hole_field = field<field_on::faces, bool, from_parent<>>;

struct refine_request {
    any_scheme scheme;
    int levels = 0;
    memory_limit memory;
    bool with_tags = false;      ///< return the remaining sharpness
    bool limit = false;          ///< move the last level to the limit surface, with the normals there
    bool corner_normals = false; ///< also return normals of corners, which differ on the two sides of sharp edges
    hole_field holes{};          ///< the faces that are left out in the end, if any
    attribute_fields attributes{};
    attribute_counts counted{}; ///< number of attributes, by element
};

struct refined_mesh {
    basic_mesh<> mesh; ///< the last level; its edges may be unknown
    std::uint64_t edges = 0;
    storage<std::array<double, 3>> normals{};        ///< normals of vertices, if the limit was requested
    storage<std::array<double, 3>> corner_normals{}; ///< normals of corners, if they were requested
    io::mesh_tags tags{};                            ///< the remaining sharpness, if it was requested
    hole_field holes{};                              ///< the holes of the last level, if any
    attribute_fields attributes{};
};

/// Refines on one kind of mesh for each function and returns the last level as a native mesh. On meshes of other
/// libraries the refinement goes level by level.
/// Errors: mesh_error, as kith::refine, but the limit applies to all memory that the job needs.
refined_mesh refine_native(basic_mesh<> control, const refine_request& request);
refined_mesh refine_cgal(basic_mesh<> control, const refine_request& request);
refined_mesh refine_openmesh(basic_mesh<> control, const refine_request& request);

/// Returns the strategy by which the last level is made on this kind of mesh, with the reason.
/// Errors: those of kith::strategy_of.
strategy strategy_of(mesh_kind mesh, const basic_mesh<>& control, const refine_request& request);

} // namespace kith::tool
