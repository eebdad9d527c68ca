// SPDX-License-Identifier: BSD-3-Clause
#include "file_guard.hpp"
#include "obj_tag.hpp"
#include "text_scanner.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>

namespace kith::tool {

namespace {

/// Statements that say nothing about the polygons.
constexpr std::array<std::string_view, 49> other_statements{
    "vt",     "vn",     "vp",       "o",    "g",          "s",         "mg",     "usemtl", "mtllib", "maplib",
    "usemap", "bevel",  "c_interp", "lod",  "shadow_obj", "trace_obj", "ctech",  "stech",  "l",      "p",
    "cstype", "deg",    "step",     "bmat", "curv",       "curv2",     "surf",   "parm",   "trim",   "hole",
    "scrv",   "sp",     "end",      "con",  "bsp",        "bzp",       "cdc",    "cdp",    "res",    "call",
    "csh",    "surf_1", "q0_1",     "q1_1", "curv2d_1",   "d_interp",  "surf_2", "q0_2",   "q1_2"};

void check_vertex(text_scanner& scan, std::size_t vertex)
{
    const auto what = [&] { return "vertex " + std::to_string(vertex + 1); };
    int numbers = 0; // three coordinates; a weight or a color may follow
    for (auto word = scan.word(); not word.empty(); word = scan.word(), ++numbers)
        (void)scan.number(word, what);
    if (numbers < 3)
        scan.refuse(what() + " has " + std::to_string(numbers) + " coordinates, 3 are needed");
}

/// Indices count from 1; negative ones count back from the last vertex so far. `v`, `v/t`, `v//n` and `v/t/n`.
struct checked_face {
    std::size_t corners = 0;
    std::ptrdiff_t largest_index = 0;
};
checked_face check_face(text_scanner& scan, std::size_t face, std::size_t vertices)
{
    const auto what = [&] { return "face " + std::to_string(face + 1); };
    checked_face result;
    for (auto word = scan.word(); not word.empty(); word = scan.word(), ++result.corners) {
        const auto slash = word.find('/');
        const auto index = scan.whole<std::ptrdiff_t>(word.substr(0, slash), [&] { return what() + ": a vertex"; });
        if (index == 0 or index < -std::ptrdiff_t(vertices) or index > std::numeric_limits<int>::max())
            scan.refuse(what() + ": vertex " + std::to_string(index) + " does not exist, there are " +
                        std::to_string(vertices) + " so far; correct the index");
        result.largest_index = std::max(result.largest_index, index);
        if (slash == word.npos)
            continue;
        for (std::string_view rest = word.substr(slash + 1); not rest.empty();) {
            const auto end = std::min(rest.find('/'), rest.size());
            if (end != 0)
                (void)scan.whole<std::ptrdiff_t>(rest.substr(0, end),
                                                 [&] { return what() + ": a texture coordinate or normal"; });
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
        scan.blank(word.substr(slash));
    }
    return result;
}

} // namespace

file_contents guard_obj(std::string& bytes)
{
    std::ranges::replace(bytes, '\t', ' '); // the reader looks for spaces between corners
    for (std::size_t i = bytes.find('\\'); i != std::string::npos; i = bytes.find('\\', i)) {
        const std::size_t end = bytes.find_first_not_of(" \r", i + 1);
        if (end == std::string::npos or bytes[end] != '\n')
            ++i; // part of a name
        else
            std::fill(
                bytes.begin() + std::ptrdiff_t(i), bytes.begin() + std::ptrdiff_t(end) + 1, ' '); // continues the line
    }
    file_contents result;
    std::ptrdiff_t largest_index = 0;
    std::string its_face;
    text_scanner scan(bytes);
    while (scan.advance()) {
        scan.blank_comment();
        const auto statement = scan.word();
        if (statement == "v") {
            check_vertex(scan, result.vertices++);
        } else if (statement == "f") {
            const auto face = check_face(scan, result.faces++, result.vertices);
            result.corners += face.corners;
            if (face.largest_index > largest_index) {
                largest_index = face.largest_index;
                its_face = "line " + std::to_string(scan.line()) + ": face " + std::to_string(result.faces);
            }
        } else if (statement == "t") {
            read_obj_tag(scan, result.tags);
            scan.blank_line();
        } else if (statement.empty() or std::ranges::find(other_statements, statement) != other_statements.end()) {
            scan.blank_line();
        } else {
            scan.refuse("'" + text_scanner::shown(statement) + "' is no statement of an OBJ file");
        }
    }
    if (std::size_t(largest_index) > result.vertices)
        throw file_error(its_face + ": vertex " + std::to_string(largest_index) + " does not exist, there are " +
                         std::to_string(result.vertices) + "; correct the index");
    if (result.vertices == 0 or result.faces == 0)
        throw file_error("the file has " + std::to_string(result.vertices) + " vertices and " +
                         std::to_string(result.faces) + " faces; nothing can be refined");
    return result;
}

} // namespace kith::tool
