// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/carry_properties.hpp>
#include <kith/field/values_in_patches.hpp>

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace kith::in_place {

/// Values that go from level to level by the rules of `carry_properties`, apart from their mesh: those that are
/// averaged, at vertices and at corners. For all others it has the number, plus one, of the element of the control mesh
/// from which each element inherits; 0 where there is none.
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

    /// Makes them those of the next level; old vertices that do not move keep what they have.
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
    /// Returns true if all of them can go through several steps of a scheme at once.
    template <scheme Scheme>
    [[nodiscard]] bool goes_in_patches() const
    {
        constexpr bool with_labels = go_in_patches<std::tuple<decltype(face_heirs)>, Scheme, std::uint32_t>;
        return corner_means.empty() and corner_heirs.empty() and vertex_heirs.empty() and edge_heirs.empty() and
               (with_labels or face_heirs.empty());
    }
    /// Makes them those of the last level of a plan; see `after_patches`. Precondition: goes_in_patches().
    template <scheme Scheme>
    void advance_in_patches(const connectivity<std::uint32_t>& level, int generation, const Scheme& scheme,
                            const patch_plan& plan)
    {
        for (auto& each : vertex_means)
            each = after_patches(each, level, generation, scheme, plan);
        if constexpr (go_in_patches<std::tuple<decltype(face_heirs)>, Scheme, std::uint32_t>)
            face_heirs = after_patches(face_heirs, level, generation, scheme, plan);
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
    /// Without numbers where nothing is inherited.
    template <class Values>
    static storage<std::uint32_t> heirs_of(const Values& values)
    {
        return values.has_heirs() ? values.own_heirs() : storage<std::uint32_t>();
    }
};

/// No element, as the one from which another inherits.
inline constexpr std::uint32_t no_element = 0xffffffff;

/// Lets elements inherit that were made without a scheme: element i of `size` has what parent_of(i) had before, if that
/// is an element.
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
