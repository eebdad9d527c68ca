// SPDX-License-Identifier: BSD-3-Clause
#include <kith/format/mesh_format.hpp>

#include <kith/text/file_error.hpp>

#include <algorithm>
#include <filesystem>
#include <optional>

namespace kith::io {

std::string extension_of(const std::string& path)
{
    std::string extension = std::filesystem::path(path).extension().string();
    std::ranges::transform(
        extension, extension.begin(), [](char c) { return c >= 'A' and c <= 'Z' ? char(c - 'A' + 'a') : c; });
    return extension;
}

namespace {

std::optional<mesh_format> find_format(const std::string& path)
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
    if (extension == ".vtu" or extension == ".vtp" or extension == ".pvtu" or extension == ".pvtp")
        return mesh_format::vtu;
    return std::nullopt;
}

} // namespace

mesh_format format_of(const std::string& path)
{
    if (const auto format = find_format(path))
        return *format;
    throw file_error(path + ": the extension decides the format and must be .off, .obj, .ply, .stl, .vtu, .vtp, .pvtu "
                            "or .pvtp");
}

mesh_format output_format_of(const std::string& path)
{
    if (const auto format = find_format(path); format and *format != mesh_format::vtu)
        return *format;
    throw file_error(path +
                     ": the extension decides the format and must be .off, .obj, .ply or .stl, or .vtu or .pvtu, which "
                     "are written in tiles");
}

} // namespace kith::io
