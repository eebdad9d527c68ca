// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/carry_properties.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace kith::in_place {

/// Values on their way from level to level by the rules of `carry_properties`, apart from the mesh that they were read
/// of: what is averaged, at vertices and at corners, and of all else of whom an element has it, plus one.
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

/// The properties of a mesh that is about to be overwritten: read, taken along, written. Those of other types than
/// property_access knows stay where they are, or go.
template <mesh_with_properties M>
class carried_properties {
    using traits = mesh_traits<M>;
    using types = typename property_access<M>::value_types;
    template <class Handle>
    using values_on = kith::detail::property_values<Handle, M>;

public:
    /// Cost: O(elements) per property.
    explicit carried_properties(const M& mesh) : carried_properties(mesh, kith::detail::unset_values<M>(mesh)) {}

    /// To be taken to the last level.
    [[nodiscard]] auto& values() { return values_; }

    /// Precondition: the mesh has the elements of the last level.
    void write(M& mesh) const
    {
        for (std::size_t i = 0; i < values_.vertex_means.size(); ++i)
            at_vertices_.write_mean(mesh, at_vertices_.means()[i], values_.vertex_means[i].values());
        for (std::size_t i = 0; i < values_.corner_means.size(); ++i)
            at_corners_.write_mean(mesh, at_corners_.means()[i], values_.corner_means[i].values());
        at_vertices_.write_heirs(mesh, values_.vertex_heirs.values());
        at_corners_.write_heirs(mesh, values_.corner_heirs.values());
        if (not values_.edge_heirs.empty())
            on_edges_.write_heirs(mesh, values_.edge_heirs.values());
        on_faces_.write_heirs(mesh, values_.face_heirs.values());
    }

private:
    carried_properties(const M& mesh, kith::detail::unset_values<M>&& unset)
        : at_vertices_(mesh, unset, static_cast<types*>(nullptr))
        , at_corners_(mesh, unset, static_cast<types*>(nullptr))
        , on_edges_(mesh, unset, static_cast<types*>(nullptr))
        , on_faces_(mesh, unset, static_cast<types*>(nullptr))
        , values_(at_vertices_, at_corners_, on_edges_, on_faces_)
    {
    }

    values_on<typename traits::vertex> at_vertices_;
    values_on<typename traits::halfedge> at_corners_;
    values_on<typename traits::edge> on_edges_;
    values_on<typename traits::face> on_faces_;
    carried_values<typename property_access<M>::number> values_;
};

/// What a mesh without such properties carries.
class no_properties {
public:
    template <class M>
    explicit no_properties(const M&)
    {
    }
    [[nodiscard]] no_properties& values() { return *this; }
    template <finished_step Step>
    void advance(const Step&, bool) const
    {
    }
    template <class M>
    void write(M&) const
    {
    }
};

template <class M>
struct properties_of {
    using type = no_properties;
};
template <mesh_with_properties M>
struct properties_of<M> {
    using type = carried_properties<M>;
};

} // namespace kith::in_place
