// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ply_number.hpp"

#include <kith/core/base/error.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace kith {

/// A property of the elements of one kind: a number or a list of numbers.
struct ply_property {
    std::string name;
    ply_number value;
    ply_number count; ///< of a list; bytes == 0 if the property is no list

    [[nodiscard]] bool is_list() const { return count.bytes != 0; }
    /// Returns the bytes of the property in one element, or of an empty list if it is a list.
    [[nodiscard]] std::size_t least_bytes() const { return is_list() ? count.bytes : value.bytes; }
};

/// A kind of elements, as the header declares it: the number of elements, and their properties.
struct ply_element {
    std::string name;
    std::uint64_t count = 0;
    std::vector<ply_property> properties;

    [[nodiscard]] bool is_vertex() const { return name == "vertex" or name == "vertices"; }
    [[nodiscard]] bool is_face() const { return name == "face" or name == "faces"; }
    /// Returns true for strips of triangles, as in the Stanford models: lists of vertices in which -1 ends a strip.
    [[nodiscard]] bool is_strips() const { return name == "tristrips"; }
    [[nodiscard]] bool has_lists() const { return std::ranges::any_of(properties, &ply_property::is_list); }
    /// Returns the bytes of one element with empty lists in a binary file.
    [[nodiscard]] std::size_t least_bytes() const
    {
        std::size_t result = 0;
        for (const auto& property : properties)
            result += property.least_bytes();
        return result;
    }
    /// Returns the index of the list of the vertices of a face or of strips. Errors: mesh_error if there is none.
    [[nodiscard]] std::size_t corner_list() const
    {
        for (const std::string_view name : {"vertex_indices", "vertex_index"})
            if (const std::size_t p = find(name);
                p != properties.size() and properties[p].is_list() and not properties[p].value.floating)
                return p;
        throw mesh_error(std::string(is_strips() ? "the strips" : "the faces") +
                         " have no list 'vertex_indices' of whole numbers");
    }
    /// Returns the indices of the properties x, y and z of vertices. Errors: mesh_error if one is missing.
    [[nodiscard]] std::array<std::size_t, 3> place() const
    {
        std::array<std::size_t, 3> result{};
        for (std::size_t i = 0; i < 3; ++i) {
            const std::string name(1, "xyz"[i]);
            result[i] = find(name);
            if (result[i] == properties.size() or properties[result[i]].is_list())
                throw mesh_error("the vertices have no property '" + name + "' that is a number");
        }
        return result;
    }

private:
    [[nodiscard]] std::size_t find(std::string_view name_of_property) const
    {
        return std::size_t(std::ranges::find(properties, name_of_property, &ply_property::name) - properties.begin());
    }
};

/// The encoding of the numbers after the header.
enum class ply_encoding : unsigned char { text, little_endian, big_endian };

/// The header of a PLY file of a mesh.
struct ply_header {
    ply_encoding encoding = ply_encoding::text;
    /// The declared elements. One has vertices with coordinates; one has faces with their corners, one has strips, or
    /// both exist.
    std::vector<ply_element> elements;
    std::uint64_t vertices = 0;
    std::uint64_t faces = 0;
    std::vector<std::string> comments;
    std::size_t data_begin = 0; ///< the first byte after the header
    std::size_t data_line = 0;  ///< the line of that byte, counted from 1
};

namespace detail {

/// A reader of a header, line by line. Errors in a line name it.
class ply_header_reader {
public:
    explicit ply_header_reader(std::string_view bytes) : bytes_(bytes)
    {
        const std::size_t end = bytes.find_first_of("\r\n");
        if (end != bytes.npos and bytes[end] == '\r' and not bytes.substr(end + 1).starts_with('\n'))
            line_end_ = '\r'; // data may begin with '\n', so only the first line is looked at
    }

    ply_header read()
    {
        if (not next_line() or word() != "ply" or not word().empty())
            refuse("a PLY file begins with a line 'ply'");
        while (true) {
            if (not next_line())
                throw mesh_error("the file ends where 'end_header' should be");
            const auto statement = word();
            if (statement == "end_header")
                break;
            read_line(statement);
        }
        if (not has_format_)
            throw mesh_error("the header has no line 'format'");
        header_.data_begin = next_;
        header_.data_line = line_ + 1;
        check_elements();
        return std::move(header_);
    }

private:
    [[noreturn]] void refuse(const std::string& what) const
    {
        throw mesh_error("line " + std::to_string(line_) + ": " + what);
    }
    static std::string quoted(std::string_view word)
    {
        std::string result(word.substr(0, 40));
        std::ranges::replace_if(result, [](char c) { return c < ' ' or c > '~'; }, '?');
        return "'" + result + (word.size() > 40 ? "...'" : "'");
    }
    bool next_line()
    {
        ++line_;
        if (next_ >= bytes_.size())
            return false;
        const std::size_t end = std::min(bytes_.find(line_end_, next_), bytes_.size());
        rest_ = bytes_.substr(next_, end - next_);
        next_ = std::min(end + 1, bytes_.size());
        return true;
    }
    std::string_view word()
    {
        constexpr std::string_view blanks = " \t\r\v\f";
        rest_.remove_prefix(std::min(rest_.find_first_not_of(blanks), rest_.size()));
        const auto result = rest_.substr(0, rest_.find_first_of(blanks));
        rest_.remove_prefix(result.size());
        return result;
    }
    void read_line(std::string_view statement)
    {
        if (statement == "format" and not has_format_) {
            read_format();
        } else if (statement == "element") {
            ply_element element;
            element.name = word();
            const auto number = word();
            const auto [rest, error] = std::from_chars(number.data(), number.data() + number.size(), element.count);
            if (error != std::errc() or rest != number.data() + number.size())
                refuse("the number of elements " + quoted(element.name) + " should be a whole number, it is " +
                       quoted(number));
            header_.elements.push_back(std::move(element));
        } else if (statement == "property") {
            if (header_.elements.empty())
                refuse("the property belongs to no element");
            header_.elements.back().properties.push_back(read_property());
        } else if (statement == "comment") {
            rest_.remove_prefix(std::min<std::size_t>(1, rest_.size()));
            header_.comments.emplace_back(rest_.substr(0, rest_.find_last_not_of('\r') + 1));
        } else if (statement != "obj_info") {
            refuse(quoted(statement) + " is no line of a PLY header");
        }
    }
    void read_format()
    {
        has_format_ = true;
        const auto name = word();
        if (name == "ascii")
            header_.encoding = ply_encoding::text;
        else if (name == "binary_little_endian")
            header_.encoding = ply_encoding::little_endian;
        else if (name == "binary_big_endian")
            header_.encoding = ply_encoding::big_endian;
        else
            refuse(quoted(name) + " is no format of a PLY file");
        if (word() != "1.0")
            refuse("version 1.0 of the format is expected");
    }
    ply_property read_property()
    {
        ply_property result;
        auto type = word();
        if (type == "list") {
            result.count = number_type(word());
            if (result.count.floating)
                refuse("the length of a list must be a whole number");
            type = word();
        }
        result.value = number_type(type);
        result.name = word();
        if (result.name.empty())
            refuse("the property has no name");
        return result;
    }
    [[nodiscard]] ply_number number_type(std::string_view word) const
    {
        constexpr ply_number i8{1, false, true}, u8{1, false, false}, i16{2, false, true}, u16{2, false, false},
            i32{4, false, true}, u32{4, false, false}, f32{4, true, true}, f64{8, true, true};
        constexpr std::array<std::pair<std::string_view, ply_number>, 16> types{{{"char", i8},
                                                                                 {"int8", i8},
                                                                                 {"uchar", u8},
                                                                                 {"uint8", u8},
                                                                                 {"short", i16},
                                                                                 {"int16", i16},
                                                                                 {"ushort", u16},
                                                                                 {"uint16", u16},
                                                                                 {"int", i32},
                                                                                 {"int32", i32},
                                                                                 {"uint", u32},
                                                                                 {"uint32", u32},
                                                                                 {"float", f32},
                                                                                 {"float32", f32},
                                                                                 {"double", f64},
                                                                                 {"float64", f64}}};
        for (const auto& [name, type] : types)
            if (word == name)
                return type;
        refuse(quoted(word) + " is no type of a PLY file");
    }
    void check_elements()
    {
        std::size_t vertex_elements = 0, face_elements = 0, strip_elements = 0;
        for (const auto& element : header_.elements) {
            if (element.properties.empty() and element.count != 0)
                throw mesh_error("the elements " + quoted(element.name) + " have no property");
            if (element.name == "halfedge")
                throw mesh_error("a file with half-edges is not read; save its faces as lists of vertices");
            if (element.is_vertex()) {
                header_.vertices = element.count;
                ++vertex_elements;
            } else if (element.is_face()) {
                header_.faces = element.count;
                ++face_elements;
            } else if (element.is_strips()) {
                ++strip_elements;
            }
        }
        if (vertex_elements != 1 or face_elements > 1 or strip_elements > 1 or face_elements + strip_elements == 0)
            throw mesh_error("the file must have one element 'vertex' and one element 'face' or 'tristrips'");
        for (const auto& element : header_.elements)
            if (element.is_vertex())
                (void)element.place();
            else if (element.is_face() or element.is_strips())
                (void)element.corner_list();
    }

    std::string_view bytes_;
    std::string_view rest_; ///< the unread part of the line
    char line_end_ = '\n';
    std::size_t next_ = 0; ///< the first byte of the next line
    std::size_t line_ = 0;
    bool has_format_ = false;
    ply_header header_;
};

} // namespace detail

/// Returns true if the first bytes of a file contain the whole line that ends the header. The search begins at byte
/// `from`.
inline bool holds_end_of_header(std::string_view bytes, std::size_t from)
{
    constexpr std::string_view word = "end_header";
    for (std::size_t at = bytes.find(word, from); at != bytes.npos; at = bytes.find(word, at + 1)) {
        const std::size_t before = bytes.substr(0, at).find_last_not_of(" \t\v\f"); // comments may have the word, too
        if (before != bytes.npos and (bytes[before] == '\n' or bytes[before] == '\r'))
            return at + word.size() + 6 < bytes.size();
    }
    return false;
}

/// Reads the header of a PLY file, whose first bytes are `bytes`. Lines end with LF, CR or CRLF; comments may stand
/// anywhere.
/// Errors: mesh_error, with the line if one is wrong; for bytes that are no header; for files without vertices with
/// coordinates; and for files without faces or strips that are lists of vertices. Cost: that of the header.
inline ply_header read_ply_header(std::string_view bytes)
{
    return detail::ply_header_reader(bytes).read();
}

} // namespace kith
