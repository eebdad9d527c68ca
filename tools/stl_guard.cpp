// SPDX-License-Identifier: BSD-3-Clause
#include "file_guard.hpp"
#include "text_scanner.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace kith::tool {

namespace {

constexpr std::size_t header_bytes = 80;
constexpr std::size_t triangle_bytes = 50; ///< twelve floats and two bytes without meaning

/// The number of triangles that a binary file announces.
std::size_t announced_triangles(const std::string& bytes)
{
    std::uint32_t count = 0;
    if (bytes.size() >= header_bytes + sizeof(count))
        std::memcpy(&count, bytes.data() + header_bytes, sizeof(count));
    return count;
}

std::size_t binary_size(std::size_t triangles)
{
    return header_bytes + sizeof(std::uint32_t) + triangles * triangle_bytes;
}

file_contents guard_binary(std::string& bytes)
{
    const std::size_t triangles = announced_triangles(bytes);
    if (binary_size(triangles) != bytes.size())
        throw file_error("neither text that begins with 'solid' nor binary STL: " + std::to_string(triangles) +
                         " triangles would need " + std::to_string(binary_size(triangles)) + " bytes, the file has " +
                         std::to_string(bytes.size()));
    for (std::size_t f = 0; f < triangles; ++f) {
        std::array<float, 9> coordinates; // the normal before them is not read
        std::memcpy(coordinates.data(), bytes.data() + binary_size(f) + 3 * sizeof(float), sizeof(coordinates));
        if (not std::ranges::all_of(coordinates, [](float x) { return std::isfinite(x); }))
            throw file_error("triangle " + std::to_string(f) +
                             ": a coordinate is not a finite number; give it a place");
    }
    std::fill_n(bytes.begin(), header_bytes, '\0'); // readers take a name that begins with 'solid' for text
    return {.vertices = 3 * triangles, .faces = triangles, .corners = 3 * triangles, .binary = true};
}

void expect(text_scanner& scan, std::string_view wanted)
{
    const auto word = scan.word_of_any_line();
    if (word.empty())
        throw file_error("the file ends where '" + std::string(wanted) + "' should be");
    if (word != wanted)
        scan.refuse("'" + std::string(wanted) + "' should be here, it is '" + text_scanner::shown(word) + "'");
}

void check_triangle(text_scanner& scan, std::size_t face)
{
    expect(scan, "normal");
    for (int i = 0; i < 3; ++i)
        scan.blank(scan.word_of_any_line()); // often wrong and never used
    expect(scan, "outer");
    expect(scan, "loop");
    for (int corner = 0; corner < 3; ++corner) {
        expect(scan, "vertex");
        for (int i = 0; i < 3; ++i)
            (void)scan.number(scan.word_of_any_line(), [&] { return "triangle " + std::to_string(face); });
    }
    expect(scan, "endloop");
    expect(scan, "endfacet");
}

file_contents guard_text(std::string& bytes)
{
    text_scanner scan(bytes);
    std::size_t triangles = 0;
    for (auto word = scan.word_of_any_line(); not word.empty(); word = scan.word_of_any_line()) {
        if (word != "solid")
            scan.refuse("'solid' should be here, it is '" + text_scanner::shown(word) + "'");
        scan.blank(scan.rest_of_line()); // the name, which may be anything
        for (word = scan.word_of_any_line(); word == "facet"; word = scan.word_of_any_line())
            check_triangle(scan, triangles++);
        if (word.empty())
            throw file_error("the file ends where 'endsolid' should be");
        if (word != "endsolid")
            scan.refuse("'facet' or 'endsolid' should be here, it is '" + text_scanner::shown(word) + "'");
        scan.blank(scan.rest_of_line());
    }
    return {.vertices = 3 * triangles, .faces = triangles, .corners = 3 * triangles};
}

} // namespace

file_contents guard_stl(std::string& bytes)
{
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    const bool named_solid = std::string_view(bytes).substr(first).starts_with("solid");
    const bool text = named_solid and
                      bytes.find('\0') == std::string::npos; // binary headers may begin with 'solid', too
    return text ? guard_text(bytes) : guard_binary(bytes);
}

} // namespace kith::tool
