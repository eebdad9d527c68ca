// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/carry_properties.hpp>
#include <kith/fields/values_in_patches.hpp>

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith::in_place {

/// The values that are carried from level to level by the rules of `carry_properties`, stored apart from their mesh.
/// Averaged values, at vertices and at corners, are stored themselves. For all others each element has the number, plus
/// one, of the control-mesh element from which it inherits, or 0 if there is none.
template <class Number>
struct carried_values {
    template <class Vertices, class Corners, class Edges, class Faces>
    carried_values(const Vertices& at_vertices, const Corners& at_corners, const Edges& on_edges, const Faces& on_faces)
        : vertex_heirs(heirs_of(at_vertices))
        , corner_heirs(heirs_of(at_corners))
        , edge_heirs(heirs_of(on_edges))
        , face_heirs(heirs_of(on_faces))
    {
        for (const auto& each : at_vertices.means())
            vertex_means.emplace_back(each.values);
        for (const auto& each : at_corners.means())
            corner_means.emplace_back(each.values);
    }

    /// Takes the values to the next level. If `points_stay`, old vertices keep their averaged values.
    template <finished_step Step>
    void advance(const Step& step, bool points_stay)
    {
        for (auto& each : vertex_means) {
            auto next = each.after(step);
            for (std::size_t v = 0; points_stay and v < each.size(); ++v)
                next[v] = each[v];
            each = std::move(next);
        }
        for (auto& each : corner_means)
            each = each.after(step);
        vertex_heirs = vertex_heirs.after(step);
        corner_heirs = corner_heirs.after(step);
        face_heirs = face_heirs.after(step);
        if constexpr (Step::numbering_type::has_edges)
            edge_heirs = edge_heirs.after(step);
        else
            edge_heirs = {};
    }

#ifdef KITH_HAS_LANES
    /// Returns true if all fields can be carried through several steps of a scheme at once, in patches.
    template <scheme Scheme>
    [[nodiscard]] bool may_go_in_patches() const
    {
        bool result = true;
        for_each_field([&](const auto& each) {
            result = result and
                     (each.empty() or goes_in_patches<std::remove_cvref_t<decltype(each)>, Scheme, std::uint32_t>);
        });
        return result;
    }
    /// Returns true if all fields can be carried in patches from this level on. Precondition: may_go_in_patches().
    template <scheme Scheme>
    [[nodiscard]] bool can_go(const fields_in_patches<std::uint32_t, Scheme>& in_patches) const
    {
        bool result = true;
        for_each_field([&](const auto& each) {
            if constexpr (goes_in_patches<std::remove_cvref_t<decltype(each)>, Scheme, std::uint32_t>)
                result = result and in_patches.can_take(each);
        });
        return result;
    }
    /// Takes the values to the last level, in patches. Precondition: can_go().
    template <scheme Scheme>
    void go(const fields_in_patches<std::uint32_t, Scheme>& in_patches)
    {
        for_each_field([&](auto& each) {
            if constexpr (goes_in_patches<std::remove_cvref_t<decltype(each)>, Scheme, std::uint32_t>)
                each = in_patches.last(each);
        });
    }
#endif

    using coordinates = kith::detail::four_numbers<Number>;
    std::vector<field<field_on::vertices, coordinates, by_mask>> vertex_means;
    std::vector<field<field_on::corners, coordinates, linear_in_faces>> corner_means;
    field<field_on::vertices, std::uint32_t, from_vertex<>> vertex_heirs;
    field<field_on::corners, std::uint32_t, along_sides> corner_heirs;
    field<field_on::edges, std::uint32_t, along_edges<>> edge_heirs;
    field<field_on::faces, std::uint32_t, from_parent<>> face_heirs;

private:
    template <class F>
    void for_each_field(const F& f)
    {
        for_each_field_of(*this, f);
    }
    template <class F>
    void for_each_field(const F& f) const
    {
        for_each_field_of(*this, f);
    }
    template <class Self, class F>
    static void for_each_field_of(Self& self, const F& f)
    {
        for (auto& each : self.vertex_means)
            f(each);
        for (auto& each : self.corner_means)
            f(each);
        f(self.vertex_heirs);
        f(self.corner_heirs);
        f(self.edge_heirs);
        f(self.face_heirs);
    }

    /// Returns the numbers with which elements begin to inherit, or an empty array if nothing is inherited.
    template <class Values>
    static storage<std::uint32_t> heirs_of(const Values& values)
    {
        return values.has_heirs() ? values.own_heirs() : storage<std::uint32_t>();
    }
};

/// The number of no element: an element with this parent inherits nothing.
inline constexpr std::uint32_t no_element = 0xffffffff;

/// Sets the inheritance of elements that were made without a scheme. Element i of `size` inherits what parent_of(i) had
/// before, unless parent_of(i) is no_element.
template <class Heirs, class ParentOf>
void inherit_from(Heirs& heirs, std::size_t size, const ParentOf& parent_of)
{
    if (heirs.empty()) // nothing is inherited
        return;
    storage<std::uint32_t> values(size);
    for (std::size_t i = 0; i < size; ++i)
        if (const std::uint32_t parent = parent_of(i); parent == no_element)
            values[i] = 0;
        else
            values[i] = heirs[parent];
    heirs = Heirs(values);
}

} // namespace kith::in_place
