// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "job_memory.hpp"
#include "repair_input.hpp"
#include "schemes.hpp"

#include <kith/core/mesh/basic_mesh.hpp>

#include <cstdint>
#include <string>

namespace kith::tool {

/// What is refined in tiles, by one process or by many; the bytes of the output depend on this and on nothing else.
struct tile_request {
    std::string scheme_name{};
    scheme_words words{};
    any_scheme scheme; ///< with the creases of the control mesh
    int levels = 0;
    std::string output;
    bool with_origin = false; ///< rank and tile of each cell, so that the bytes depend on the job as well
    bool limit = false;       ///< the vertices at their places on the limit surface, with the normals there
    input_repair repair{};    ///< of the control mesh
    face_varying_linear linear = face_varying_linear::all; ///< of the attributes of corners
    basic_mesh<> control{};
    io::mesh_attributes kinds{}; ///< of what is carried, the same on all ranks
    attribute_fields attributes{};
};

/// Returns whether the output has normals of the corners: it is .ply, and edges of the control mesh stay sharp for
/// ever.
bool has_corner_normals(const tile_request& request);

/// Returns what the memory of a job depends on, whose threads may refine so many tiles at once.
tiling_kind tiling_of(const tile_request& request, std::uint64_t threads = 1);

/// Returns how many tiles each rank refines if nothing else is said: usual_tiles, which all together have at least.
/// Precondition: the control mesh has been read. Errors: mesh_error for counts beyond 64 bits.
std::uint64_t usual_tiles_per_rank(const tile_request& request, std::uint64_t ranks = 1);

/// Reads the control mesh of a request, with what the output holds of its attributes, and what the file says of its
/// creases. Errors: file_error, mesh_error.
void read_control(tile_request& request, const std::string& path);

/// The same of a mesh that has been read, and whose creases the scheme has been told; what the output does not hold is
/// added to what is not kept. Errors: mesh_error.
void take_control(tile_request& request, control_mesh& control);

} // namespace kith::tool
