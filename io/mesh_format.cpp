// SPDX-License-Identifier: BSD-3-Clause
#include "file_format.hpp"

#include <kith/io/text/file_error.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace kith::io {

extern const file_format off_format, obj_format, ply_format, stl_format, vtu_format, vtp_format, glb_format;

namespace {

/// The formats, in the order of mesh_format.
constexpr std::array formats{&off_format, &obj_format, &ply_format, &stl_format, &vtu_format, &vtp_format, &glb_format};

/// Returns the extensions as a text: ".off, .obj or .ply".
std::string listed(const std::vector<std::string_view>& extensions)
{
    std::string result;
    for (std::size_t i = 0; i < extensions.size(); ++i)
        result.append(i == 0 ? "" : i + 1 == extensions.size() ? " or " : ", ").append(extensions[i]);
    return result;
}

const file_format* find_format(const std::string& path)
{
    if (path == standard_stream)
        return &off_format;
    const std::string extension = extension_of(path);
    const auto found = std::ranges::find_if(formats, [&](const file_format* format) {
        return not extension.empty() and (extension == format->extension or extension == format->index);
    });
    return found == formats.end() ? nullptr : *found;
}

} // namespace

const file_format& file_format_of(mesh_format format)
{
    const auto place = std::size_t(format);
    if (place >= formats.size())
        throw file_error("has an unknown format; choose one of mesh_format");
    return *formats[place];
}

const format_contents& contents_of(mesh_format format)
{
    return file_format_of(format).contents;
}

std::string extension_of(const std::string& path)
{
    std::string extension = std::filesystem::path(path).extension().string();
    std::ranges::transform(
        extension, extension.begin(), [](char c) { return c >= 'A' and c <= 'Z' ? char(c - 'A' + 'a') : c; });
    return extension;
}

mesh_format format_of(const std::string& path)
{
    if (const file_format* format = find_format(path); format != nullptr and format->read != nullptr)
        return format->format;
    std::vector<std::string_view> extensions;
    for (const file_format* format : formats) {
        if (format->read == nullptr)
            continue;
        for (const std::string_view extension : {format->extension, format->index})
            if (not extension.empty())
                extensions.push_back(extension);
    }
    throw file_error(path + ": the extension decides the format and must be " + listed(extensions));
}

mesh_format output_format_of(const std::string& path)
{
    const file_format* found = find_format(path);
    if (found != nullptr and found->write != nullptr and (found->index.empty() or extension_of(path) != found->index))
        return found->format;
    std::vector<std::string_view> whole, in_tiles;
    for (const file_format* format : formats)
        if (format->write != nullptr)
            whole.push_back(format->extension);
        else
            in_tiles.insert(in_tiles.end(), {format->extension, format->index});
    throw file_error(path + ": the extension decides the format and must be " + listed(whole) + ", or " +
                     listed(in_tiles) + ", which are written in tiles");
}

} // namespace kith::io
