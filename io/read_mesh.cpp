// SPDX-License-Identifier: BSD-3-Clause
#include <kith/read_mesh.hpp>

#include "file_format.hpp"

#include <kith/io/text/file_bytes.hpp>
#include <kith/io/text/file_error.hpp>
#include <kith/io/text/text_cursor.hpp>

#include <filesystem>

namespace kith::io {

polygon_soup read_mesh(mesh_format format, std::string_view bytes)
{
    const auto read = file_format_of(format).read;
    if (read == nullptr)
        throw file_error("the format is only written");
    bytes = without_byte_order_mark(bytes);
    if (bytes.find_first_not_of(" \t\r\n") == bytes.npos)
        throw file_error("the file is empty");
    file_work.begin(bytes.size());
    return read(bytes);
}

polygon_soup read_mesh_file(const std::string& path)
{
    const mesh_format format = format_of(path);
    const file_bytes bytes(path);
    try {
        if (const auto read = file_format_of(format).read_in_folder)
            return read(bytes.view(), std::filesystem::path(path).parent_path().string());
        return read_mesh(format, bytes.view());
    } catch (const file_error& error) {
        throw file_error((path == standard_stream ? "standard input" : path) + ": " + error.what());
    }
}

} // namespace kith::io
