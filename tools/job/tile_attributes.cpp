// SPDX-License-Identifier: BSD-3-Clause
#include "tile_attributes.hpp"

#include <kith/io/format/held_attributes.hpp>
#include <kith/io/format/mesh_format.hpp>

#include <cmath>
#include <cstring>
#include <string>

namespace kith::tool {

namespace {

using attribute_list = std::vector<const io::attribute*>;

attribute_list all_of(const std::vector<io::attribute>& attributes)
{
    attribute_list result;
    for (const io::attribute& a : attributes)
        result.push_back(&a);
    return result;
}

file_array array_of(const io::attribute& a, field_on where, std::size_t numbers)
{
    const std::string word = a.type.floating ? "Float" : a.type.is_signed ? "Int" : "UInt";
    return {a.name, where, word + std::to_string(8 * a.type.bytes), numbers, numbers * a.type.bytes, a.labels};
}

/// Returns the bytes of these attributes: for each element its values, one after the other.
std::vector<std::byte> bytes_of(const attribute_list& attributes, bool is_ply)
{
    std::vector<std::byte> result;
    std::size_t size = 0;
    bool is_zero_without_value = is_ply;
    for (const io::attribute* a : attributes) {
        size += a->type.bytes;
        is_zero_without_value &= io::is_zero_without_value(*a);
    }
    const std::size_t elements = attributes.front()->values.size();
    result.resize(size * elements);
    std::byte* to = result.data();
    for (std::size_t element = 0; element < elements; ++element)
        for (const io::attribute* a : attributes) {
            const double value = a->values[element];
            io::with_type(a->type, is_zero_without_value and std::isnan(value) ? 0 : value, [&](auto number) {
                std::memcpy(to, &number, sizeof number);
                to += sizeof number;
            });
        }
    return result;
}

/// Returns the attributes of each array, in the order of the arrays.
std::vector<attribute_list> lists_of(const io::mesh_attributes& attributes)
{
    std::vector<attribute_list> result;
    for (const auto* elements : {&attributes.vertices, &attributes.faces})
        for (const io::attribute* a : all_of(*elements))
            result.push_back({a});
    if (not attributes.corners.empty())
        result.push_back(held_by(io::mesh_format::ply, attributes).corner_textures);
    return result;
}

} // namespace

tile_attributes::tile_attributes(const tile_request& request)
    : kinds_(request.kinds), is_ply_(io::extension_of(request.output) == ".ply")
{
    const io::mesh_attributes& kinds = kinds_;
    for (const io::attribute& a : kinds.vertices)
        arrays_.push_back(array_of(a, field_on::vertices, 1));
    for (const io::attribute& a : kinds.faces)
        arrays_.push_back(array_of(a, field_on::faces, 1));
    if (not kinds.corners.empty()) {
        io::attribute coordinates = kinds.corners.front();
        coordinates.name = "texcoord";
        arrays_.push_back(array_of(coordinates, field_on::corners, kinds.corners.size()));
    }
}

tile_attributes::values tile_attributes::values_of(const attribute_fields& fields) const
{
    const io::mesh_attributes here = fields.at_level(kinds_);
    values result;
    for (const attribute_list& list : lists_of(here))
        result.push_back(bytes_of(list, is_ply_));
    return result;
}

} // namespace kith::tool
