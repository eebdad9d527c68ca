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
    ply_number type{8, true, true}; ///< the type of the values in a file
    std::vector<double> values;     ///< doubles hold all types; NaN: the element has no value
    std::vector<std::string>
        labels{}; ///< if not empty, values are numbers of these words, and the first word is for "none"
};

/// The attributes of the elements of a mesh, beside the places, as a file has them. Values have the order of the
/// vertices, of the faces, and of the corners face by face. All formats share these names: red, green, blue, alpha; u,
/// v, w of textures; nx, ny, nz of normals; and the words object, group, material, smoothing group.
struct mesh_attributes {
    std::vector<attribute> vertices, faces, corners;
    /// The lines that name other files: "mtllib paint.mtl" of OBJ, "TextureFile skin.png" of PLY, as MeshLab writes it.
    /// Also odd_generation.
    std::vector<std::string> file_lines;

    [[nodiscard]] bool empty() const
    {
        return vertices.empty() and faces.empty() and corners.empty() and file_lines.empty();
    }
};

/// Removes odd_generation from the file lines. Returns true if it was there.
bool take_odd_generation(mesh_attributes& attributes);

/// Returns the name by which all formats know an attribute: "u" for "texture_u" and "s", "red" for "diffuse_red".
std::string_view shared_name(std::string_view name);

/// Returns the attribute with this shared name, or null.
const attribute* find(const std::vector<attribute>& attributes, std::string_view shared_name);

/// Returns the attributes of these names in their order, up to the first name that is missing: u and v, or u, v and w.
std::vector<const attribute*> find_all(const std::vector<attribute>& attributes,
                                       std::span<const std::string_view> shared_names);

inline constexpr std::string_view texture_names[]{"u", "v", "w"};
inline constexpr std::string_view normal_names[]{"nx", "ny", "nz"};
inline constexpr std::string_view color_names[]{"red", "green", "blue", "alpha"};
/// The names of attributes of faces whose values are words.
inline constexpr std::string_view label_names[]{"object", "group", "material", "smoothing group"};

/// Returns the topic of an attribute: "normals", "colours", "texture coordinates", "texture numbers", "materials", or
/// "the property 'quality'".
std::string topic_of(std::string_view name);
/// Returns the same as topic_of(name), but adds the elements to a property that only its file knows: "the property
/// 'quality' of vertices".
std::string topic_of(std::string_view name, std::string_view elements);

/// Returns the topics of all attributes, each once. Colours of faces and of vertices are two topics.
std::vector<std::string> topics_of(const mesh_attributes& attributes);

/// Returns true if PLY has 0 where an element lacks the attribute: a colour, a normal or a texture coordinate, which
/// programs read as numbers. In other properties of floating type NaN is a value.
bool is_zero_without_value(const attribute& a);

/// Returns the value of a full colour channel in a file of this type: 1, or the largest whole number.
inline double color_unit(const ply_number& type)
{
    return type.floating ? 1 : std::ldexp(1., int(8 * type.bytes) - int(type.is_signed)) - 1;
}

/// Returns the value that a file with this type holds: rounded, and within its range. NaN, which means that there is no
/// value, stays.
double as_stored(const ply_number& type, double value);

/// Calls f with a value in its type. NaN becomes 0 in types of whole numbers. Precondition: the value is as as_stored
/// returns it.
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
