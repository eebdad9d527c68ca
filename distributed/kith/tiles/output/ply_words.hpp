// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/in_library.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

// Words in PLY files, which hold only numbers: a property of faces has the numbers of words. Comments of the header,
// which other programs skip, give the words: "comment word material 2 red paint".

namespace kith {

/// The OBJ tag, in PLY a comment, for a mesh of an odd generation. Schemes with alternating steps then continue with
/// the second of their steps.
inline constexpr std::string_view odd_generation = "t generation 1/0/0 1";

/// Returns a text with control characters, which include line ends but not tabs, replaced by '_'.
inline std::string one_line(std::string text)
{
    std::ranges::replace_if(
        text, [](char c) { return (static_cast<unsigned char>(c) < ' ' and c != '\t') or c == 127; }, '_');
    return text;
}

/// Returns the name of a property, which is one word: spaces become '_'.
inline std::string ply_name(std::string name)
{
    std::ranges::replace(name, ' ', '_');
    return name;
}

/// Returns the lines of a header that give the words for the numbers of a property. Word 0 means that there is no word,
/// and has no line.
inline std::string ply_word_lines(const std::string& property, const std::vector<std::string>& words)
{
    std::string result;
    for (std::size_t i = 1; i < words.size(); ++i)
        result += "comment word " + ply_name(property) + " " + std::to_string(i) + " " + one_line(words[i]) + "\n";
    return result;
}

/// Returns the comment lines for lines of a mesh file that name files of materials or textures, or that are tags.
inline std::string ply_file_lines(const std::vector<std::string>& lines)
{
    std::string result;
    for (const std::string& line : lines)
        result += "comment " + one_line(line) + "\n";
    return result;
}

/// An unsigned PLY type in which a file counts the entries of its lists.
struct ply_count {
    std::string_view word;
    std::size_t bytes;
    std::uint64_t most; ///< the largest number of the type

    /// Returns the narrowest type that holds `entries`, or uint if none does. Many programs read only uchar.
    static constexpr ply_count of(std::uint64_t entries)
    {
        constexpr ply_count uchar{"uchar", 1, 0xff}, ushort{"ushort", 2, 0xffff}, uint{"uint", 4, 0xffffffff};
        return entries <= uchar.most ? uchar : entries <= ushort.most ? ushort : uint;
    }
};

/// The name of the list with the normals of a face's corners, three numbers each.
inline constexpr std::string_view ply_corner_normals_name = "normal";

/// Returns the header line of that list.
inline std::string ply_corner_normals(const ply_count& length)
{
    return "property list " + std::string(length.word) + " double " + std::string(ply_corner_normals_name) + "\n";
}

/// The counts of the elements of a file, and the lines of its header for attributes.
struct ply_contents {
    std::size_t vertices, faces;
    bool normals; ///< of vertices, after their coordinates
    std::uint64_t largest_degree = 4;
    std::string comments{}, vertex_properties{}, face_properties{};
};
/// Returns the header of a file with coordinates as doubles. All writers of PLY use it, so that one mesh gives the same
/// bytes everywhere.
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

/// Returns the words of a property; the first stands for no word. The result is empty if the comments of a header do
/// not number the words consecutively.
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

/// Returns the comments that name files of materials or textures, or that are tags.
inline std::vector<std::string> file_lines_in_ply(const std::vector<std::string>& comments)
{
    std::vector<std::string> result;
    for (const std::string& comment : comments)
        if (comment.starts_with("mtllib ") or comment.starts_with("TextureFile ") or comment == odd_generation)
            result.push_back(comment);
    return result;
}

} // namespace kith
