// SPDX-License-Identifier: BSD-3-Clause
#include "read_vtu.hpp"
#include "written_parts.hpp"

#include <kith/io/text/file_error.hpp>
#include <kith/read_mesh.hpp>
#include <kith/tiles/output/vtu_arrays.hpp>
#include <kith/tiles/output/vtu_layout.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace kith::io {

namespace {

std::string vtk_name_of(const ply_number& type)
{
    return (type.floating ? "Float" : type.is_signed ? "Int" : "UInt") + std::to_string(8 * type.bytes);
}

/// An array of a file of VTK: attributes side by side.
struct vtp_array {
    std::string name;
    attribute_list columns;
    ply_number type{8, true, true};

    vtp_array(std::string name_here, attribute_list list) : name(std::move(name_here)), columns(std::move(list))
    {
        const auto is_first = [&](const attribute* a) { return vtk_name_of(a->type) == vtk_name_of(columns[0]->type); };
        if (std::ranges::all_of(columns, is_first))
            type = columns[0]->type;
    }
};

/// The arrays of the elements of one kind, and which of them have a role that VTK knows.
struct vtp_arrays {
    std::vector<vtp_array> list;
    std::string roles;

    vtp_arrays(const std::vector<attribute>& all, bool has_normals, bool has_textures)
    {
        const attribute_list normals = has_normals ? attribute_list() : held_list(all, normal_names, 3, 3);
        const attribute_list textures = has_textures ? held_list(all, texture_names, 2, 3) : attribute_list();
        const attribute_list colors = held_list(all, color_names, 3, 4);
        add("Normals", normals, " Normals=\"Normals\"");
        add("TCoords", textures, " TCoords=\"TCoords\"");
        add(colors.size() == 4 ? "RGBA" : "RGB", colors, "");
        const auto is_in = [](const attribute_list& group, const attribute& a) {
            return std::ranges::find(group, &a) != group.end();
        };
        for (const attribute& a : all)
            if (not is_in(normals, a) and not is_in(textures, a) and not is_in(colors, a) and
                not(has_normals and topic_of(a.name, "") == "normals"))
                list.emplace_back(a.name, attribute_list{&a});
    }

private:
    void add(const std::string& name, const attribute_list& columns, const std::string& role)
    {
        if (columns.empty())
            return;
        list.emplace_back(name, columns);
        roles += role;
    }
};

/// A writer of VTK's PolyData: the head says where each array begins, then the arrays follow as they lie in memory.
class vtp_writer {
public:
    vtp_writer(std::ostream& out, const written_mesh& what) : out_(out), what_(what) {}

    void write()
    {
        const mesh_attributes none;
        const mesh_attributes& all = what_.attributes == nullptr ? none : *what_.attributes;
        const vtp_arrays of_vertices(all.vertices, not what_.normals.empty(), true), of_faces(all.faces, false, false);
        const std::size_t vertices = vertices_of(what_), faces = what_.mesh.face_count();

        layout_.open("PointData" + of_vertices.roles + (what_.normals.empty() ? "" : " Normals=\"Normals\""));
        if (not what_.normals.empty())
            add("type=\"Float64\" Name=\"Normals\" NumberOfComponents=\"3\"", vertices, 24, [&](auto& bytes, auto v) {
                bytes.raw(normal_of(what_, v));
            });
        add_all(of_vertices, vertices);
        layout_.close("PointData").open("CellData");
        add_all(of_faces, faces);
        layout_.close("CellData").open("Points");
        add("type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"", vertices, 24, [&](auto& bytes, auto v) {
            bytes.raw(point_of(what_, v));
        });
        layout_.close("Points").open("Polys");
        const auto& topology = what_.mesh.topology();
        add("type=\"Int64\" Name=\"connectivity\"", what_.mesh.corner_count(), 8, [&](auto& bytes, auto corner) {
            bytes.raw(std::int64_t(topology.corner_vertex[corner]));
        });
        add("type=\"Int64\" Name=\"offsets\"", faces, 8, [&](auto& bytes, auto face) {
            bytes.raw(std::int64_t(topology.first_corner(face) + what_.mesh.face(face).size()));
        });
        layout_.close("Polys").finish(vertices, faces, "PolyData", "NumberOfPolys");

        out_ << layout_.head();
        for (const auto& write_array : arrays_)
            write_array();
        out_ << vtu_layout::tail;
    }

private:
    /// Declares an array of `entries` entries of `bytes_of_entry` bytes. write(bytes, entry) writes each of them.
    template <class Write>
    void add(const std::string& attributes, std::size_t entries, std::size_t bytes_of_entry, const Write& write)
    {
        const std::uint64_t size = entries * bytes_of_entry;
        layout_.add(size, attributes);
        arrays_.push_back([this, size, entries, write] {
            out_ << text_block().raw(size).text();
            write_blocks(out_, entries, write);
        });
    }
    void add_all(const vtp_arrays& arrays, std::size_t elements)
    {
        for (const vtp_array& array : arrays.list) {
            const std::string name = kith::detail::xml_text(array.name);
            const std::size_t columns = array.columns.size();
            add("type=\"" + vtk_name_of(array.type) + "\" Name=\"" + name + "\"" +
                    (columns == 1 ? "" : " NumberOfComponents=\"" + std::to_string(columns) + "\""),
                elements,
                columns * array.type.bytes,
                [&array](text_block& bytes, std::size_t element) {
                    for (const attribute* a : array.columns)
                        with_type(array.type, a->values[element], [&](auto number) { bytes.raw(number); });
                });
            if (const auto& words = array.columns[0]->labels; not words.empty())
                layout_.add_words(name, words);
        }
    }

    std::ostream& out_;
    const written_mesh& what_;
    vtu_layout layout_;
    std::vector<std::function<void()>> arrays_;
};

void write_vtp(std::ostream& out, const written_mesh& what)
{
    vtp_writer(out, what).write();
}

held_attributes held_by_vtp(const mesh_attributes& all, bool)
{
    const auto is_any = [](const attribute&) { return true; };
    held_attributes result;
    result.vertices = held_if(all.vertices, is_any);
    result.faces = held_if(all.faces, is_any);
    return result;
}

} // namespace

extern const file_format vtp_format{.format = mesh_format::vtp,
                                    .extension = ".vtp",
                                    .index = ".pvtp",
                                    .read = read_vtu,
                                    .read_in_folder = read_vtu,
                                    .write = write_vtp,
                                    .require = require_finite_normals,
                                    .held = held_by_vtp,
                                    .zeros = whole_numbers};

} // namespace kith::io
