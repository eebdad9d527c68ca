// SPDX-License-Identifier: BSD-3-Clause
#include "written_parts.hpp"

#include <kith/io/format/obj_tag.hpp>
#include <kith/io/text/counted.hpp>
#include <kith/read_mesh.hpp>
#include <kith/tiles/output/ply_words.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kith::io {

namespace {

/// The lines of numbers to which corners refer. Corners of a vertex with the same numbers share a line. Programs that
/// go by the numbers of lines then find the seams where values differ, and no others.
class shared_lines {
public:
    shared_lines(const basic_mesh<>& mesh, const attribute_list& of_corners, const attribute_list& of_vertices)
        : list_(of_corners.empty() ? of_vertices : of_corners), is_of_corners_(not of_corners.empty())
    {
        if (list_.empty())
            return;
        const auto& vertex_of = mesh.topology().corner_vertex;
        std::vector<std::uint32_t> last_of(mesh.vertex_count(), none), before; // by vertex, a linked list of its lines
        std::vector<std::uint32_t> lines(mesh.vertex_count(), 0);              // by vertex, the number of its lines
        const auto is_less = [&](std::size_t a, std::size_t b) { return has_less(a, b); };
        using sorted_lines = std::map<std::size_t, std::uint32_t, decltype(is_less)>;
        std::map<std::size_t, sorted_lines> sorted; // the lines of vertices with too long lists
        line_of_.assign(mesh.corner_count(), none);
        for (std::size_t c = 0; c < line_of_.size(); ++c) {
            const std::size_t element = is_of_corners_ ? c : vertex_of[c];
            if (not has_all(list_, element))
                continue;
            const std::size_t v = vertex_of[c];
            std::uint32_t line = none;
            sorted_lines* many = nullptr;
            if (lines[v] < most_walked) {
                line = last_of[v];
                while (line != none and not are_same(elements_[line], element))
                    line = before[line];
            } else {
                many = &sorted.try_emplace(v, is_less).first->second;
                for (std::uint32_t old = many->empty() ? last_of[v] : none; old != none; old = before[old])
                    many->emplace(elements_[old], old);
                if (const auto found = many->find(element); found != many->end())
                    line = found->second;
            }
            if (line == none) {
                line = std::uint32_t(elements_.size());
                elements_.push_back(element);
                before.push_back(std::exchange(last_of[v], line));
                ++lines[v];
                if (many != nullptr)
                    many->emplace(element, line);
            }
            line_of_[c] = line;
        }
    }

    [[nodiscard]] bool has(std::size_t corner) const { return not line_of_.empty() and line_of_[corner] != none; }
    /// Returns the line of a corner, counted from 1 as in files. Precondition: has(corner).
    [[nodiscard]] std::size_t number(std::size_t corner) const { return std::size_t(line_of_[corner]) + 1; }
    void write(std::ostream& out, std::string_view statement) const
    {
        write_blocks(out, elements_.size(), [&](text_block& text, std::size_t line) {
            text << statement;
            for (const attribute* a : list_)
                text << ' ' << a->values[elements_[line]];
            text << '\n';
        });
    }

private:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max(), most_walked = 64;

    [[nodiscard]] bool are_same(std::size_t a, std::size_t b) const
    {
        return std::ranges::all_of(list_, [&](const attribute* x) { return x->values[a] == x->values[b]; });
    }

    [[nodiscard]] bool has_less(std::size_t a, std::size_t b) const
    {
        for (const attribute* x : list_)
            if (x->values[a] != x->values[b])
                return x->values[a] < x->values[b];
        return false;
    }

    attribute_list list_;
    bool is_of_corners_;
    std::vector<std::size_t> elements_;  ///< by line, the first element that has it
    std::vector<std::uint32_t> line_of_; ///< by corner
};

/// Returns the text as one line that is neither joined to the next line nor cut. A backslash at the end would join the
/// lines; a number sign at the beginning of a word would begin a comment.
std::string as_line(const std::string& text)
{
    std::string line = one_line(text);
    for (std::size_t i = 0; i < line.size(); ++i)
        if (line[i] == '#' and (i == 0 or line[i - 1] == ' ' or line[i - 1] == '\t'))
            line[i] = '_';
    if (const auto last = line.find_last_not_of(" \t"); last != std::string::npos and line[last] == '\\')
        line += '_';
    return line;
}

/// Returns normals as attributes, one per axis, or none if there are no normals.
std::vector<attribute> axes_of(std::span<const std::array<double, 3>> normals)
{
    std::vector<attribute> result;
    for (std::size_t axis = 0; not normals.empty() and axis < 3; ++axis) {
        attribute& a = result.emplace_back(attribute{std::string(normal_names[axis]), {8, true, true}, {}, {}});
        for (const auto& n : normals)
            a.values.push_back(n[axis]);
    }
    return result;
}
attribute_list all_of(const std::vector<attribute>& attributes)
{
    attribute_list result;
    for (const attribute& a : attributes)
        result.push_back(&a);
    return result;
}

/// Writes the statements before a face that has other words than the previous face.
void write_labels(text_block& text, const attribute_list& labels, std::size_t face)
{
    for (const auto& [statement, name] : label_statements)
        for (const attribute* a : labels) {
            const double label = a->values[face];
            if (a->name != name or label == (face == 0 ? 0 : a->values[face - 1]))
                continue;
            const std::string& word = a->labels[std::size_t(label)];
            text << statement
                 << (statement == "s" and word.empty() ? " off"
                     : word.empty()                    ? ""
                                                       : " ")
                 << as_line(word) << '\n';
        }
}

bool is_line_of_obj(std::string_view line)
{
    return line.starts_with("mtllib ") or line == odd_generation;
}

void write_obj(std::ostream& out, const written_mesh& what)
{
    const bool has_normals = not what.normals.empty() and what.corner_normals.empty();
    const held_attributes held = held_by(mesh_format::obj, what);
    const shared_lines textures(what.mesh, held.corner_textures, held.textures);
    const std::vector<attribute> of_corners = axes_of(what.corner_normals);
    const shared_lines normals(what.mesh, of_corners.empty() ? held.corner_normals : all_of(of_corners), held.normals);
    text_block header;
    header << "# kith: " << counted(vertices_of(what), "vertex") << ", " << counted(what.mesh.face_count(), "face")
           << '\n';
    if (what.attributes != nullptr)
        for (const std::string& line : what.attributes->file_lines)
            if (is_line_of_obj(line))
                header << as_line(line) << '\n';
    out << header.text();
    write_blocks(out, vertices_of(what), [&](text_block& text, std::size_t v) {
        text << "v " << point_of(what, v);
        if (has_all(held.colors, v))
            for (const attribute* color : held.colors)
                text << ' ' << unit_color(*color, v);
        text << '\n';
        if (has_normals)
            text << "vn " << normal_of(what, v) << '\n';
    });
    textures.write(out, "vt");
    normals.write(out, "vn");
    write_blocks(out, what.mesh.face_count(), [&](text_block& text, std::size_t f) {
        write_labels(text, held.labels, f);
        text << "f ";
        std::size_t corner = what.mesh.topology().first_corner(f);
        for (const auto v : what.mesh.face(f)) {
            text << ' ' << std::size_t(v) + 1;
            const bool has_texture = textures.has(corner);
            if (has_texture)
                text << '/' << textures.number(corner);
            if (has_normals or normals.has(corner))
                text << (has_texture ? "/" : "//") << (has_normals ? std::size_t(v) + 1 : normals.number(corner));
            ++corner;
        }
        text << '\n';
    });
    if (what.tags != nullptr)
        out << obj_tag_lines(*what.tags);
}

void require_for_obj(const written_mesh& what)
{
    require_finite_normals(what);
    require_finite_corner_normals(what);
    require_finite_values(mesh_format::obj, what);
}

held_attributes held_by_obj(const mesh_attributes& all, bool)
{
    held_attributes result;
    result.colors = held_list(all.vertices, color_names, 3, 4);
    result.corner_textures = held_list(all.corners, texture_names, 1, 3);
    if (result.corner_textures.empty())
        result.textures = held_list(all.vertices, texture_names, 1, 3);
    result.corner_normals = held_list(all.corners, normal_names, 3, 3);
    if (result.corner_normals.empty())
        result.normals = held_list(all.vertices, normal_names, 3, 3);
    result.labels = held_if(all.faces, [](const attribute& a) { return not a.labels.empty(); });
    return result;
}

} // namespace

extern const file_format obj_format{.format = mesh_format::obj,
                                    .extension = ".obj",
                                    .contents = {.tags = true, .corner_normals = true},
                                    .read = read_obj,
                                    .write = write_obj,
                                    .require = require_for_obj,
                                    .held = held_by_obj,
                                    .holds_line = is_line_of_obj};

} // namespace kith::io
