// SPDX-License-Identifier: BSD-3-Clause
#include "triangle_strip.hpp"

#include <kith/io/format/ply_attributes.hpp>
#include <kith/io/text/text_cursor.hpp>
#include <kith/read_mesh.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kith::io {

namespace {

/// The numbers of a text file, one after the other wherever its lines end.
class text_numbers {
public:
    text_numbers(std::string_view bytes, const ply_header& header)
        : text_(bytes.substr(header.data_begin), header.data_line)
    {
    }

    template <std::invocable What>
    double place(const ply_number& type, const What& what)
    {
        if (not type.floating)
            return double(whole(type, what));
        to_next(what);
        return type.bytes == 4 ? double(text_.number<float>(what)) : text_.number(what);
    }
    template <std::invocable What>
    std::int64_t whole(const ply_number& type, const What& what)
    {
        to_next(what);
        const auto value = text_.whole<std::int64_t>(what);
        const int bits = int(8 * type.bytes);
        const std::int64_t most = (std::int64_t(1) << (type.is_signed ? bits - 1 : bits)) - 1;
        if (value > most or value < (type.is_signed ? -most - 1 : 0))
            text_.refuse(what() + " is " + std::to_string(value) + ", which does not fit its type");
        return value;
    }
    /// Returns the next number, finite or not.
    template <std::invocable What>
    double value(const ply_number& type, const What& what)
    {
        if (not type.floating)
            return double(whole(type, what));
        to_next(what);
        return as_stored(type, text_.any_number(what));
    }
    void expect_end()
    {
        if (not text_.word_of_any_line().empty())
            text_.refuse("the file goes on after its last element");
    }
    /// Returns the largest number of elements, with `numbers` numbers each, for which the rest of the text has room.
    [[nodiscard]] std::size_t room(std::size_t numbers, std::size_t) const { return (text_.left() + 1) / 2 / numbers; }
    [[noreturn]] void refuse(const std::string& what) const { text_.refuse(what); }

private:
    template <std::invocable What>
    void to_next(const What& what)
    {
        if (not text_.to_content())
            throw file_error("the file ends where " + what() + " should be");
    }

    text_cursor<text_kind::plain> text_;
};

template <std::endian Order>
class binary_numbers {
public:
    binary_numbers(std::string_view bytes, const ply_header& header) : rest_(bytes.substr(header.data_begin)) {}

    template <std::invocable What>
    double place(const ply_number& type, const What& what)
    {
        if (not type.floating)
            return double(whole(type, what));
        const double result = value(type, what);
        if (not std::isfinite(result))
            refuse(what() + " is not a finite number; give finite coordinates");
        return result;
    }
    template <std::invocable What>
    std::int64_t whole(const ply_number& type, const What& what)
    {
        return type.whole<Order>(take(type.bytes, what));
    }
    template <std::invocable What>
    double value(const ply_number& type, const What& what)
    {
        return type.value<Order>(take(type.bytes, what));
    }
    void expect_end() const
    {
        if (not rest_.empty())
            refuse("the file goes on for " + counted(rest_.size(), "byte") + " after its last element");
    }
    [[nodiscard]] std::size_t room(std::size_t, std::size_t bytes) const { return rest_.size() / bytes; }
    [[noreturn]] void refuse(const std::string& what) const { throw file_error(what); }

private:
    /// Takes the next bytes. Errors: file_error if the file ends before them.
    template <std::invocable What>
    const char* take(std::size_t bytes, const What& what)
    {
        if (rest_.size() < bytes)
            throw file_error("the file ends where " + what() + " should be");
        const char* const result = rest_.data();
        rest_.remove_prefix(bytes);
        return result;
    }

    std::string_view rest_;
};

template <class Numbers>
class ply_body {
public:
    ply_body(std::string_view bytes, const ply_header& header) : numbers_(bytes, header), header_(&header) {}

    polygon_soup read()
    {
        for (const auto& element : header_->elements) {
            if (element.is_vertex())
                read_vertices(element);
            else if (element.is_face())
                read_faces(element);
            else if (element.is_strips())
                read_strips(element);
            else
                for (std::uint64_t item = 0; item < element.count; ++item)
                    for (const auto& property : element.properties)
                        skip(element, property, item);
        }
        numbers_.expect_end();
        add_strips();
        return std::move(soup_);
    }

private:
    static std::string name(const ply_element& element, const ply_property& property, std::uint64_t item)
    {
        return element.name + " " + std::to_string(item) + ": " + property.name;
    }
    void read_vertices(const ply_element& element)
    {
        soup_.points.reserve(std::size_t(
            std::min<std::uint64_t>(element.count, numbers_.room(element.properties.size(), element.least_bytes()))));
        const auto place = element.place();
        std::vector<int> coordinate(element.properties.size(), -1);
        for (std::size_t i = 0; i < 3; ++i)
            coordinate[place[i]] = int(i);
        const auto columns = columns_of(element, soup_.attributes.vertices);
        for (std::uint64_t v = 0; v < element.count; ++v) {
            std::array<double, 3> point{};
            for (std::size_t p = 0; p < element.properties.size(); ++p) {
                const ply_property& property = element.properties[p];
                if (coordinate[p] < 0)
                    read_value(element, property, v, soup_.attributes.vertices, columns[p]);
                else
                    point[std::size_t(coordinate[p])] = numbers_.place(property.value,
                                                                       [&] { return name(element, property, v); });
            }
            soup_.points.push_back(point);
        }
    }
    void read_faces(const ply_element& element)
    {
        const std::size_t room = numbers_.room(element.properties.size(), element.least_bytes());
        soup_.faces.first.reserve(std::size_t(std::min<std::uint64_t>(element.count, room)) + 1);
        const std::size_t corners = element.corner_list(), texture = texture_list(element);
        const auto columns = columns_of(element, soup_.attributes.faces);
        for (std::uint64_t f = 0; f < element.count; ++f) {
            for (std::size_t p = 0; p < element.properties.size(); ++p)
                if (p == corners)
                    read_face(element, element.properties[p], f);
                else if (p == texture)
                    read_texture(element, element.properties[p], f);
                else
                    read_value(element, element.properties[p], f, soup_.attributes.faces, columns[p]);
            if (texture != element.properties.size())
                give_texture(element.name, f);
        }
        if (texture != element.properties.size())
            for (std::size_t i = 0; i < 2; ++i)
                soup_.attributes.corners.push_back(
                    {std::string(texture_names[i]), element.properties[texture].value, std::move(texture_[i]), {}});
    }
    /// Reads lists of vertices in which -1 ends a strip.
    void read_strips(const ply_element& element)
    {
        const std::size_t list = element.corner_list();
        std::vector<std::size_t> strip;
        for (std::uint64_t item = 0; item < element.count; ++item)
            for (std::size_t p = 0; p < element.properties.size(); ++p) {
                const ply_property& property = element.properties[p];
                if (p != list) {
                    skip(element, property, item);
                    continue;
                }
                const auto end_strip = [&] {
                    append_strip(strips_, strip, element.name + " " + std::to_string(item));
                    strip.clear();
                };
                for (std::int64_t left = read_length(element, property, item); left > 0; --left) {
                    const auto vertex = numbers_.whole(property.value, [&] { return name(element, property, item); });
                    if (vertex == -1)
                        end_strip();
                    else
                        strip.push_back(checked_vertex(vertex, element.name, item));
                }
                end_strip();
            }
    }
    /// Adds the triangles of the strips behind the faces. They have no attributes.
    void add_strips()
    {
        for (std::size_t f = 0; f < strips_.size(); ++f)
            soup_.faces.push_back(strips_[f]);
        constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
        for (attribute& a : soup_.attributes.faces)
            a.values.resize(soup_.faces.size(), no_number);
        for (attribute& a : soup_.attributes.corners)
            a.values.resize(soup_.faces.vertices.size(), no_number);
    }
    /// Appends the attributes that the properties of an element become. Returns, for each property, the number of its
    /// attribute in `attributes`, or `none` if the property is left out.
    static std::vector<std::size_t> columns_of(const ply_element& element, std::vector<attribute>& attributes)
    {
        std::vector<std::size_t> result(element.properties.size(), none);
        for (const std::size_t p : attributes_in(element)) {
            result[p] = attributes.size();
            attributes.push_back({element.properties[p].name, element.properties[p].value, {}, {}});
        }
        return result;
    }
    void read_value(const ply_element& element, const ply_property& property, std::uint64_t item,
                    std::vector<attribute>& attributes, std::size_t column)
    {
        if (column == none)
            skip(element, property, item);
        else
            attributes[column].values.push_back(
                numbers_.value(property.value, [&] { return name(element, property, item); }));
    }
    void read_texture(const ply_element& element, const ply_property& property, std::uint64_t face)
    {
        texture_of_face_.clear();
        const auto what = [&] { return name(element, property, face); };
        for (std::int64_t left = read_length(element, property, face); left > 0; --left)
            texture_of_face_.push_back(numbers_.value(property.value, what));
    }
    /// Adds the texture coordinates of a face: two numbers per corner, or none for all of them.
    void give_texture(const std::string& element, std::uint64_t face)
    {
        const std::size_t degree = soup_.faces[std::size_t(face)].size();
        const bool is_empty = texture_of_face_.empty();
        if (not is_empty and texture_of_face_.size() != 2 * degree)
            numbers_.refuse(element + " " + std::to_string(face) + " has " + counted(degree, "corner") + " and " +
                            counted(texture_of_face_.size(), "texture coordinate") + ", " + std::to_string(2 * degree) +
                            " are needed");
        for (std::size_t i = 0; i < 2 * degree; ++i)
            texture_[i % 2].push_back(is_empty ? std::numeric_limits<double>::quiet_NaN() : texture_of_face_[i]);
    }
    std::int64_t read_length(const ply_element& element, const ply_property& property, std::uint64_t item)
    {
        const auto what = [&] { return name(element, property, item) + ", its length"; };
        const std::int64_t length = numbers_.whole(property.count, what);
        if (length < 0)
            numbers_.refuse(name(element, property, item) + ": the list has " + std::to_string(length) + " entries");
        return length;
    }
    void read_face(const ply_element& element, const ply_property& property, std::uint64_t face)
    {
        const auto what = [&] { return name(element, property, face); };
        const std::int64_t length = read_length(element, property, face);
        for (std::int64_t i = 0; i < length; ++i) {
            const std::int64_t vertex = numbers_.whole(property.value, what);
            soup_.faces.vertices.push_back(checked_vertex(vertex, "face", face));
        }
        soup_.faces.first.push_back(soup_.faces.vertices.size());
    }
    /// Returns the number of a vertex. Errors: file_error for a vertex that is not in the file.
    std::size_t checked_vertex(std::int64_t vertex, const std::string& element, std::uint64_t item) const
    {
        if (vertex < 0 or std::uint64_t(vertex) >= header_->vertices)
            numbers_.refuse(element + " " + std::to_string(item) + ": vertex " + std::to_string(vertex) +
                            " does not exist, there are " + std::to_string(header_->vertices) + "; correct the index");
        return std::size_t(vertex);
    }
    void skip(const ply_element& element, const ply_property& property, std::uint64_t item)
    {
        const auto what = [&] { return name(element, property, item); };
        const std::int64_t length = property.is_list() ? read_length(element, property, item) : 1;
        for (std::int64_t i = 0; i < length; ++i)
            (void)numbers_.value(property.value, what);
    }

    static constexpr auto none = std::size_t(-1);

    Numbers numbers_;
    const ply_header* header_;
    polygon_soup soup_;
    face_list strips_;                    ///< the triangles of all strips
    std::vector<double> texture_of_face_; ///< of the face that is read
    std::array<std::vector<double>, 2> texture_;
};

} // namespace

polygon_soup read_ply(std::string_view bytes)
{
    const ply_header header = [&] {
        try {
            return read_ply_header(bytes);
        } catch (const mesh_error& error) {
            throw file_error(error.what());
        }
    }();
    polygon_soup soup = header.encoding == ply_encoding::text ? ply_body<text_numbers>(bytes, header).read()
                        : header.encoding == ply_encoding::little_endian
                            ? ply_body<binary_numbers<std::endian::little>>(bytes, header).read()
                            : ply_body<binary_numbers<std::endian::big>>(bytes, header).read();
    soup.not_kept = not_kept(header);
    take_words(header, soup.attributes);
    return soup;
}

} // namespace kith::io
