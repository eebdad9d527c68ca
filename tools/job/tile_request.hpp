// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "job_memory.hpp"
#include "repair_input.hpp"
#include "schemes.hpp"

#include <kith/core/mesh/basic_mesh.hpp>

#include <cstdint>
#include <string>

namespace kith::tool {

/// The request for a refinement in tiles, by one process or by many. The bytes of the output depend on this and on
/// nothing else.
struct tile_request {
    std::string scheme_name{};
    scheme_words words{};
    any_scheme scheme; ///< with the creases of the control mesh
    int levels = 0;
    std::string output;
    bool with_origin = false; ///< write rank and tile of each cell; the bytes then depend on the job as well
    bool limit = false;       ///< write the vertices on the limit surface, with the normals there
    input_repair repair{};    ///< repair of the control mesh
    face_varying_linear linear = face_varying_linear::all; ///< rule for the attributes of corners
    basic_mesh<> control{};
    io::mesh_attributes kinds{}; ///< kinds of the attributes that are carried, the same on all ranks
    attribute_fields attributes{};
};

/// Returns true if the output has normals of corners. This requires a .ply file, limits, and edges of the control mesh
/// that stay sharp forever.
bool has_corner_normals(const tile_request& request);

/// Returns the properties of a job on which its memory depends; `threads` is the number of threads that may refine a
/// tile each.
tiling_kind tiling_of(const tile_request& request, std::uint64_t threads = 1);

/// Returns the default number of tiles per rank, with which all ranks together have at least usual_tiles.
/// Precondition: the control mesh has been read. Errors: mesh_error for counts beyond 64 bits.
std::uint64_t usual_tiles_per_rank(const tile_request& request, std::uint64_t ranks = 1);

/// Reads the control mesh of a request, with the attributes that the output can hold and the creases of the file.
/// Errors: file_error, mesh_error.
void read_control(tile_request& request, const std::string& path);

/// Stores a control mesh in a request, after give_creases. Contents that the output cannot hold are added to what is
/// not kept. Errors: mesh_error.
void take_control(tile_request& request, control_mesh& control);

} // namespace kith::tool
