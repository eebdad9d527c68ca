// SPDX-License-Identifier: BSD-3-Clause
#include <kith/read_mesh.hpp>

#include "read_vtu.hpp"

#include <kith/text/file_bytes.hpp>
#include <kith/text/file_error.hpp>
#include <kith/text/text_cursor.hpp>

#include <filesystem>

namespace kith::io {

polygon_soup read_mesh(mesh_format format, std::string_view bytes)
{
    bytes = without_byte_order_mark(bytes);
    if (bytes.find_first_not_of(" \t\r\n") == bytes.npos)
        throw file_error("the file is empty");
    file_work.begin(bytes.size());
    switch (format) {
    case mesh_format::off: return read_off(bytes);
    case mesh_format::obj: return read_obj(bytes);
    case mesh_format::ply: return read_ply(bytes);
    case mesh_format::stl: return read_stl(bytes);
    case mesh_format::vtu: return read_vtu(bytes);
    }
    throw file_error("has an unknown format; choose one of mesh_format");
}

polygon_soup read_mesh_file(const std::string& path)
{
    const mesh_format format = format_of(path);
    const file_bytes bytes(path);
    try {
        if (format == mesh_format::vtu)
            return read_vtu(bytes.view(), std::filesystem::path(path).parent_path().string());
        return read_mesh(format, bytes.view());
    } catch (const file_error& error) {
        throw file_error((path == standard_stream ? "standard input" : path) + ": " + error.what());
    }
}

} // namespace kith::io
