// SPDX-License-Identifier: BSD-3-Clause
#include "file_guard.hpp"
#include "text_scanner.hpp"

#include <algorithm>
#include <string>
#include <string_view>

namespace kith::tool {

namespace {

/// The next line with words on it, its comment blanked; refuses the end of the file.
template <std::invocable Wanted>
void next_content(text_scanner& scan, const Wanted& wanted)
{
    while (scan.advance()) {
        scan.blank_comment();
        if (text_scanner ahead = scan; not ahead.word().empty())
            return;
    }
    throw file_error("the file ends where " + std::string(wanted()) + " should be");
}

/// [ST][C][N][4][n]OFF: the letters before OFF say what else stands in the vertex lines.
bool read_keyword(text_scanner& scan)
{
    std::string_view word = scan.word();
    const std::string_view keyword = word;
    for (const std::string_view prefix : {"ST", "C", "N"})
        if (word.starts_with(prefix))
            word.remove_prefix(prefix.size());
    const bool homogeneous = word == "4OFF";
    if (word == "nOFF" or word == "4nOFF")
        scan.refuse("'" + std::string(keyword) + "' has another number of coordinates than three; write it as OFF");
    if (not homogeneous and word != "OFF")
        scan.refuse("an OFF file begins with the word OFF, this one with '" + text_scanner::shown(keyword) + "'");
    return homogeneous;
}

void check_vertex(text_scanner& scan, std::size_t vertex, bool homogeneous)
{
    const auto what = [&] { return "vertex " + std::to_string(vertex); };
    const int coordinates = homogeneous ? 4 : 3;
    for (int i = 0; i < coordinates; ++i) {
        const auto word = scan.word();
        if (word.empty())
            scan.refuse(what() + " has " + std::to_string(i) + " coordinates, " + std::to_string(coordinates) +
                        " are needed");
        if (scan.number(word, what) == 0 and i == 3)
            scan.refuse(what() + " lies at infinity, its fourth coordinate is 0; give it a place");
    }
    // A normal, a color and a texture coordinate may follow: at most 4 + 4 + 3 numbers.
    int more = 0;
    for (auto word = scan.word(); not word.empty(); word = scan.word(), ++more)
        (void)scan.number(word, what);
    if (more > 11)
        scan.refuse(what() + " has too many numbers; each vertex has a line of its own");
}

std::size_t check_face(text_scanner& scan, std::size_t face, std::size_t vertices)
{
    const auto what = [&] { return "face " + std::to_string(face); };
    const auto degree = scan.whole<std::size_t>(scan.word(), [&] { return what() + ": its number of corners"; });
    for (std::size_t i = 0; i < degree; ++i) {
        const auto word = scan.word();
        if (word.empty())
            scan.refuse(what() + " should have " + std::to_string(degree) + " corners, " + std::to_string(i) +
                        " are there");
        const auto vertex = scan.whole<std::ptrdiff_t>(word, [&] { return what() + ": a vertex"; });
        if (vertex < 0 or std::size_t(vertex) >= vertices)
            scan.refuse(what() + ": vertex " + std::to_string(vertex) + " does not exist, there are " +
                        std::to_string(vertices) + "; correct the index");
    }
    int more = 0; // a color: one to four numbers
    for (auto word = scan.word(); not word.empty(); word = scan.word(), ++more)
        (void)scan.number(word, [&] { return what() + ": its color"; });
    if (more > 4)
        scan.refuse(what() + " has too many numbers; each face has a line of its own");
    return degree;
}

} // namespace

file_contents guard_off(std::string& bytes)
{
    file_contents result;
    text_scanner scan(bytes);
    next_content(scan, [&] { return std::string("the word OFF"); });
    result.homogeneous = read_keyword(scan);
    if (text_scanner ahead = scan; ahead.word().empty())
        next_content(scan, [&] { return std::string("the numbers of vertices and faces"); });
    const auto first = scan.word();
    if (first == "BINARY")
        scan.refuse("binary OFF is not read, as programs do not agree on its byte order; save it as text or as PLY");
    result.vertices = scan.whole<std::size_t>(first, [] { return std::string("the number of vertices"); });
    result.faces = scan.whole<std::size_t>(scan.word(), [] { return std::string("the number of faces"); });
    if (const auto edges = scan.word(); not edges.empty())
        (void)scan.whole<std::ptrdiff_t>(edges, [] { return std::string("the number of edges"); });
    if (not scan.word().empty())
        scan.refuse("more than the numbers of vertices, faces and edges stands on this line");

    // The shortest vertex is "0 0 0\n" and the shortest face "0\n".
    result.data_begin = std::min(scan.next_line(), bytes.size());
    const std::size_t room = bytes.size() - result.data_begin + 1;
    if (result.vertices > room / 6 or result.faces > (room - 6 * result.vertices) / 2)
        scan.refuse("the file is too short for " + std::to_string(result.vertices) + " vertices and " +
                    std::to_string(result.faces) + " faces");

    for (std::size_t v = 0; v < result.vertices; ++v) {
        next_content(scan, [&] { return "vertex " + std::to_string(v) + " of " + std::to_string(result.vertices); });
        check_vertex(scan, v, result.homogeneous);
    }
    for (std::size_t f = 0; f < result.faces; ++f) {
        next_content(scan, [&] { return "face " + std::to_string(f) + " of " + std::to_string(result.faces); });
        result.corners += check_face(scan, f, result.vertices);
    }
    while (scan.advance()) {
        scan.blank_comment();
        if (not scan.word().empty())
            scan.refuse("the file goes on after its " + std::to_string(result.vertices) + " vertices and " +
                        std::to_string(result.faces) + " faces");
    }
    return result;
}

} // namespace kith::tool
