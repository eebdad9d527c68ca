// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/mesh/basic_mesh.hpp>
#include <kith/io/format/mesh_attributes.hpp>
#include <kith/io/format/mesh_format.hpp>
#include <kith/io/format/mesh_tags.hpp>

#include <array>
#include <cstddef>
#include <iosfwd>
#include <span>
#include <string>

namespace kith::io {

/// A mesh and the data that are written with it.
struct written_mesh {
    const basic_mesh<>& mesh;
    std::span<const std::array<double, 3>> normals{};  ///< one per vertex, or none; STL has its own
    std::span<const std::array<double, 3>> isolated{}; ///< points of no face, which come after the vertices; not in STL
    const mesh_tags* tags = nullptr;                   ///< OBJ only
    bool binary = false;                               ///< PLY in doubles and STL in floats
    const mesh_attributes* attributes = nullptr;       ///< of the mesh, then of the isolated points; see held_by
    std::span<const std::array<double, 3>> corner_normals{}; ///< one per corner of the faces, or none; OBJ and PLY only
};

/// Throws file_error, before anything is written, for faces that a format has no room for and for places and normals
/// that are not finite. In binary STL also for places that are too large for its floats, or that fall together so that
/// no surface is left. Cost: one sweep over the mesh; for binary STL O(V log V).
/// Preconditions: attributes have a value per element, of their type.
void require_writable(mesh_format format, const written_mesh& what);

/// Returns the number of triangles of which two corners are equal as floats; binary STL is written without these
/// triangles. Precondition: triangles. Cost: one sweep over the mesh.
std::size_t fallen_faces(const written_mesh& what);

/// Writes a mesh. Numbers in text have the shortest digits that read back as the same doubles. The bytes are the same
/// on any number of threads.
/// Preconditions: require_writable. Errors: those of the stream, in its state. Cost: one sweep over the mesh, a few MB
/// of memory.
void write_mesh(std::ostream& out, mesh_format format, const written_mesh& what);

/// Writes a mesh into a file, in the format of its extension, or OFF to standard output ("-"). Calls require_writable
/// first. The file appears when it is complete. Errors: file_error, which begins with the path; there is no file then,
/// or the earlier one.
void write_mesh_file(const std::string& path, const written_mesh& what);

} // namespace kith::io
