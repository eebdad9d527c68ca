// SPDX-License-Identifier: BSD-3-Clause
#include "file_guard.hpp"

#include "errors.hpp"

#include <algorithm>

namespace kith::tool {

namespace {

/// Readers end a line at '\n' alone.
void end_lines_with_newline(std::string& text)
{
    if (text.find('\n') == std::string::npos)
        std::ranges::replace(text, '\r', '\n');
}

} // namespace

file_contents guard(mesh_format format, std::string& bytes)
{
    if (bytes.find_first_not_of(" \t\r\n") == std::string::npos)
        throw file_error("the file is empty");
    switch (format) {
    case mesh_format::ply: return guard_ply(bytes);
    case mesh_format::stl: return guard_stl(bytes);
    case mesh_format::obj: end_lines_with_newline(bytes); return guard_obj(bytes);
    default: end_lines_with_newline(bytes); return guard_off(bytes);
    }
}

} // namespace kith::tool
