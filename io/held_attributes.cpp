// SPDX-License-Identifier: BSD-3-Clause
#include <kith/format/held_attributes.hpp>

#include "stl_shades.hpp"

#include <kith/text/counted.hpp>

#include <algorithm>
#include <cmath>
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

/// Tests whether a face is not opaque.
bool has_transparency(const attribute& alpha)
{
    const double opaque = color_unit(alpha.type);
    return std::ranges::any_of(alpha.values, [&](double x) { return not std::isnan(x) and x != opaque; });
}
/// Tests whether a value is none of the 32 shades of binary STL.
bool has_more_shades(const attribute* channel)
{
    constexpr double rounding = 1e-9;
    return std::ranges::any_of(channel->values, [&](double x) {
        const double unit = x / color_unit(channel->type);
        return not std::isnan(x) and not(std::abs(byte_of_stl_shade(stl_shade(unit)) - 255 * unit) < rounding);
    });
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
    held_test(mesh_format format, const mesh_attributes& attributes, bool binary)
    {
        const held_attributes held = held_by(format, attributes, binary);
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

held_attributes held_by(mesh_format format, const mesh_attributes& all, bool binary)
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
        if (binary)
            result.face_colors = take(all.faces, color_names, 3, 3);
        break;
    case mesh_format::vtu: break; // written in tiles
    }
    return result;
}

std::vector<std::string> not_held(mesh_format format, const mesh_attributes& attributes, bool binary)
{
    const held_test is_held(format, attributes, binary);
    mesh_attributes rest; // by name
    std::vector<std::string> rounded;
    const auto add_rest = [&](const std::vector<attribute>& from, std::vector<attribute>& to) {
        for (const attribute& a : from)
            if (not is_held(a))
                to.emplace_back().name = a.name;
    };
    add_rest(attributes.vertices, rest.vertices);
    add_rest(attributes.corners, rest.corners);
    add_rest(attributes.faces, rest.faces);
    if (const attribute_list colors = held_by(format, attributes, binary).face_colors;
        format == mesh_format::stl and not colors.empty()) {
        const bool has_alpha = std::erase_if(rest.faces,
                                             [](const attribute& a) { return shared_name(a.name) == "alpha"; }) != 0;
        if (has_alpha and has_transparency(*find(attributes.faces, "alpha")))
            rounded.emplace_back("the transparency of faces");
        if (std::ranges::any_of(colors, has_more_shades))
            rounded.emplace_back("colours of faces beyond 32 shades of red, green and blue");
    }
    std::ranges::copy_if(attributes.file_lines, std::back_inserter(rest.file_lines), [&](const std::string& line) {
        return not holds_file_line(format, line);
    });
    std::vector<std::string> result = topics_of(rest);
    result.insert(result.end(), rounded.begin(), rounded.end());
    return result;
}

std::vector<std::string> written_as_zero(mesh_format format, const mesh_attributes& attributes)
{
    struct lack {
        std::string topic;
        std::size_t missing;
    };
    std::vector<std::string> result;
    const held_attributes held = held_by(format, attributes);
    const auto add = [&](const attribute_list& list, const std::string& elements) {
        std::vector<lack> lacks;
        std::size_t all = 0;
        for (const attribute* a : list) {
            const auto missing = std::size_t(std::ranges::count_if(a->values, [](double x) { return std::isnan(x); }));
            all = a->values.size();
            if (missing == 0 or not a->labels.empty())
                continue;
            const std::string topic = topic_of(a->name);
            const auto found = std::ranges::find(lacks, topic, &lack::topic);
            if (found == lacks.end())
                lacks.push_back({topic, missing});
            else
                found->missing = std::max(found->missing, missing);
        }
        for (const auto& [topic, missing] : lacks)
            result.push_back((topic.starts_with("the ") ? "" : "the ") + topic + " of " + std::to_string(missing) +
                             " of " + counted(all, elements));
    };
    const auto in_ply = [](const std::vector<attribute>& of_elements) {
        return take_if(of_elements, [](const attribute& a) { return not a.type.floating or is_zero_without_value(a); });
    };
    const auto in_vtu = [](const std::vector<attribute>& of_elements) {
        return take_if(of_elements, [](const attribute& a) { return not a.type.floating; });
    };
    switch (format) {
    case mesh_format::off:
        add(held.normals, "vertex");
        add(held.textures, "vertex");
        break;
    case mesh_format::ply:
        add(in_ply(attributes.vertices), "vertex");
        add(in_ply(attributes.faces), "face");
        break;
    case mesh_format::vtu:
        add(in_vtu(attributes.vertices), "vertex");
        add(in_vtu(attributes.faces), "face");
        break;
    case mesh_format::obj:
    case mesh_format::stl: break;
    }
    return result;
}

void keep_held(mesh_format format, mesh_attributes& attributes, bool binary)
{
    const held_test is_held(format, attributes, binary);
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
