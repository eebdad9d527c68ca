// SPDX-License-Identifier: BSD-3-Clause
#include <kith/io/format/mesh_attributes.hpp>

#include <kith/io/text/text_cursor.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_set>
#include <utility>

namespace kith::io {

std::string_view shared_name(std::string_view name)
{
    using names = std::pair<std::string_view, std::string_view>;
    constexpr std::array<names, 8> others{{{"diffuse_red", "red"},
                                           {"diffuse_green", "green"},
                                           {"diffuse_blue", "blue"},
                                           {"s", "u"},
                                           {"t", "v"},
                                           {"texture_u", "u"},
                                           {"texture_v", "v"},
                                           {"smoothing_group", "smoothing group"}}};
    const auto found = std::ranges::find(others, name, &names::first);
    return found == others.end() ? name : found->second;
}

const attribute* find(const std::vector<attribute>& attributes, std::string_view name)
{
    const auto found = std::ranges::find(attributes, name, [](const attribute& a) { return shared_name(a.name); });
    return found == attributes.end() ? nullptr : &*found;
}

std::vector<const attribute*> find_all(const std::vector<attribute>& attributes,
                                       std::span<const std::string_view> shared_names)
{
    std::vector<const attribute*> result;
    for (const auto name : shared_names) {
        const attribute* const found = find(attributes, name);
        if (found == nullptr)
            break;
        result.push_back(found);
    }
    return result;
}

namespace {

/// Returns the topic of a name that all formats share, or nothing.
std::string shared_topic_of(std::string_view name)
{
    const auto shared = shared_name(name);
    const auto is_one_of = [&](const auto& names) { return std::ranges::find(names, shared) != std::end(names); };
    if (is_one_of(normal_names) or shared == ply_corner_normals_name)
        return "normals";
    if (is_one_of(color_names))
        return "colours";
    if (is_one_of(texture_names) or shared == "texcoord")
        return "texture coordinates";
    if (shared == "texnumber")
        return "texture numbers";
    if (is_one_of(label_names))
        return std::string(shared) + "s";
    return {};
}

} // namespace

std::string topic_of(std::string_view name)
{
    const std::string topic = shared_topic_of(name);
    return topic.empty() ? "the property '" + shown(name) + "'" : topic;
}

std::string topic_of(std::string_view name, std::string_view elements)
{
    const std::string topic = shared_topic_of(name);
    return topic.empty() ? topic_of(name) + " of " + std::string(elements) : topic;
}

bool is_zero_without_value(const attribute& a)
{
    const std::string topic = shared_topic_of(a.name);
    return topic == "normals" or topic == "colours" or topic == "texture coordinates";
}

bool take_odd_generation(mesh_attributes& attributes)
{
    return std::erase(attributes.file_lines, odd_generation) != 0;
}

std::vector<std::string> topics_of(const mesh_attributes& attributes)
{
    std::vector<std::string> result;
    std::unordered_set<std::string> told;
    const auto add = [&](const std::string& topic) {
        if (told.insert(topic).second)
            result.push_back(topic);
    };
    for (const auto& a : attributes.vertices)
        add(topic_of(a.name, "vertices"));
    for (const auto& a : attributes.corners)
        add(topic_of(a.name, "corners"));
    for (const auto& a : attributes.faces) {
        const std::string topic = topic_of(a.name, "faces");
        add(topic == "colours" ? "colours of faces" : topic);
    }
    for (const std::string& line : attributes.file_lines)
        add(line == odd_generation        ? "the parity of sqrt3 steps (the next one splits the boundary)"
            : line.starts_with("mtllib ") ? "materials"
                                          : "names of texture files");
    return result;
}

double as_stored(const ply_number& type, double value)
{
    if (type.floating)
        return type.bytes == 4 ? double(float(value)) : value;
    const double values = std::ldexp(1., int(8 * type.bytes));
    return type.is_signed ? std::clamp(std::round(value), -values / 2, values / 2 - 1)
                          : std::clamp(std::round(value), 0., values - 1);
}

} // namespace kith::io
