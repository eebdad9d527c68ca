// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/in_library.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

// Words in PLY files, which have numbers only: a property of faces has the numbers of words, and comments of the
// header, which others skip, say which: "comment word material 2 red paint".

namespace kith {

/// The tag of OBJ, in PLY a comment, that says that the mesh is of an odd generation: schemes whose steps take turns go
/// on with the other one.
inline constexpr std::string_view odd_generation = "t generation 1/0/0 1";

/// A text without letters that end lines or are no letters.
inline std::string one_line(std::string text)
{
    std::ranges::replace_if(
        text, [](char c) { return (static_cast<unsigned char>(c) < ' ' and c != '\t') or c == 127; }, '_');
    return text;
}

/// The name of a property, which is one word.
inline std::string ply_name(std::string name)
{
    std::ranges::replace(name, ' ', '_');
    return name;
}

/// The lines of a header that say for which words the numbers of a property stand; the first word is that of none, and
/// has no line.
inline std::string ply_word_lines(const std::string& property, const std::vector<std::string>& words)
{
    std::string result;
    for (std::size_t i = 1; i < words.size(); ++i)
        result += "comment word " + ply_name(property) + " " + std::to_string(i) + " " + one_line(words[i]) + "\n";
    return result;
}

/// Lines that name files in which materials or textures are, or that are tags.
inline std::string ply_file_lines(const std::vector<std::string>& lines)
{
    std::string result;
    for (const std::string& line : lines)
        result += "comment " + one_line(line) + "\n";
    return result;
}

/// An unsigned type of PLY in which a file counts the entries of its lists.
struct ply_count {
    std::string_view word;
    std::size_t bytes;
    std::uint64_t most; ///< the largest number that it holds

    /// Returns the narrowest type that holds `entries`, but uint where none does. Many programs read uchar only.
    static constexpr ply_count of(std::uint64_t entries)
    {
        constexpr ply_count uchar{"uchar", 1, 0xff}, ushort{"ushort", 2, 0xffff}, uint{"uint", 4, 0xffffffff};
        return entries <= uchar.most ? uchar : entries <= ushort.most ? ushort : uint;
    }
};

/// The name of the list in which each face has the normals of its corners, three numbers each.
inline constexpr std::string_view ply_corner_normals_name = "normal";

/// Returns the line of that list in a header.
inline std::string ply_corner_normals(const ply_count& length)
{
    return "property list " + std::string(length.word) + " double " + std::string(ply_corner_normals_name) + "\n";
}

/// The number of elements of a file, and the lines of its header for attributes.
struct ply_contents {
    std::size_t vertices, faces;
    bool normals; ///< of vertices, behind their places
    std::uint64_t largest_degree = 4;
    std::string comments{}, vertex_properties{}, face_properties{};
};
/// Returns the header of a file with places as doubles. All writers of PLY begin with it, so that one mesh gives the
/// same bytes everywhere.
inline std::string ply_head(bool binary, const ply_contents& contents)
{
    return std::string("ply\nformat ") + (binary ? "binary_little_endian" : "ascii") +
           " 1.0\ncomment written by kith\n" + contents.comments + "element vertex " +
           std::to_string(contents.vertices) + "\nproperty double x\nproperty double y\nproperty double z\n" +
           (contents.normals ? "property double nx\nproperty double ny\nproperty double nz\n" : "") +
           contents.vertex_properties + "element face " + std::to_string(contents.faces) + "\nproperty list " +
           std::string(ply_count::of(contents.largest_degree).word) + " int vertex_indices\n" +
           contents.face_properties + "end_header\n";
}

/// The words of a property, the first of which says none; nothing where the comments of a header do not say them one by
/// one.
inline std::vector<std::string> words_in_ply(const std::vector<std::string>& comments, const std::string& property)
{
    std::vector<std::string> result;
    const std::string begin = "word " + ply_name(property) + " ";
    for (const std::string_view comment : comments) {
        if (not comment.starts_with(begin))
            continue;
        result.resize(std::max<std::size_t>(result.size(), 1));
        const std::string number = std::to_string(result.size()) + " ";
        if (not comment.substr(begin.size()).starts_with(number))
            return {};
        result.emplace_back(comment.substr(begin.size() + number.size()));
    }
    return result;
}

/// Such lines.
inline std::vector<std::string> file_lines_in_ply(const std::vector<std::string>& comments)
{
    std::vector<std::string> result;
    for (const std::string& comment : comments)
        if (comment.starts_with("mtllib ") or comment.starts_with("TextureFile ") or comment == odd_generation)
            result.push_back(comment);
    return result;
}

} // namespace kith
