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

/// Attributes of vertices and of faces.
struct element_attributes {
    attribute_list vertices, faces;
};

/// All that is to be known of a format. Each has one value of this class beside its writer; mesh_format.cpp lists them.
struct file_format {
    mesh_format format;
    std::string_view extension;
    std::string_view index{}; ///< the extension of files that name their pieces; empty: there are none
    format_contents contents{};
    polygon_soup (*read)(std::string_view bytes);
    /// Reads a file in a folder, where its pieces are; nothing: `read` reads all there is.
    polygon_soup (*read_in_folder)(std::string_view bytes, const std::string& folder) = nullptr;
    void (*write)(std::ostream&, const written_mesh&) = nullptr; ///< nothing: it is written in tiles
    /// Refuses what it has no room for, beside places that are not finite. Errors: file_error.
    void (*require)(const written_mesh&) = nullptr;
    /// Finds the attributes that it has room for; nothing: that is asked of its tiles.
    held_attributes (*held)(const mesh_attributes&, bool binary) = nullptr;
    /// Tests whether it has room for a line of file_lines; nothing: for none.
    bool (*holds_line)(std::string_view line) = nullptr;
    /// Finds the attributes that are 0 where an element has none; nothing: there are none.
    element_attributes (*zeros)(const mesh_attributes&, const held_attributes&) = nullptr;
    /// Says what it rounds, and takes that out of what is not held; nothing: it rounds nothing.
    std::vector<std::string> (*rounds)(const mesh_attributes&, const held_attributes&,
                                       mesh_attributes& not_held) = nullptr;
};

const file_format& file_format_of(mesh_format format);

} // namespace kith::io
