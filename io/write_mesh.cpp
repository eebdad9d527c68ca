// SPDX-License-Identifier: BSD-3-Clause
#include <kith/write_mesh.hpp>

#include "written_parts.hpp"

#include <kith/output_file.hpp>
#include <kith/text/file_error.hpp>
#include <kith/text/text_cursor.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <limits>
#include <string>

namespace kith::io {

namespace {

using point = std::array<double, 3>;

bool is_finite(const point& p)
{
    return std::isfinite(p[0]) and std::isfinite(p[1]) and std::isfinite(p[2]);
}

bool fits_float(const point& p)
{
    return std::ranges::all_of(p, [](double x) { return std::isfinite(float(x)); });
}

[[noreturn]] void refuse_vtu()
{
    throw file_error("files of VTK are written in tiles, by kith::vtu_file; choose .off, .obj, .ply or .stl");
}

} // namespace

void require_writable(mesh_format format, const written_mesh& what)
{
    if (format == mesh_format::vtu)
        refuse_vtu();
    const basic_mesh<>& mesh = what.mesh;
    const bool in_floats = format == mesh_format::stl and what.binary;
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        if (not is_finite(mesh.point(v)))
            throw file_error("vertex " + std::to_string(v) +
                             " would not have finite coordinates; the coordinates of the input are too large");
        if (in_floats and not fits_float(mesh.point(v)))
            throw file_error("vertex " + std::to_string(v) +
                             " is too far away for the floats of binary STL; write text, or .off, .obj or .ply");
    }
    if (format != mesh_format::stl)
        for (std::size_t v = 0; v < what.normals.size(); ++v)
            if (not is_finite(what.normals[v]))
                throw file_error("vertex " + std::to_string(v) +
                                 " would have no finite normal; the coordinates of the input are too large");
    if (format == mesh_format::obj or format == mesh_format::ply)
        for (std::size_t c = 0; c < what.corner_normals.size(); ++c)
            if (not is_finite(what.corner_normals[c]))
                throw file_error("vertex " + std::to_string(mesh.topology().corner_vertex[c]) +
                                 " would have no finite normal; the coordinates of the input are too large");
    if (format == mesh_format::off or format == mesh_format::obj) {
        const held_attributes held = held_by(format, what);
        for (const auto* list : {&held.colors,
                                 &held.normals,
                                 &held.textures,
                                 &held.face_colors,
                                 &held.corner_normals,
                                 &held.corner_textures})
            for (const attribute* a : *list)
                if (std::ranges::any_of(a->values, [](double x) { return std::isinf(x); }))
                    throw file_error("a value of '" + shown(a->name) +
                                     "' would not be finite; the values of the input are too large, or choose .ply");
    }
    for (std::size_t f = 0; format == mesh_format::stl and f < mesh.face_count(); ++f)
        if (mesh.face(f).size() > 3)
            throw file_error("face " + std::to_string(f) + " has " + std::to_string(mesh.face(f).size()) +
                             " corners, this format holds 3 at most; choose .off, .obj or .ply");
    if (in_floats)
        require_readable_floats(what);
    constexpr std::size_t most_in_ply = std::numeric_limits<std::int32_t>::max();
    if (format == mesh_format::ply and vertices_of(what) > most_in_ply)
        throw file_error("the mesh has " + std::to_string(vertices_of(what)) +
                         " vertices, the 32-bit indices of a PLY file count " + std::to_string(most_in_ply) +
                         " at most; choose .off or .obj");
}

void write_mesh(std::ostream& out, mesh_format format, const written_mesh& what)
{
    file_work.begin(vertices_of(what) + what.mesh.face_count());
    switch (format) {
    case mesh_format::off: write_off(out, what); break;
    case mesh_format::obj: write_obj(out, what); break;
    case mesh_format::ply: write_ply(out, what); break;
    case mesh_format::stl: write_stl(out, what); break;
    case mesh_format::vtu: refuse_vtu();
    }
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
