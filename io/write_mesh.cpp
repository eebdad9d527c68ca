// SPDX-License-Identifier: BSD-3-Clause
#include <kith/write_mesh.hpp>

#include <kith/text/counted.hpp>
#include <kith/format/facet_normal.hpp>
#include <kith/text/file_error.hpp>
#include <kith/format/obj_tag.hpp>
#include <kith/text/text_writer.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
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

std::size_t vertices_of(const written_mesh& what)
{
    return what.mesh.vertex_count() + what.isolated.size();
}

const point& point_of(const written_mesh& what, std::size_t vertex)
{
    const std::size_t vertices = what.mesh.vertex_count();
    return vertex < vertices ? what.mesh.point(vertex) : what.isolated[vertex - vertices];
}

/// What has no face has no normal.
point normal_of(const written_mesh& what, std::size_t vertex)
{
    return vertex < what.normals.size() ? what.normals[vertex] : point{};
}

void write_off(std::ostream& out, const written_mesh& what)
{
    const bool has_normals = not what.normals.empty();
    text_block header;
    header << (has_normals ? "NOFF\n" : "OFF\n") << vertices_of(what) << ' ' << what.mesh.face_count() << " 0\n\n";
    out << header.text();
    write_blocks(out, vertices_of(what), [&](text_block& text, std::size_t v) {
        text << point_of(what, v);
        if (has_normals)
            text << "  " << normal_of(what, v);
        text << '\n';
    });
    write_blocks(out, what.mesh.face_count(), [&](text_block& text, std::size_t f) {
        const auto face = what.mesh.face(f);
        text << face.size() << ' ';
        for (const auto v : face)
            text << ' ' << std::size_t(v);
        text << '\n';
    });
    out << '\n';
}

void write_obj(std::ostream& out, const written_mesh& what)
{
    const bool has_normals = not what.normals.empty();
    text_block header;
    header << "# kith: " << counted(vertices_of(what), "vertex") << ", " << counted(what.mesh.face_count(), "face")
           << '\n';
    out << header.text();
    write_blocks(out, vertices_of(what), [&](text_block& text, std::size_t v) {
        text << "v " << point_of(what, v) << '\n';
        if (has_normals)
            text << "vn " << normal_of(what, v) << '\n';
    });
    write_blocks(out, what.mesh.face_count(), [&](text_block& text, std::size_t f) {
        text << "f ";
        for (const auto v : what.mesh.face(f)) {
            text << ' ' << std::size_t(v) + 1;
            if (has_normals)
                text << "//" << std::size_t(v) + 1;
        }
        text << '\n';
    });
    if (what.tags != nullptr)
        out << obj_tag_lines(*what.tags);
}

void write_ply(std::ostream& out, const written_mesh& what)
{
    static_assert(std::endian::native == std::endian::little, "numbers are written as they lie");
    const bool has_normals = not what.normals.empty();
    text_block header;
    header << "ply\nformat " << (what.binary ? "binary_little_endian" : "ascii")
           << " 1.0\ncomment written by kith\nelement vertex " << vertices_of(what)
           << "\nproperty double x\nproperty double y\nproperty double z\n"
           << (has_normals ? "property double nx\nproperty double ny\nproperty double nz\n" : "") << "element face "
           << what.mesh.face_count() << "\nproperty list uchar int vertex_indices\nend_header\n";
    out << header.text();
    write_blocks(out, vertices_of(what), [&](text_block& text, std::size_t v) {
        if (what.binary) {
            text.raw(point_of(what, v));
            if (has_normals)
                text.raw(normal_of(what, v));
            return;
        }
        text << point_of(what, v);
        if (has_normals)
            text << ' ' << normal_of(what, v);
        text << '\n';
    });
    write_blocks(out, what.mesh.face_count(), [&](text_block& text, std::size_t f) {
        const auto face = what.mesh.face(f);
        if (what.binary) {
            text.raw(std::uint8_t(face.size()));
            for (const auto v : face)
                text.raw(std::int32_t(v));
            return;
        }
        text << face.size();
        for (const auto v : face)
            text << ' ' << std::size_t(v);
        text << '\n';
    });
}

void write_stl(std::ostream& out, const written_mesh& what)
{
    const basic_mesh<>& mesh = what.mesh;
    const auto normal = [&](std::size_t f) {
        const auto face = mesh.face(f);
        return facet_normal(mesh.point(face[0]), mesh.point(face[1]), mesh.point(face[2]));
    };
    if (what.binary) {
        std::string header = "binary STL written by kith"; // not "solid", which begins a text
        header.resize(80, ' ');
        out << header;
        out << text_block().raw(std::uint32_t(mesh.face_count())).text();
        write_blocks(out, mesh.face_count(), [&](text_block& text, std::size_t f) {
            const auto add = [&](const point& p) {
                text.raw(std::array<float, 3>{float(p[0]), float(p[1]), float(p[2])});
            };
            add(normal(f));
            for (const auto v : mesh.face(f))
                add(mesh.point(v));
            text.raw(std::uint16_t(0));
        });
        return;
    }
    out << "solid kith\n";
    write_blocks(out, mesh.face_count(), [&](text_block& text, std::size_t f) {
        text << "facet normal " << normal(f) << "\nouter loop\n";
        for (const auto v : mesh.face(f))
            text << "vertex " << mesh.point(v) << '\n';
        text << "endloop\nendfacet\n";
    });
    out << "endsolid kith\n";
}

} // namespace

void require_writable(mesh_format format, const written_mesh& what)
{
    const basic_mesh<>& mesh = what.mesh;
    const bool in_floats = format == mesh_format::stl and what.binary;
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        if (not is_finite(mesh.point(v)))
            throw file_error("vertex " + std::to_string(v) +
                             " would have no finite place; the coordinates of the input are too large");
        if (in_floats and not fits_float(mesh.point(v)))
            throw file_error("vertex " + std::to_string(v) +
                             " is too far away for the floats of binary STL; write text, or .off, .obj or .ply");
    }
    if (format != mesh_format::stl)
        for (std::size_t v = 0; v < what.normals.size(); ++v)
            if (not is_finite(what.normals[v]))
                throw file_error("vertex " + std::to_string(v) +
                                 " would have no finite normal; the coordinates of the input are too large");
    const std::size_t most = format == mesh_format::stl   ? 3
                             : format == mesh_format::ply ? std::numeric_limits<std::uint8_t>::max()
                                                          : mesh.vertex_count();
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        if (mesh.face(f).size() > most)
            throw file_error("face " + std::to_string(f) + " has " + std::to_string(mesh.face(f).size()) +
                             " corners, this format holds " + std::to_string(most) + " at most; choose .off or .obj");
    constexpr std::size_t most_in_ply = std::numeric_limits<std::int32_t>::max();
    if (format == mesh_format::ply and vertices_of(what) > most_in_ply)
        throw file_error("the mesh has " + std::to_string(vertices_of(what)) +
                         " vertices, the 32-bit indices of a PLY file count " + std::to_string(most_in_ply) +
                         " at most; choose .off or .obj");
}

void write_mesh(std::ostream& out, mesh_format format, const written_mesh& what)
{
    switch (format) {
    case mesh_format::obj: write_obj(out, what); break;
    case mesh_format::ply: write_ply(out, what); break;
    case mesh_format::stl: write_stl(out, what); break;
    default: write_off(out, what);
    }
}

} // namespace kith::io
