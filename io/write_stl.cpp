// SPDX-License-Identifier: BSD-3-Clause
#include "stl_shades.hpp"
#include "written_parts.hpp"

#include <kith/io/format/facet_normal.hpp>
#include <kith/io/text/file_error.hpp>
#include <kith/io/text/text_writer.hpp>
#include <kith/merge_points.hpp>
#include <kith/read_mesh.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace kith::io {

namespace {

using float_point = std::array<float, 3>;

/// Rounds a place to floats, as binary STL has them. Turns -0 into 0, so that equal points have equal bits.
float_point rounded(const std::array<double, 3>& p)
{
    return {float(p[0]) + 0, float(p[1]) + 0, float(p[2]) + 0};
}

/// Returns true if two corners of a triangle are equal once they are rounded.
bool is_fallen(const basic_mesh<>& mesh, std::size_t face)
{
    const auto corners = mesh.face(face);
    const float_point p = rounded(mesh.point(corners[0])), q = rounded(mesh.point(corners[1])),
                      r = rounded(mesh.point(corners[2]));
    return p == q or q == r or r == p;
}

/// Returns true if some vertices are equal once they are rounded. Cost: O(V log V), 8 bytes per vertex.
bool some_vertices_fall_together(const basic_mesh<>& mesh)
{
    std::vector<std::uint64_t> hashes(mesh.vertex_count());
    for (std::size_t v = 0; v < hashes.size(); ++v)
        for (const float x : rounded(mesh.point(v))) {
            hashes[v] = (hashes[v] ^ std::bit_cast<std::uint32_t>(x)) * 0x9e3779b97f4a7c15;
            hashes[v] ^= hashes[v] >> 32;
        }
    std::ranges::sort(hashes);
    return std::ranges::adjacent_find(hashes) != hashes.end();
}

std::size_t different_points(const basic_mesh<>& mesh)
{
    merged_points points(mesh.vertex_count());
    for (const auto& p : mesh.points())
        points.add(p);
    return points.triangles().points.size();
}

/// Returns the bits of a colour as VisCAM and SolidView read them: 1 and five each of red, green and blue; 0 for none.
std::uint16_t color_bits(const attribute_list& color, std::size_t face)
{
    if (not has_all(color, face))
        return 0;
    std::uint16_t result = 1;
    for (const attribute* channel : color)
        result = std::uint16_t(result << 5 | stl_shade(unit_color(*channel, face)));
    return result;
}

/// Returns true if some face is not opaque.
bool has_transparency(const attribute& alpha)
{
    const double opaque = color_unit(alpha.type);
    return std::ranges::any_of(alpha.values, [&](double x) { return not std::isnan(x) and x != opaque; });
}
/// Returns true if some value is none of the 32 shades of binary STL.
bool has_more_shades(const attribute* channel)
{
    constexpr double rounding = 1e-9;
    return std::ranges::any_of(channel->values, [&](double x) {
        const double unit = x / color_unit(channel->type);
        return not std::isnan(x) and not(std::abs(byte_of_stl_shade(stl_shade(unit)) - 255 * unit) < rounding);
    });
}

} // namespace

std::size_t fallen_faces(const written_mesh& what)
{
    std::size_t result = 0;
    for (std::size_t f = 0; f < what.mesh.face_count(); ++f)
        result += is_fallen(what.mesh, f);
    return result;
}

namespace {

/// Throws file_error, for binary STL, if vertices are equal as floats and the remaining triangles are not a surface.
/// Cost: O(V log V); if vertices are equal, that of reading the file.
void require_readable_floats(const written_mesh& what)
{
    const basic_mesh<>& mesh = what.mesh;
    if (not some_vertices_fall_together(mesh))
        return;
    merged_points points(3 * mesh.face_count());
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        for (const auto v : mesh.face(f))
            if (const float_point p = rounded(mesh.point(v)); not is_fallen(mesh, f))
                points.add({p[0], p[1], p[2]});
    const polygon_soup soup = points.triangles();
    const std::size_t fallen = mesh.face_count() - soup.faces.size();
    if (fallen == 0 and soup.points.size() == different_points(mesh))
        return; // points that are equal as floats are equal as doubles, too
    if (const mesh_report report = validate(soup.points, soup.faces); not report.ok())
        throw file_error(std::to_string(fallen) + " of " + std::to_string(mesh.face_count()) +
                         " triangles collapse in the floats of binary STL, and the others form no surface that "
                         "can be read; write text, .off, .obj or .ply, or move the mesh to the origin");
}

void write_stl(std::ostream& out, const written_mesh& what)
{
    const basic_mesh<>& mesh = what.mesh;
    const auto normal = [&](std::size_t f) {
        const auto face = mesh.face(f);
        return facet_normal(mesh.point(face[0]), mesh.point(face[1]), mesh.point(face[2]));
    };
    if (what.binary) {
        const attribute_list colors = held_by(mesh_format::stl, what).face_colors;
        std::string header = "binary STL written by kith"; // not "solid", which begins a text
        header.resize(80, ' ');
        out << header;
        out << text_block().raw(std::uint32_t(mesh.face_count() - fallen_faces(what))).text();
        write_blocks(out, mesh.face_count(), [&](text_block& text, std::size_t f) {
            if (is_fallen(mesh, f))
                return;
            const auto add = [&](const std::array<double, 3>& p) {
                text.raw(float_point{float(p[0]), float(p[1]), float(p[2])});
            };
            add(normal(f));
            for (const auto v : mesh.face(f))
                add(mesh.point(v));
            text.raw(color_bits(colors, f));
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

void require_for_stl(const written_mesh& what)
{
    if (what.binary)
        require_float_points(what, "binary STL; write text, or .off, .obj or .ply");
    for (std::size_t f = 0; f < what.mesh.face_count(); ++f)
        if (what.mesh.face(f).size() > 3)
            throw file_error("face " + std::to_string(f) + " has " + std::to_string(what.mesh.face(f).size()) +
                             " corners, this format holds 3 at most; choose .off, .obj or .ply");
    if (what.binary)
        require_readable_floats(what);
}

held_attributes held_by_stl(const mesh_attributes& all, bool binary)
{
    held_attributes result;
    if (binary)
        result.face_colors = held_list(all.faces, color_names, 3, 3);
    return result;
}

std::vector<std::string> rounded_by_stl(const mesh_attributes& all, const held_attributes& held,
                                        mesh_attributes& not_held)
{
    std::vector<std::string> result;
    if (held.face_colors.empty())
        return result;
    const bool has_alpha = std::erase_if(not_held.faces,
                                         [](const attribute& a) { return shared_name(a.name) == "alpha"; }) != 0;
    if (has_alpha and has_transparency(*find(all.faces, "alpha")))
        result.emplace_back("the transparency of faces");
    if (std::ranges::any_of(held.face_colors, has_more_shades))
        result.emplace_back("colours of faces beyond 32 shades of red, green and blue");
    return result;
}

} // namespace

extern const file_format stl_format{.format = mesh_format::stl,
                                    .extension = ".stl",
                                    .contents = {.normals = false, .isolated_points = false, .binary = true},
                                    .read = read_stl,
                                    .write = write_stl,
                                    .require = require_for_stl,
                                    .held = held_by_stl,
                                    .rounds = rounded_by_stl};

} // namespace kith::io
