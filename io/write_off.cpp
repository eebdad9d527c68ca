// SPDX-License-Identifier: BSD-3-Clause
#include "written_parts.hpp"

#include <kith/read_mesh.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <ostream>
#include <string_view>

namespace kith::io {

namespace {

/// Writes red, green, blue and opacity. They are bytes if they were bytes, else numbers from 0 to 1, with a point that
/// distinguishes them from bytes. Writes nothing for an element without a color.
void write_color(text_block& text, const attribute_list& color, std::size_t element)
{
    if (not has_all(color, element))
        return;
    const bool in_bytes = std::ranges::all_of(
        color, [](const auto* a) { return not a->type.floating and a->type.bytes == 1; });
    text << ' ';
    for (std::size_t i = 0; i < 4; ++i) {
        if (in_bytes) {
            text << ' ' << (i < color.size() ? int(color[i]->values[element]) : 255);
            continue;
        }
        const double x = i < color.size() ? unit_color(*color[i], element) : 1;
        text << ' ' << x << (x == std::floor(x) and std::abs(x) < 1e5 ? ".0" : "");
    }
}

void write_numbers(text_block& text, const attribute_list& numbers, std::size_t element)
{
    for (const attribute* a : numbers)
        text << ' ' << (std::isnan(a->values[element]) ? 0 : a->values[element]);
}

void write_off(std::ostream& out, const written_mesh& what)
{
    const bool has_normals = not what.normals.empty();
    const held_attributes held = held_by(mesh_format::off, what);
    text_block header;
    header << (held.textures.empty() ? "" : "ST") << (held.colors.empty() ? "" : "C")
           << (has_normals or not held.normals.empty() ? "N" : "") << "OFF\n"
           << vertices_of(what) << ' ' << what.mesh.face_count() << " 0\n\n";
    out << header.text();
    write_blocks(out, vertices_of(what), [&](text_block& text, std::size_t v) {
        text << point_of(what, v);
        if (has_normals)
            text << "  " << normal_of(what, v);
        write_numbers(text, held.normals, v);
        write_color(text, held.colors, v);
        write_numbers(text, held.textures, v);
        text << '\n';
    });
    write_blocks(out, what.mesh.face_count(), [&](text_block& text, std::size_t f) {
        const auto face = what.mesh.face(f);
        text << face.size() << ' ';
        for (const auto v : face)
            text << ' ' << std::size_t(v);
        write_color(text, held.face_colors, f);
        text << '\n';
    });
    out << '\n';
}

void require_for_off(const written_mesh& what)
{
    require_finite_normals(what);
    require_finite_values(mesh_format::off, what);
}

held_attributes held_by_off(const mesh_attributes& all, bool)
{
    held_attributes result;
    result.colors = held_list(all.vertices, color_names, 3, 4);
    result.normals = held_list(all.vertices, normal_names, 3, 3);
    result.textures = held_list(all.vertices, texture_names, 2, 2);
    result.face_colors = held_list(all.faces, color_names, 3, 4);
    return result;
}

element_attributes zeros_in_off(const mesh_attributes&, const held_attributes& held)
{
    attribute_list vertices = held.normals;
    vertices.insert(vertices.end(), held.textures.begin(), held.textures.end());
    return {vertices, {}};
}

} // namespace

extern const file_format off_format{.format = mesh_format::off,
                                    .extension = ".off",
                                    .read = read_off,
                                    .write = write_off,
                                    .require = require_for_off,
                                    .held = held_by_off,
                                    .zeros = zeros_in_off};

} // namespace kith::io
