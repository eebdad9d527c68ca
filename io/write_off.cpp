// SPDX-License-Identifier: BSD-3-Clause
#include "written_parts.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <ostream>
#include <string_view>

namespace kith::io {

namespace {

/// Red, green, blue and what is opaque: as bytes where they were bytes, else from 0 to 1, with a point that tells them
/// from bytes. Nothing for an element without a color.
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

} // namespace

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

} // namespace kith::io
