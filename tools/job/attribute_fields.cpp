// SPDX-License-Identifier: BSD-3-Clause
#include "attribute_fields.hpp"

#include <kith/core/base/storage.hpp>
#include <kith/tiles/refine/plan_tile.hpp>

#include <algorithm>
#include <limits>
#include <utility>

namespace kith::tool {

namespace {

/// The number of attributes that a field carries together.
constexpr std::size_t together = 4;

/// Returns a field with the values of up to `together` attributes, from number `first` on.
template <class Field, class Rule>
Field field_of(const std::vector<io::attribute>& attributes, std::size_t first, std::size_t elements, Rule rule)
{
    storage<typename Field::value_type> values(elements);
    std::fill(values.begin(), values.end(), typename Field::value_type{});
    for (std::size_t i = first; i < std::min(first + together, attributes.size()); ++i)
        for (std::size_t element = 0; element < elements; ++element)
            values[element][i - first] = attributes[i].values[element];
    return Field(values, rule);
}

template <class Field, class Rule>
void append_fields(std::vector<Field>& fields, const std::vector<io::attribute>& attributes, std::size_t elements,
                   Rule rule)
{
    for (std::size_t first = 0; first < attributes.size(); first += together)
        fields.push_back(field_of<Field>(attributes, first, elements, rule));
}

template <class Field>
void take_values(const std::vector<Field>& fields, std::vector<io::attribute>& attributes)
{
    for (std::size_t i = 0; i < attributes.size(); ++i) {
        const Field& field = fields[i / together];
        auto& values = attributes[i].values;
        values.resize(field.size());
        for (std::size_t element = 0; element < values.size(); ++element)
            values[element] = io::as_stored(attributes[i].type, field[element][i % together]);
    }
}

std::vector<io::attribute> without_values(const std::vector<io::attribute>& attributes)
{
    std::vector<io::attribute> result;
    for (const auto& a : attributes)
        result.push_back({a.name, a.type, {}, a.labels});
    return result;
}

bool is_normal(const io::attribute& a)
{
    return io::topic_of(a.name, "") == "normals";
}

} // namespace

attribute_fields::attribute_fields(const io::mesh_attributes& attributes, const basic_mesh<>& mesh,
                                   face_varying_linear corners)
{
    append_fields(vertices_, attributes.vertices, mesh.vertex_count(), by_mask{});
    append_fields(corners_, attributes.corners, mesh.corner_count(), face_varying{corners});
    if (attributes.faces.empty())
        return;
    storage<std::uint32_t> parents(mesh.face_count());
    for (std::size_t f = 0; f < parents.size(); ++f)
        parents[f] = std::uint32_t(f + 1);
    parents_ = parent_field(parents);
    control_values values;
    for (const io::attribute& of_faces : attributes.faces)
        values.push_back(of_faces.values);
    of_control_faces_ = std::make_shared<const control_values>(std::move(values));
}

io::mesh_attributes attribute_fields::at_level(const io::mesh_attributes& kinds) const
{
    io::mesh_attributes result = kinds_of(kinds);
    take_values(vertices_, result.vertices);
    take_values(corners_, result.corners);
    for (std::size_t i = 0; i < result.faces.size(); ++i) {
        const double without = kinds.faces[i].labels.empty() ? std::numeric_limits<double>::quiet_NaN() : 0;
        for (const std::uint32_t parent : parents_.values())
            result.faces[i].values.push_back(parent == 0 ? without : (*of_control_faces_)[i][parent - 1]);
    }
    return result;
}

std::pair<attribute_fields::parent_field, attribute_fields::control_values> attribute_fields::faces_here() const
{
    std::vector<std::uint32_t> met(parents_.values().begin(), parents_.values().end());
    met.push_back(0);
    std::ranges::sort(met);
    met.erase(std::unique(met.begin(), met.end()), met.end());
    parent_field parents = parents_;
    for (std::size_t f = 0; f < parents.size(); ++f)
        parents[f] = std::uint32_t(std::ranges::lower_bound(met, parents[f]) - met.begin());
    control_values values(parents.empty() ? 0 : of_control_faces_->size());
    for (std::size_t i = 0; i < values.size(); ++i)
        for (std::size_t m = 1; m < met.size(); ++m)
            values[i].push_back((*of_control_faces_)[i][met[m] - 1]);
    return {std::move(parents), std::move(values)};
}

io::mesh_attributes kinds_of(const io::mesh_attributes& attributes)
{
    return {without_values(attributes.vertices),
            without_values(attributes.faces),
            without_values(attributes.corners),
            attributes.file_lines};
}

attribute_counts count_of(const io::mesh_attributes& attributes, face_varying_linear corners)
{
    return {attributes.vertices.size(),
            attributes.faces.size(),
            attributes.corners.size(),
            corners != face_varying_linear::all};
}

namespace {

/// Returns the number of values that fields carry for so many attributes: a multiple of `together`.
double carried(std::size_t numbers)
{
    return double((numbers + together - 1) / together * together);
}

} // namespace

element_bytes field_bytes(const attribute_counts& attributes)
{
    const bool marked = attributes.along_seams and attributes.corners != 0;
    return {8 * carried(attributes.vertices),
            attributes.faces == 0 ? 0. : 4.,
            8 * carried(attributes.corners) + (marked ? 4 : 0)};
}

element_bytes written_bytes(const attribute_counts& attributes)
{
    return {16. * double(attributes.vertices), 16. * double(attributes.faces), 16. * double(attributes.corners)};
}

double bytes_of(const attribute_counts& attributes, const counts& level)
{
    const auto bytes = [&](std::size_t numbers, std::uint64_t elements) {
        return 8 * (2 * carried(numbers) + double(numbers)) * double(elements);
    };
    // Values of the new vertices, fewer than a third of the corners, and of the old corners, a quarter; and marks.
    const double at_seams = attributes.along_seams and attributes.corners != 0
                                ? (8 * 0.6 * carried(attributes.corners) + 4) * double(level.corners())
                                : 0;
    return bytes(attributes.vertices, level.vertices) + bytes(attributes.corners, level.corners()) + at_seams +
           (attributes.faces == 0 ? 0 : 8 * double(attributes.faces + 1) * double(level.faces));
}

bool take_normals(io::mesh_attributes& attributes)
{
    return std::erase_if(attributes.vertices, is_normal) + std::erase_if(attributes.corners, is_normal) != 0;
}

} // namespace kith::tool
