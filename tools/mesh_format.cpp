// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_format.hpp"

#include "errors.hpp"

#include <algorithm>
#include <filesystem>

namespace kith::tool {

std::string extension_of(const std::string& path)
{
    std::string extension = std::filesystem::path(path).extension().string();
    std::ranges::transform(
        extension, extension.begin(), [](char c) { return c >= 'A' and c <= 'Z' ? char(c - 'A' + 'a') : c; });
    return extension;
}

mesh_format format_of(const std::string& path)
{
    if (path == standard_stream)
        return mesh_format::off;
    const std::string extension = extension_of(path);
    if (extension == ".off")
        return mesh_format::off;
    if (extension == ".obj")
        return mesh_format::obj;
    if (extension == ".ply")
        return mesh_format::ply;
    if (extension == ".stl")
        return mesh_format::stl;
    throw file_error(path + ": the extension decides the format and must be .off, .obj, .ply or .stl");
}

} // namespace kith::tool
