// SPDX-License-Identifier: BSD-3-Clause
#include <kith/write_mesh.hpp>

#include "written_parts.hpp"

#include <kith/io/text/file_error.hpp>
#include <kith/io/text/text_cursor.hpp>
#include <kith/output_file.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

namespace kith::io {

namespace {

using point = std::array<double, 3>;

bool is_finite(const point& p)
{
    return std::isfinite(p[0]) and std::isfinite(p[1]) and std::isfinite(p[2]);
}

/// Returns a format that is written here. Errors: file_error.
const file_format& written_format(mesh_format format)
{
    const file_format& result = file_format_of(format);
    if (result.write == nullptr)
        throw file_error("VTU is written in tiles, by kith::vtu_file; choose .vtp or another format");
    return result;
}

} // namespace

void require_finite_normals(const written_mesh& what)
{
    for (std::size_t v = 0; v < what.normals.size(); ++v)
        if (not is_finite(what.normals[v]))
            throw file_error("vertex " + std::to_string(v) +
                             " would have no finite normal; the coordinates of the input are too large");
}

void require_finite_corner_normals(const written_mesh& what)
{
    for (std::size_t c = 0; c < what.corner_normals.size(); ++c)
        if (not is_finite(what.corner_normals[c]))
            throw file_error("vertex " + std::to_string(what.mesh.topology().corner_vertex[c]) +
                             " would have no finite normal; the coordinates of the input are too large");
}

void require_float_points(const written_mesh& what, const std::string& format_and_remedy)
{
    const auto fits_float = [](double x) { return std::isfinite(float(x)); };
    for (std::size_t v = 0; v < what.mesh.vertex_count(); ++v)
        if (not std::ranges::all_of(what.mesh.point(v), fits_float))
            throw file_error("vertex " + std::to_string(v) + " is too far away for the floats of " + format_and_remedy);
}

void require_finite_values(mesh_format format, const written_mesh& what)
{
    const held_attributes held = held_by(format, what);
    for (const auto* list :
         {&held.colors, &held.normals, &held.textures, &held.face_colors, &held.corner_normals, &held.corner_textures})
        for (const attribute* a : *list)
            if (std::ranges::any_of(a->values, [](double x) { return std::isinf(x); }))
                throw file_error("a value of '" + shown(a->name) +
                                 "' would not be finite; the values of the input are too large, or choose .ply");
}

void require_writable(mesh_format format, const written_mesh& what)
{
    const file_format& written = written_format(format);
    for (std::size_t v = 0; v < what.mesh.vertex_count(); ++v)
        if (not is_finite(what.mesh.point(v)))
            throw file_error("vertex " + std::to_string(v) +
                             " would not have finite coordinates; the coordinates of the input are too large");
    written.require(what);
}

void write_mesh(std::ostream& out, mesh_format format, const written_mesh& what)
{
    const file_format& written = written_format(format);
    file_work.begin(vertices_of(what) + what.mesh.face_count());
    written.write(out, what);
}

void write_mesh_file(const std::string& path, const written_mesh& what)
{
    const mesh_format format = output_format_of(path);
    try {
        require_writable(format, what);
    } catch (const file_error& error) {
        throw file_error(path + ": " + error.what());
    }
    if (path == standard_stream) {
        write_mesh(std::cout, format, what);
        if (not std::cout.flush())
            throw file_error("standard output: could not be written completely");
        return;
    }
    output_file file(path);
    write_mesh(file.stream(), format, what);
    file.commit();
}

} // namespace kith::io
