// SPDX-License-Identifier: BSD-3-Clause
#include "stl_shades.hpp"

#include <kith/io/text/counted.hpp>
#include <kith/io/text/text_cursor.hpp>
#include <kith/merge_points.hpp>
#include <kith/read_mesh.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kith::io {

namespace {

using cursor = text_cursor<text_kind::plain>;

constexpr std::size_t header_bytes = 80;
constexpr std::size_t triangle_bytes = 50; ///< twelve floats and two bytes, in which some programs keep a color

/// Returns true if a word of a text is `small`, in capital or small letters.
bool is_word(std::string_view word, std::string_view small)
{
    return std::ranges::equal(
        word, small, [](char a, char b) { return a == b or (a >= 'A' and a <= 'Z' and char(a + 32) == b); });
}

std::size_t binary_size(std::size_t triangles)
{
    return header_bytes + sizeof(std::uint32_t) + triangles * triangle_bytes;
}

template <class Number>
Number load(std::string_view bytes, std::size_t at)
{
    static_assert(std::endian::native == std::endian::little, "STL is little-endian");
    Number result;
    std::memcpy(&result, bytes.data() + at, sizeof(result));
    return result;
}

/// Returns the number of triangles that a binary file announces.
std::size_t announced_triangles(std::string_view bytes)
{
    return bytes.size() < binary_size(0) ? 0 : load<std::uint32_t>(bytes, header_bytes);
}

/// Returns the colour of the whole part if the header has one, which Materialise writes as "COLOR=" and four bytes.
std::optional<std::array<double, 4>> part_color(std::string_view header)
{
    constexpr std::string_view mark = "COLOR=";
    const std::size_t at = header.find(mark);
    std::array<double, 4> result{};
    if (at == header.npos or header.size() - at - mark.size() < result.size())
        return std::nullopt;
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = static_cast<unsigned char>(header[at + mark.size() + i]);
    return result;
}

/// Adds colours from the two bytes behind each triangle. VisCAM and SolidView have 1 and then red, green and blue in
/// five bits each. Materialise has 0 and then blue, green and red, or 1 for the colour of the part.
void add_colors(polygon_soup& soup, std::string_view header, const std::vector<std::uint16_t>& bits)
{
    const auto of_part = part_color(header);
    const auto differ = [&] { return std::ranges::adjacent_find(bits, std::not_equal_to<>()) != bits.end(); };
    // Without a colour of the part a first bit of 0 says "none", and other programs fill the bytes with a constant.
    const bool are_unused = of_part and not differ() and bits[0] == 0;
    const auto has_own = [&](std::uint16_t of_face) {
        return not are_unused and (of_face >> 15 != 0) != of_part.has_value();
    };
    const bool some_have_own = std::ranges::any_of(bits, has_own);
    if (not some_have_own and not of_part) {
        if (differ())
            soup.not_kept.emplace_back("the two attribute bytes of each triangle");
        return;
    }
    const bool has_alpha = of_part and (*of_part)[3] != 255 and not std::ranges::all_of(bits, has_own);
    for (std::size_t i = 0; i < (has_alpha ? 4 : 3); ++i) {
        attribute channel{std::string(color_names[i]), {1, false, false}, {}};
        for (const std::uint16_t of_face : bits) {
            const auto shade = std::uint16_t(of_face >> (of_part ? 5 * i : 10 - 5 * i) & 31);
            channel.values.push_back(has_own(of_face) ? (i == 3 ? 255 : byte_of_stl_shade(shade))
                                     : of_part        ? (*of_part)[i]
                                                      : std::numeric_limits<double>::quiet_NaN());
        }
        soup.attributes.faces.push_back(std::move(channel));
    }
    if (of_part and header.find("MATERIAL=") != header.npos)
        soup.not_kept.emplace_back("the material of the part");
}

polygon_soup read_binary(std::string_view bytes)
{
    const std::size_t triangles = announced_triangles(bytes);
    if (binary_size(triangles) > bytes.size() or triangles == 0)
        throw file_error("neither text with 'solid' or 'facet' nor binary STL: " + counted(triangles, "triangle") +
                         " would need " + std::to_string(binary_size(triangles)) + " bytes, the file has " +
                         std::to_string(bytes.size()));
    merged_points points(3 * triangles);
    std::vector<std::uint16_t> bits;
    bits.reserve(triangles);
    for (std::size_t f = 0; f < triangles; ++f) {
        for (std::size_t corner = 0; corner < 3; ++corner) { // the normal before them is not read
            std::array<double, 3> p{};
            for (std::size_t i = 0; i < 3; ++i)
                p[i] = load<float>(bytes, binary_size(f) + 4 * (3 + 3 * corner + i));
            if (not(std::isfinite(p[0]) and std::isfinite(p[1]) and std::isfinite(p[2])))
                throw file_error("triangle " + std::to_string(f) +
                                 ": a coordinate is not a finite number; give finite coordinates");
            points.add(p);
        }
        bits.push_back(load<std::uint16_t>(bytes, binary_size(f + 1) - 2));
        file_work.set(binary_size(f + 1));
    }
    polygon_soup soup = points.triangles();
    add_colors(soup, bytes.substr(0, header_bytes), bits);
    if (const std::size_t more = bytes.size() - binary_size(triangles); more != 0)
        soup.notes.push_back(counted(more, "byte") + " after the last of " + counted(triangles, "triangle") +
                             (more == 1 ? " is" : " are") + " ignored");
    return soup;
}

class text_reader {
public:
    explicit text_reader(const cursor& text) : text_(text), points_(text.left() / 80) {}

    polygon_soup read()
    {
        auto word = text_.word_of_any_line();
        for (; not word.empty(); word = text_.word_of_any_line()) {
            const bool has_name = is_word(word, "solid");
            if (not has_name and not(is_word(word, "facet") and solids_ == 0))
                text_.refuse("'solid' is expected here, not '" + shown(word) + "'");
            ++solids_;
            if (has_name) {
                text_.skip_line(); // the name, which may be anything
                word = text_.word_of_any_line();
            }
            for (; is_word(word, "facet"); word = text_.word_of_any_line())
                read_triangle();
            if (word.empty() and has_name)
                throw file_error("the file ends where 'endsolid' should be");
            if (not word.empty() and not is_word(word, "endsolid"))
                text_.refuse("'facet' or 'endsolid' is expected here, not '" + shown(word) + "'");
            text_.skip_line();
        }
        polygon_soup soup = points_.triangles();
        if (solids_ > 1)
            soup.not_kept.emplace_back("the division into " + std::to_string(solids_) + " solids");
        return soup;
    }

private:
    void expect(std::string_view wanted)
    {
        const auto word = text_.word_of_any_line();
        if (word.empty())
            throw file_error("the file ends where '" + std::string(wanted) + "' should be");
        if (not is_word(word, wanted))
            text_.refuse("'" + std::string(wanted) + "' is expected here, not '" + shown(word) + "'");
    }
    void read_triangle()
    {
        const auto what = [&] { return "triangle " + std::to_string(triangles_); };
        const auto to_next = [&](const char* part) {
            if (not text_.to_content())
                throw file_error("the file ends where " + std::string(part) + " of " + what() + " should be");
        };
        expect("normal");
        for (int i = 0; i < 3; ++i) {
            to_next("the normal");
            (void)text_.word(); // often wrong and never used
        }
        expect("outer");
        expect("loop");
        for (int corner = 0; corner < 3; ++corner) {
            expect("vertex");
            std::array<double, 3> p{};
            for (double& x : p) {
                to_next("a vertex");
                x = text_.number(what);
            }
            points_.add(p);
        }
        expect("endloop");
        expect("endfacet");
        ++triangles_;
    }

    cursor text_;
    merged_points points_;
    std::size_t triangles_ = 0, solids_ = 0;
};

/// Returns a cursor at the first line that begins with 'solid' or 'facet', if the bytes are a text with such a line.
std::optional<cursor> begin_of_text(std::string_view bytes)
{
    if (bytes.substr(0, 512).find('\0') != bytes.npos)
        return std::nullopt;
    cursor text(bytes);
    do {
        auto ahead = text;
        if (const auto word = ahead.word(); is_word(word, "solid") or is_word(word, "facet"))
            return text;
    } while (text.next_line());
    return std::nullopt;
}

} // namespace

polygon_soup read_stl(std::string_view bytes)
{
    const std::size_t triangles = announced_triangles(bytes);
    if (triangles != 0 and binary_size(triangles) == bytes.size())
        return read_binary(bytes); // its header may begin with 'solid', too
    const auto text = begin_of_text(bytes);
    return text ? text_reader(*text).read() : read_binary(bytes);
}

} // namespace kith::io
