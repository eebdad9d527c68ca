// SPDX-License-Identifier: BSD-3-Clause
#include <kith/format/held_attributes.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>

namespace kith::io {

namespace {

attribute_list take(const std::vector<attribute>& from, std::span<const std::string_view> names, std::size_t least,
                    std::size_t most)
{
    attribute_list result = find_all(from, names);
    result.resize(result.size() < least ? 0 : std::min(result.size(), most));
    return result;
}

bool has_words(const attribute& a)
{
    return not a.labels.empty();
}

template <class Which>
attribute_list take_if(const std::vector<attribute>& from, const Which& which)
{
    attribute_list result;
    for (const attribute& a : from)
        if (which(a))
            result.push_back(&a);
    return result;
}

/// Whether a format has room for an attribute among these.
class held_test {
public:
    held_test(mesh_format format, const mesh_attributes& attributes)
    {
        const held_attributes held = held_by(format, attributes);
        for (const auto* list : {&held.colors,
                                 &held.normals,
                                 &held.textures,
                                 &held.face_colors,
                                 &held.corner_normals,
                                 &held.corner_textures,
                                 &held.labels,
                                 &held.vertices,
                                 &held.faces})
            held_.insert(list->begin(), list->end());
    }

    bool operator()(const attribute& a) const { return held_.contains(&a); }

private:
    std::unordered_set<const attribute*> held_;
};

} // namespace

bool holds_file_line(mesh_format format, std::string_view line)
{
    return format == mesh_format::ply or
           (format == mesh_format::obj and (line.starts_with("mtllib ") or line == odd_generation));
}

held_attributes held_by(mesh_format format, const mesh_attributes& all)
{
    held_attributes result;
    const auto is_any = [](const attribute&) { return true; };
    switch (format) {
    case mesh_format::obj:
        result.colors = take(all.vertices, color_names, 3, 4);
        result.corner_textures = take(all.corners, texture_names, 1, 3);
        if (result.corner_textures.empty())
            result.textures = take(all.vertices, texture_names, 1, 3);
        result.corner_normals = take(all.corners, normal_names, 3, 3);
        if (result.corner_normals.empty())
            result.normals = take(all.vertices, normal_names, 3, 3);
        result.labels = take_if(all.faces, has_words);
        break;
    case mesh_format::ply:
        result.vertices = take_if(all.vertices, is_any);
        result.faces = take_if(all.faces, is_any);
        result.corner_textures = take(all.corners, texture_names, 2, 2);
        break;
    case mesh_format::off:
        result.colors = take(all.vertices, color_names, 3, 4);
        result.normals = take(all.vertices, normal_names, 3, 3);
        result.textures = take(all.vertices, texture_names, 2, 2);
        result.face_colors = take(all.faces, color_names, 3, 4);
        break;
    case mesh_format::stl:
    case mesh_format::vtu: break; // in tiles, see tile_attributes
    }
    return result;
}

std::vector<std::string> not_held(mesh_format format, const mesh_attributes& attributes)
{
    const held_test is_held(format, attributes);
    mesh_attributes rest; // by name
    const auto add_rest = [&](const std::vector<attribute>& from, std::vector<attribute>& to) {
        for (const attribute& a : from)
            if (not is_held(a))
                to.emplace_back().name = a.name;
    };
    add_rest(attributes.vertices, rest.vertices);
    add_rest(attributes.corners, rest.corners);
    add_rest(attributes.faces, rest.faces);
    std::ranges::copy_if(attributes.file_lines, std::back_inserter(rest.file_lines), [&](const std::string& line) {
        return not holds_file_line(format, line);
    });
    return topics_of(rest);
}

void keep_held(mesh_format format, mesh_attributes& attributes)
{
    const held_test is_held(format, attributes);
    mesh_attributes kept;
    const auto take = [&](std::vector<attribute>& from, std::vector<attribute>& to) {
        for (attribute& a : from)
            if (is_held(a))
                to.push_back(std::move(a));
    };
    take(attributes.vertices, kept.vertices);
    take(attributes.corners, kept.corners);
    take(attributes.faces, kept.faces);
    std::ranges::copy_if(attributes.file_lines, std::back_inserter(kept.file_lines), [&](const std::string& line) {
        return holds_file_line(format, line);
    });
    attributes = std::move(kept);
}

} // namespace kith::io
