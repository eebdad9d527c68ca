// SPDX-License-Identifier: BSD-3-Clause
#include <kith/io/format/held_attributes.hpp>

#include "written_parts.hpp"

#include <kith/io/text/counted.hpp>

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

/// A test: is_held(a) is true if a format has room for the attribute `a` of these attributes.
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

attribute_list held_list(const std::vector<attribute>& from, std::span<const std::string_view> names, std::size_t least,
                         std::size_t most)
{
    attribute_list result = find_all(from, names);
    result.resize(result.size() < least ? 0 : std::min(result.size(), most));
    return result;
}

bool holds_file_line(mesh_format format, std::string_view line)
{
    const auto holds_line = file_format_of(format).holds_line;
    return holds_line != nullptr and holds_line(line);
}

held_attributes held_by(mesh_format format, const mesh_attributes& all, bool binary)
{
    const auto held = file_format_of(format).held;
    return held == nullptr ? held_attributes() : held(all, binary);
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
    if (const auto rounds = file_format_of(format).rounds)
        rounded = rounds(attributes, held_by(format, attributes, binary), rest);
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
    if (const auto zeros = file_format_of(format).zeros) {
        const element_attributes lists = zeros(attributes, held_by(format, attributes));
        add(lists.vertices, "vertex");
        add(lists.faces, "face");
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
