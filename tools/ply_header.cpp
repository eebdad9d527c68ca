// SPDX-License-Identifier: BSD-3-Clause
#include "ply_header.hpp"

#include "text_scanner.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace kith::tool {

namespace {

ply_number number_type(const text_scanner& scan, std::string_view word)
{
    constexpr ply_number i8{1, false, true}, u8{1, false, false}, i16{2, false, true}, u16{2, false, false},
        i32{4, false, true}, u32{4, false, false}, f32{4, true, true}, f64{8, true, true};
    using namespace std::string_view_literals;
    static constexpr std::array<std::pair<std::string_view, ply_number>, 16> types{{{"char"sv, i8},
                                                                                    {"int8"sv, i8},
                                                                                    {"uchar"sv, u8},
                                                                                    {"uint8"sv, u8},
                                                                                    {"short"sv, i16},
                                                                                    {"int16"sv, i16},
                                                                                    {"ushort"sv, u16},
                                                                                    {"uint16"sv, u16},
                                                                                    {"int"sv, i32},
                                                                                    {"int32"sv, i32},
                                                                                    {"uint"sv, u32},
                                                                                    {"uint32"sv, u32},
                                                                                    {"float"sv, f32},
                                                                                    {"float32"sv, f32},
                                                                                    {"double"sv, f64},
                                                                                    {"float64"sv, f64}}};
    for (const auto& [name, type] : types)
        if (word == name)
            return type;
    scan.refuse("'" + text_scanner::shown(word) + "' is no type of a PLY file");
}

void read_format(text_scanner& scan, ply_header& header)
{
    const auto word = scan.word();
    if (word == "ascii")
        header.encoding = ply_encoding::text;
    else if (word == "binary_little_endian")
        header.encoding = ply_encoding::little_endian;
    else if (word == "binary_big_endian")
        header.encoding = ply_encoding::big_endian;
    else
        scan.refuse("'" + text_scanner::shown(word) + "' is no format of a PLY file");
    if (scan.word() != "1.0")
        scan.refuse("version 1.0 of the format is expected");
}

ply_property read_property(text_scanner& scan)
{
    ply_property result;
    auto word = scan.word();
    if (word == "list") {
        result.count = number_type(scan, scan.word());
        if (result.count.floating)
            scan.refuse("the length of a list must be a whole number");
        word = scan.word();
    }
    result.value = number_type(scan, word);
    result.name = scan.word();
    if (result.name.empty())
        scan.refuse("the property has no name");
    return result;
}

const ply_property* find(const ply_element& element, std::string_view name)
{
    const auto found = std::ranges::find(element.properties, name, &ply_property::name);
    return found == element.properties.end() ? nullptr : &*found;
}

void check_vertex_properties(const ply_element& element)
{
    for (const std::string_view name : {"x", "y", "z"}) {
        const ply_property* const p = find(element, name);
        if (p == nullptr or p->is_list() or not p->value.floating)
            throw file_error("the vertices have no property '" + std::string(name) + "' of type float or double");
    }
}

void check_face_properties(const ply_element& element)
{
    const ply_property* p = find(element, "vertex_indices");
    if (p == nullptr)
        p = find(element, "vertex_index");
    if (p == nullptr or not p->is_list() or p->value.floating or p->value.bytes != 4)
        throw file_error("the faces have no list 'vertex_indices' of type int or uint");
}

/// Readers want the line 'format ...' to be the second one.
void move_comments_behind_format(std::string& bytes, std::size_t second_line, std::size_t format_line, std::size_t end)
{
    std::rotate(bytes.begin() + std::ptrdiff_t(second_line),
                bytes.begin() + std::ptrdiff_t(format_line),
                bytes.begin() + std::ptrdiff_t(end));
}

} // namespace

ply_header read_ply_header(std::string& bytes)
{
    ply_header header;
    text_scanner scan(bytes);
    scan.advance();
    if (scan.word() != "ply" or not scan.word().empty())
        scan.refuse("a PLY file begins with a line 'ply'");
    const std::size_t second_line = scan.next_line();
    bool has_format = false;
    for (;;) {
        const std::size_t line_begin = scan.next_line();
        if (not scan.advance())
            throw file_error("the file ends where 'end_header' should be");
        const auto word = scan.word();
        if (word == "end_header")
            break;
        if (word == "format" and not has_format) {
            read_format(scan, header);
            has_format = true;
            move_comments_behind_format(bytes, second_line, line_begin, std::min(scan.next_line(), bytes.size()));
        } else if (word == "element") {
            ply_element element;
            element.name = scan.word();
            element.count = scan.whole<std::size_t>(scan.word(),
                                                    [&] { return "the number of elements '" + element.name + "'"; });
            header.elements.push_back(std::move(element));
        } else if (word == "property") {
            if (header.elements.empty())
                scan.refuse("the property belongs to no element");
            header.elements.back().properties.push_back(read_property(scan));
        } else if (word != "comment" and word != "obj_info") {
            scan.refuse("'" + text_scanner::shown(word) + "' is no line of a PLY header");
        }
    }
    if (not has_format)
        throw file_error("the header has no line 'format'");
    header.data_begin = std::min(scan.next_line(), bytes.size());
    header.data_line = scan.line() + 1;

    std::size_t vertex_elements = 0, face_elements = 0;
    for (const auto& element : header.elements) {
        if (element.properties.empty() and element.count != 0)
            throw file_error("the elements '" + element.name + "' have no property");
        if (element.name == "halfedge")
            throw file_error("a file with half-edges is not read; save its faces as lists of vertices");
        if (element.is_vertex()) {
            check_vertex_properties(element);
            header.vertices = element.count;
            ++vertex_elements;
        } else if (element.is_face()) {
            check_face_properties(element);
            header.faces = element.count;
            ++face_elements;
        }
    }
    if (vertex_elements != 1 or face_elements != 1)
        throw file_error("the file must have one element 'vertex' and one element 'face'");
    return header;
}

} // namespace kith::tool
