// SPDX-License-Identifier: BSD-3-Clause
#include <kith/io/format/ply_attributes.hpp>

#include <kith/io/text/text_cursor.hpp>
#include <kith/tiles/output/ply_words.hpp>

#include <algorithm>
#include <string_view>
#include <utility>

namespace kith::io {

std::size_t texture_list(const ply_element& element)
{
    const auto found = std::ranges::find_if(element.properties,
                                            [](const ply_property& p) { return p.is_list() and p.name == "texcoord"; });
    return std::size_t(found - element.properties.begin());
}

std::vector<std::size_t> attributes_in(const ply_element& element)
{
    std::vector<std::size_t> result;
    for (std::size_t p = 0; p < element.properties.size(); ++p)
        if (not element.properties[p].is_list())
            result.push_back(p);
    if (element.is_vertex())
        for (const std::size_t coordinate : element.place())
            std::erase(result, coordinate);
    return result;
}

void take_words(const ply_header& header, mesh_attributes& attributes)
{
    attributes.file_lines = file_lines_in_ply(header.comments);
    for (const std::string_view name : label_names) {
        const auto found = std::ranges::find(attributes.faces, ply_name(std::string(name)), &attribute::name);
        if (found == attributes.faces.end() or found->type.floating)
            continue;
        auto words = words_in_ply(header.comments, found->name);
        if (words.empty() or
            not std::ranges::all_of(found->values, [&](double x) { return x >= 0 and x < double(words.size()); }))
            continue;
        found->name = name;
        found->labels = std::move(words);
    }
}

mesh_attributes kinds_in(const ply_header& header)
{
    mesh_attributes result;
    for (const auto& element : header.elements)
        if (element.is_vertex() or element.is_face())
            for (const std::size_t p : attributes_in(element))
                (element.is_vertex() ? result.vertices : result.faces)
                    .push_back({element.properties[p].name, element.properties[p].value, {}, {}});
    take_words(header, result);
    return result;
}

std::size_t property_of(const ply_element& element, const attribute& a)
{
    return std::size_t(std::ranges::find(element.properties, ply_name(a.name), &ply_property::name) -
                       element.properties.begin());
}

std::vector<std::string> not_kept(const ply_header& header)
{
    std::vector<std::string> result;
    for (const auto& element : header.elements) {
        if (element.is_strips()) {
            for (std::size_t p = 0; p < element.properties.size(); ++p)
                if (p != element.corner_list())
                    result.push_back(topic_of(element.properties[p].name, "strips"));
            continue;
        }
        if (not element.is_vertex() and not element.is_face()) {
            if (element.count != 0)
                result.push_back("the elements '" + shown(element.name) + "'");
            continue;
        }
        const std::size_t size = element.properties.size();
        const std::size_t corners = element.is_face() ? element.corner_list() : size;
        const std::size_t texture = element.is_face() ? texture_list(element) : size;
        for (std::size_t p = 0; p < size; ++p)
            if (element.properties[p].is_list() and p != corners and p != texture)
                result.push_back(topic_of(element.properties[p].name, element.is_vertex() ? "vertices" : "faces"));
    }
    return result;
}

} // namespace kith::io
