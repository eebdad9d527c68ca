// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/face_varying.hpp>
#include <kith/field/field.hpp>
#include <kith/format/mesh_attributes.hpp>
#include <kith/mesh/basic_mesh.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace kith::tool {

/// The attributes of a file on their way through the levels: state of a level, as a field is. Numbers on vertices go by the
/// masks of the scheme, numbers on corners go by a choice of face_varying, with their seams, and a face has what its parent has; one
/// that is born by an edge or a vertex has nothing.
class attribute_fields {
public:
    attribute_fields() = default;
    /// Precondition: a value per element; those of vertices may go on, for points without a face.
    attribute_fields(const io::mesh_attributes& attributes, const basic_mesh<>& mesh,
                     face_varying_linear corners = face_varying_linear::all);

    [[nodiscard]] bool empty() const { return vertices_.empty() and corners_.empty() and parents_.empty(); }
    /// Those of the next level.
    template <class Step>
    [[nodiscard]] attribute_fields after(const Step& step) const
    {
        return carried([&](const auto& field) { return field.after(step); });
    }
    /// With each field what `carry` makes of it.
    template <class Carry>
    [[nodiscard]] attribute_fields carried(const Carry& carry) const
    {
        attribute_fields result;
        for (const auto& field : vertices_)
            result.vertices_.push_back(carry(field));
        for (const auto& field : corners_)
            result.corners_.push_back(carry(field));
        result.parents_ = carry(parents_);
        return result;
    }
    /// The attributes of this level, in the types of those of the control mesh.
    [[nodiscard]] io::mesh_attributes at_level(const io::mesh_attributes& control) const;

private:
    using numbers = std::array<double, 4>; ///< of as many attributes, which are carried together

    std::vector<field<field_on::vertices, numbers, by_mask>> vertices_;
    std::vector<field<field_on::corners, numbers, face_varying>> corners_;
    field<field_on::faces, std::uint32_t, from_parent<>> parents_; ///< one more than the control face, 0: none
};

/// How many numbers the elements have, for the memory that they need.
struct attribute_counts {
    std::size_t vertices = 0, faces = 0, corners = 0;
    bool along_seams = false; ///< those of corners go as smoothly as the surface
};
attribute_counts count_of(const io::mesh_attributes& attributes,
                          face_varying_linear corners = face_varying_linear::all);

/// The bytes that these need beside a level with so many elements, with those of the level before.
double bytes_of(const attribute_counts& attributes, const counts& level);

/// Takes the normals of the file out, which do not go by the masks of a scheme. Whether there were any.
bool take_normals(io::mesh_attributes& attributes);

} // namespace kith::tool
