// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/message.hpp>
#include <kith/core/mesh/basic_mesh.hpp>
#include <kith/face_varying.hpp>
#include <kith/fields/field.hpp>
#include <kith/io/format/mesh_attributes.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

namespace kith {
struct element_bytes;
}

namespace kith::tool {

/// The attributes of a file on a level. They are state of the level, as a field is. Values of vertices follow the masks
/// of the scheme. Values of corners follow a choice of face_varying, with their seams. A face has the values of its
/// parent; a face made at an edge or a vertex has none.
class attribute_fields {
public:
    using numbers = std::array<double, 4>; ///< values of four attributes, which are carried together
    using parent_field = field<field_on::faces, std::uint32_t, from_parent<>>;
    using fields = std::tuple<field<field_on::vertices, numbers, by_mask>,
                              field<field_on::corners, numbers, face_varying>, parent_field>;

    attribute_fields() = default;
    /// Creates the fields of the control mesh. Precondition: a value per element; the values of vertices may continue,
    /// for points without a face.
    attribute_fields(const io::mesh_attributes& attributes, const basic_mesh<>& mesh,
                     face_varying_linear corners = face_varying_linear::all);

    [[nodiscard]] bool empty() const { return vertices_.empty() and corners_.empty() and parents_.empty(); }
    /// Returns the attributes of the next level.
    template <class Step>
    [[nodiscard]] attribute_fields after(const Step& step) const
    {
        return carried([&](const auto& field) { return field.after(step); });
    }
    /// Returns the attributes with `carry` applied to each field.
    template <class Carry>
    [[nodiscard]] attribute_fields carried(const Carry& carry) const
    {
        attribute_fields result;
        for (const auto& field : vertices_)
            result.vertices_.push_back(carry(field));
        for (const auto& field : corners_)
            result.corners_.push_back(carry(field));
        result.parents_ = carry(parents_);
        result.of_control_faces_ = of_control_faces_;
        return result;
    }
    /// Calls f for each field.
    template <class F>
    void for_each_field(const F& f) const
    {
        for (const auto& field : vertices_)
            f(field);
        for (const auto& field : corners_)
            f(field);
        f(parents_);
    }
    /// Returns the attributes of a part of the level.
    template <std::unsigned_integral Index>
    [[nodiscard]] attribute_fields of_part(const part_numbers<Index>& part) const
    {
        return carried([&](const auto& field) { return field.of_part(part); });
    }
    /// Throws mesh_error for fields of another level.
    template <counts_elements Level>
    void require_one_each(const Level& level) const
    {
        for_each_field([&](const auto& field) { field.require_one_each(level); });
    }
    /// Writes the attributes to a message, from which unpack reads them. Of the faces of the control mesh, only the
    /// parents of faces here are included.
    template <message_writer Out>
    void pack(Out& out) const
    {
        const auto [parents, values] = faces_here();
        out.add(vertices_.size()).add(corners_.size()).add(values.size());
        for (const auto& field : vertices_)
            field.pack(out);
        for (const auto& field : corners_) {
            out.add(field.rule().linear);
            field.pack(out);
        }
        parents.pack(out);
        for (const auto& of_faces : values)
            out.add_array(of_faces);
    }
    template <message_reader In>
    void unpack(In& in)
    {
        *this = {};
        const auto vertices = in.template get<std::size_t>(), corners = in.template get<std::size_t>();
        control_values values(in.template get<std::size_t>());
        for (std::size_t i = 0; i < vertices; ++i)
            vertices_.emplace_back().unpack(in);
        for (std::size_t i = 0; i < corners; ++i)
            corners_.emplace_back(face_varying{in.template get<face_varying_linear>()}).unpack(in);
        parents_.unpack(in);
        for (auto& of_faces : values)
            of_faces = in.template get_array<std::vector<double>>();
        of_control_faces_ = std::make_shared<const control_values>(std::move(values));
    }
    /// Returns the attributes of this level; `kinds` are the kinds of the control mesh's attributes (kinds_of).
    [[nodiscard]] io::mesh_attributes at_level(const io::mesh_attributes& kinds) const;

private:
    using control_values = std::vector<std::vector<double>>; ///< on the control faces, for each attribute of faces

    /// Returns the parents and their values, without control faces that are the parent of no face here.
    [[nodiscard]] std::pair<parent_field, control_values> faces_here() const;

    std::vector<field<field_on::vertices, numbers, by_mask>> vertices_;
    std::vector<field<field_on::corners, numbers, face_varying>> corners_;
    parent_field parents_; ///< number of the control face plus 1, or 0 for none
    std::shared_ptr<const control_values> of_control_faces_;
};

/// Returns the attributes without their values.
io::mesh_attributes kinds_of(const io::mesh_attributes& attributes);

/// The number of attributes of vertices, faces and corners, on which the memory depends.
struct attribute_counts {
    std::size_t vertices = 0, faces = 0, corners = 0;
    bool along_seams = false; ///< values of corners are as smooth as the surface

    [[nodiscard]] bool any() const { return vertices != 0 or faces != 0 or corners != 0; }
};
attribute_counts count_of(const io::mesh_attributes& attributes,
                          face_varying_linear corners = face_varying_linear::all);

/// Returns the bytes that attributes need besides a level with these counts, including those of the level before.
double bytes_of(const attribute_counts& attributes, const counts& level);

/// Returns the bytes of the fields of a level, for each vertex, face and corner.
element_bytes field_bytes(const attribute_counts& attributes);
/// Returns the bytes of the values when they are written, as numbers of the program and as those of a file.
element_bytes written_bytes(const attribute_counts& attributes);

/// Removes the normals of the file, which do not follow the masks of a scheme. Returns true if there were any.
bool take_normals(io::mesh_attributes& attributes);

} // namespace kith::tool
