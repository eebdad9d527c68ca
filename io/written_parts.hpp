// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "file_format.hpp"

#include <kith/io/text/text_writer.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Functions that the writers of several formats share.
namespace kith::io {

/// Throws file_error for normals, or for values of attributes that a format writes as text, that are not finite.
void require_finite_normals(const written_mesh& what);
void require_finite_corner_normals(const written_mesh& what);
void require_finite_values(mesh_format format, const written_mesh& what);

/// Throws file_error for a vertex whose place is too large for a float. `format_and_remedy` ends the message.
void require_float_points(const written_mesh& what, const std::string& format_and_remedy);

/// Returns the attributes of these names, at most `most` of them. Returns none if there are fewer than `least`.
attribute_list held_list(const std::vector<attribute>& from, std::span<const std::string_view> names, std::size_t least,
                         std::size_t most);

/// Returns the attributes for which `which` returns true.
template <class Which>
attribute_list held_if(const std::vector<attribute>& from, const Which& which)
{
    attribute_list result;
    for (const attribute& a : from)
        if (which(a))
            result.push_back(&a);
    return result;
}

/// Returns the attributes of whole numbers, which have no word for "none".
inline element_attributes whole_numbers(const mesh_attributes& all, const held_attributes&)
{
    const auto is_whole = [](const attribute& a) { return not a.type.floating; };
    return {held_if(all.vertices, is_whole), held_if(all.faces, is_whole)};
}

inline std::size_t vertices_of(const written_mesh& what)
{
    return what.mesh.vertex_count() + what.isolated.size();
}

inline const std::array<double, 3>& point_of(const written_mesh& what, std::size_t vertex)
{
    const std::size_t vertices = what.mesh.vertex_count();
    return vertex < vertices ? what.mesh.point(vertex) : what.isolated[vertex - vertices];
}

/// Returns the normal of a vertex, or zero for an isolated point, which has none.
inline std::array<double, 3> normal_of(const written_mesh& what, std::size_t vertex)
{
    return vertex < what.normals.size() ? what.normals[vertex] : std::array<double, 3>{};
}

/// Returns the attributes for which the format has room. Normals that are passed separately replace the normals among
/// the attributes.
inline held_attributes held_by(mesh_format format, const written_mesh& what)
{
    held_attributes result = what.attributes == nullptr ? held_attributes()
                                                        : held_by(format, *what.attributes, what.binary);
    if (not what.normals.empty() or not what.corner_normals.empty()) {
        result.normals.clear();
        result.corner_normals.clear();
        std::erase_if(result.vertices, [](const auto* a) { return topic_of(a->name, "") == "normals"; });
    }
    return result;
}

/// Returns true if an element has all the numbers of a list. Of an empty list no element has them.
inline bool has_all(const attribute_list& list, std::size_t element)
{
    return not list.empty() and
           std::ranges::none_of(list, [&](const auto* a) { return std::isnan(a->values[element]); });
}

/// Returns a channel of a colour as a number from 0 to 1 if its type is not floating; else its value.
inline double unit_color(const attribute& a, std::size_t element)
{
    return a.values[element] / color_unit(a.type);
}

} // namespace kith::io
