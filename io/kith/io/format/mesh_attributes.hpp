// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/tiles/output/ply_words.hpp>
#include <kith/tiles/ply/ply_header.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace kith::io {

/// A number on each element of one kind, under a name: "red", "u", "nx", "quality".
struct attribute {
    std::string name;
    ply_number type{8, true, true}; ///< in which a file has the values
    std::vector<double> values;     ///< all types fit into a double; NaN: the element has no value
    std::vector<std::string>
        labels{}; ///< not empty: the values are numbers of these words, the first of which says "none"
};

/// What a file says of the elements of its mesh besides places. Values have the order of the vertices, of the faces,
/// and of the corners face by face. Names that all formats share: red, green, blue, alpha; u, v, w of textures; nx, ny,
/// nz of normals; object, group, material, smoothing group, which are words.
struct mesh_attributes {
    std::vector<attribute> vertices, faces, corners;
    /// That name other files: "mtllib paint.mtl" of OBJ, "TextureFile skin.png" of PLY, as MeshLab writes it. And
    /// odd_generation.
    std::vector<std::string> file_lines;

    [[nodiscard]] bool empty() const
    {
        return vertices.empty() and faces.empty() and corners.empty() and file_lines.empty();
    }
};

/// Takes odd_generation out; returns whether it was there.
bool take_odd_generation(mesh_attributes& attributes);

/// The name by which all formats know an attribute: "u" for "texture_u" and "s", "red" for "diffuse_red".
std::string_view shared_name(std::string_view name);

/// The attribute that has this shared name, or nothing.
const attribute* find(const std::vector<attribute>& attributes, std::string_view shared_name);

/// The attributes of these names in their order, as far as they are there without a gap: u and v, or u, v and w.
std::vector<const attribute*> find_all(const std::vector<attribute>& attributes,
                                       std::span<const std::string_view> shared_names);

inline constexpr std::string_view texture_names[]{"u", "v", "w"};
inline constexpr std::string_view normal_names[]{"nx", "ny", "nz"};
inline constexpr std::string_view color_names[]{"red", "green", "blue", "alpha"};
/// Of faces, which are words.
inline constexpr std::string_view label_names[]{"object", "group", "material", "smoothing group"};

/// Returns what an attribute is about: "normals", "colours", "texture coordinates", "texture numbers", "materials", or
/// "the property 'quality'".
std::string topic_of(std::string_view name);
/// Same as topic_of(name), but names the elements of a property that only its file knows: "the property 'quality' of
/// vertices".
std::string topic_of(std::string_view name, std::string_view elements);

/// The topics of all attributes, each once; colours of faces are told from those of vertices.
std::vector<std::string> topics_of(const mesh_attributes& attributes);

/// Tests whether PLY has 0 where an element lacks the attribute: a colour, a normal or a texture coordinate, which
/// programs read as numbers. In other properties of floating type NaN is a value.
bool is_zero_without_value(const attribute& a);

/// Returns the value of a colour channel that is full in a file of this type: 1, or the largest whole number.
inline double color_unit(const ply_number& type)
{
    return type.floating ? 1 : std::ldexp(1., int(8 * type.bytes) - int(type.is_signed)) - 1;
}

/// The value that a file with this type holds: rounded, and within its range. NaN, which says that there is none,
/// stays.
double as_stored(const ply_number& type, double value);

/// Calls f with a value in its type, among whole numbers with 0 for none. Precondition: as_stored.
template <class F>
void with_type(const ply_number& type, double value, const F& f)
{
    if (not type.floating and std::isnan(value))
        value = 0;
    if (type.floating)
        type.bytes == 4 ? f(float(value)) : f(value);
    else if (type.is_signed)
        type.bytes == 1 ? f(std::int8_t(value)) : type.bytes == 2 ? f(std::int16_t(value)) : f(std::int32_t(value));
    else
        type.bytes == 1 ? f(std::uint8_t(value)) : type.bytes == 2 ? f(std::uint16_t(value)) : f(std::uint32_t(value));
}

} // namespace kith::io
