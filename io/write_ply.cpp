// SPDX-License-Identifier: BSD-3-Clause
#include "written_parts.hpp"

#include <kith/io/text/file_error.hpp>
#include <kith/read_mesh.hpp>
#include <kith/tiles/output/ply_words.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace kith::io {

namespace {

std::string_view name_of(const ply_number& type)
{
    if (type.floating)
        return type.bytes == 4 ? "float" : "double";
    if (type.bytes == 4)
        return type.is_signed ? "int" : "uint";
    if (type.bytes == 2)
        return type.is_signed ? "short" : "ushort";
    return type.is_signed ? "char" : "uchar";
}

std::string properties_of(const attribute_list& attributes)
{
    std::string result;
    for (const attribute* a : attributes)
        result += "property " + std::string(name_of(a->type)) + " " + ply_name(a->name) + "\n";
    return result;
}

void write_number(text_block& text, bool binary, const ply_number& type, double value)
{
    with_type(type, value, [&](auto number) {
        if (binary)
            text.raw(number);
        else
            text << ' ' << number;
    });
}
/// The attributes under their names, and which of them are 0 where an element lacks them.
struct ply_columns {
    explicit ply_columns(const attribute_list& held) : attributes(held)
    {
        for (const attribute* a : held)
            is_zero_without_value.push_back(kith::io::is_zero_without_value(*a));
    }
    void write(text_block& text, bool binary, std::size_t element) const
    {
        for (std::size_t i = 0; i < attributes.size(); ++i) {
            const double value = attributes[i]->values[element];
            write_number(text, binary, attributes[i]->type, std::isnan(value) and is_zero_without_value[i] ? 0 : value);
        }
    }

    attribute_list attributes;
    std::vector<bool> is_zero_without_value;
};

/// Returns the type of a list: the type of its numbers, or double if they have several types.
ply_number type_of_list(const attribute_list& list)
{
    const bool are_of_one = std::ranges::all_of(
        list, [&](const attribute* a) { return name_of(a->type) == name_of(list[0]->type); });
    return are_of_one ? list[0]->type : ply_number{8, true, true};
}

/// Writes the length of a list.
void write_length(text_block& text, bool binary, const ply_count& type, std::size_t entries)
{
    if (not binary)
        text << entries;
    else if (type.bytes == 1)
        text.raw(std::uint8_t(entries));
    else if (type.bytes == 2)
        text.raw(std::uint16_t(entries));
    else
        text.raw(std::uint32_t(entries));
}

/// The degrees of the faces, and the types in which a file counts the entries of their lists.
struct list_lengths {
    std::size_t largest_degree = 0;
    ply_count corners, textures, normals;

    explicit list_lengths(const basic_mesh<>& mesh)
    {
        for (std::size_t f = 0; f < mesh.face_count(); ++f)
            largest_degree = std::max<std::size_t>(largest_degree, mesh.face(f).size());
        corners = ply_count::of(largest_degree);
        textures = ply_count::of(2 * largest_degree);
        normals = ply_count::of(3 * largest_degree);
    }
};

/// Writes the texture coordinates of the corners of a face, two each, or an empty list where one is missing.
void write_texture(text_block& text, bool binary, const ply_count& count, const attribute_list& uv, std::size_t first,
                   std::size_t degree)
{
    bool is_there = true;
    for (std::size_t c = first; c < first + degree; ++c)
        is_there &= has_all(uv, c);
    if (not binary)
        text << ' ';
    write_length(text, binary, count, is_there ? 2 * degree : 0);
    const ply_number type = type_of_list(uv);
    for (std::size_t c = first; is_there and c < first + degree; ++c)
        for (const attribute* a : uv)
            write_number(text, binary, type, a->values[c]);
}

/// Writes the normals of the corners of a face, as a list of three numbers each.
void write_corner_normals(text_block& text, bool binary, const ply_count& count,
                          std::span<const std::array<double, 3>> normals)
{
    if (not binary)
        text << ' ';
    write_length(text, binary, count, 3 * normals.size());
    for (const auto& n : normals)
        if (binary)
            text.raw(n);
        else
            text << ' ' << n;
}

ply_contents contents_of(const written_mesh& what, const held_attributes& held, const list_lengths& lengths)
{
    ply_contents result{vertices_of(what), what.mesh.face_count(), not what.normals.empty(), lengths.largest_degree};
    if (what.attributes != nullptr)
        result.comments = ply_file_lines(what.attributes->file_lines);
    for (const attribute* a : held.faces)
        result.comments += ply_word_lines(a->name, a->labels);
    result.vertex_properties = properties_of(held.vertices);
    if (not held.corner_textures.empty())
        result.face_properties = "property list " + std::string(lengths.textures.word) + " " +
                                 std::string(name_of(type_of_list(held.corner_textures))) + " texcoord\n";
    if (not what.corner_normals.empty())
        result.face_properties += ply_corner_normals(lengths.normals);
    result.face_properties += properties_of(held.faces);
    return result;
}

void write_ply(std::ostream& out, const written_mesh& what)
{
    static_assert(std::endian::native == std::endian::little, "numbers are written as they lie");
    const bool has_normals = not what.normals.empty();
    const held_attributes held = held_by(mesh_format::ply, what);
    const ply_columns of_vertices(held.vertices), of_faces(held.faces);
    const list_lengths lengths(what.mesh);
    out << ply_head(what.binary, contents_of(what, held, lengths));
    write_blocks(out, vertices_of(what), [&](text_block& text, std::size_t v) {
        if (what.binary) {
            text.raw(point_of(what, v));
            if (has_normals)
                text.raw(normal_of(what, v));
        } else {
            text << point_of(what, v);
            if (has_normals)
                text << ' ' << normal_of(what, v);
        }
        of_vertices.write(text, what.binary, v);
        if (not what.binary)
            text << '\n';
    });
    write_blocks(out, what.mesh.face_count(), [&](text_block& text, std::size_t f) {
        const auto face = what.mesh.face(f);
        write_length(text, what.binary, lengths.corners, face.size());
        for (const auto v : face)
            if (what.binary)
                text.raw(std::int32_t(v));
            else
                text << ' ' << std::size_t(v);
        if (not held.corner_textures.empty())
            write_texture(text,
                          what.binary,
                          lengths.textures,
                          held.corner_textures,
                          what.mesh.topology().first_corner(f),
                          face.size());
        if (not what.corner_normals.empty())
            write_corner_normals(text,
                                 what.binary,
                                 lengths.normals,
                                 what.corner_normals.subspan(what.mesh.topology().first_corner(f), face.size()));
        of_faces.write(text, what.binary, f);
        if (not what.binary)
            text << '\n';
    });
}

void require_for_ply(const written_mesh& what)
{
    require_finite_normals(what);
    require_finite_corner_normals(what);
    constexpr std::size_t most_vertices = std::numeric_limits<std::int32_t>::max();
    if (vertices_of(what) > most_vertices)
        throw file_error("the mesh has " + std::to_string(vertices_of(what)) +
                         " vertices, the 32-bit indices of a PLY file count " + std::to_string(most_vertices) +
                         " at most; choose .off or .obj");
}

held_attributes held_by_ply(const mesh_attributes& all, bool)
{
    const auto is_any = [](const attribute&) { return true; };
    held_attributes result;
    result.vertices = held_if(all.vertices, is_any);
    result.faces = held_if(all.faces, is_any);
    result.corner_textures = held_list(all.corners, texture_names, 2, 2);
    return result;
}

element_attributes zeros_in_ply(const mesh_attributes& all, const held_attributes&)
{
    const auto is_zero = [](const attribute& a) { return not a.type.floating or is_zero_without_value(a); };
    return {held_if(all.vertices, is_zero), held_if(all.faces, is_zero)};
}

} // namespace

extern const file_format ply_format{.format = mesh_format::ply,
                                    .extension = ".ply",
                                    .contents = {.corner_normals = true, .binary = true},
                                    .read = read_ply,
                                    .write = write_ply,
                                    .require = require_for_ply,
                                    .held = held_by_ply,
                                    .holds_line = [](std::string_view) { return true; },
                                    .zeros = zeros_in_ply};

} // namespace kith::io
