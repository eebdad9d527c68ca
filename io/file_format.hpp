// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/io/format/held_attributes.hpp>
#include <kith/io/format/mesh_format.hpp>
#include <kith/polygon_soup.hpp>
#include <kith/write_mesh.hpp>

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

namespace kith::io {

/// The attributes of vertices and of faces.
struct element_attributes {
    attribute_list vertices, faces;
};

/// A file format: the functions that read and write it, and what it has room for. Each format has one value of this
/// type beside its writer; mesh_format.cpp lists them.
struct file_format {
    mesh_format format;
    std::string_view extension;
    std::string_view index{}; ///< the extension of files that name their pieces; empty: the format has none
    format_contents contents{};
    /// Reads a file. Null: the format is only written.
    polygon_soup (*read)(std::string_view bytes) = nullptr;
    /// Reads a file whose pieces lie in a folder. Null: the format has no pieces.
    polygon_soup (*read_in_folder)(std::string_view bytes, const std::string& folder) = nullptr;
    /// Writes a mesh. Null: the format is written in tiles.
    void (*write)(std::ostream&, const written_mesh&) = nullptr;
    /// Throws file_error if the mesh or something written with it has no room in the format.
    void (*require)(const written_mesh&) = nullptr;
    /// Finds the attributes that the format has room for. Null: tiles decide.
    held_attributes (*held)(const mesh_attributes&, bool binary) = nullptr;
    /// Returns true if the format has room for a line of file_lines. Null: it has none.
    bool (*holds_line)(std::string_view line) = nullptr;
    /// Finds the attributes that are written as 0 if an element has no value. Null: there are none.
    element_attributes (*zeros)(const mesh_attributes&, const held_attributes&) = nullptr;
    /// Returns the names of what the writer rounds, and removes them from `not_held`. Null: the writer rounds nothing.
    std::vector<std::string> (*rounds)(const mesh_attributes&, const held_attributes&,
                                       mesh_attributes& not_held) = nullptr;
};

/// Returns the description of a format. Errors: file_error for a number that is no format.
const file_format& file_format_of(mesh_format format);

} // namespace kith::io
