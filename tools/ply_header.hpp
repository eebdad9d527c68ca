// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace kith::tool {

struct ply_number {
    std::size_t bytes = 0;
    bool floating = false;
    bool is_signed = false;
};

struct ply_property {
    std::string name;
    ply_number value;
    ply_number count; ///< of a list; bytes == 0: not a list

    [[nodiscard]] bool is_list() const { return count.bytes != 0; }
};

struct ply_element {
    std::string name;
    std::size_t count = 0;
    std::vector<ply_property> properties;

    [[nodiscard]] bool is_vertex() const { return name == "vertex" or name == "vertices"; }
    [[nodiscard]] bool is_face() const { return name == "face" or name == "faces"; }
};

enum class ply_encoding : unsigned char { text, little_endian, big_endian };

struct ply_header {
    ply_encoding encoding = ply_encoding::text;
    std::vector<ply_element> elements;
    std::size_t vertices = 0;
    std::size_t faces = 0;
    std::size_t data_begin = 0;
    std::size_t data_line = 0; ///< the number of the first line after the header
};

/// Reads a header and refuses what readers cannot take: types they do not know, coordinates that are no floating-point
/// numbers, faces without a list of vertices. Comments before the format line are moved behind it, where readers look.
/// Errors: file_error.
ply_header read_ply_header(std::string& bytes);

} // namespace kith::tool
