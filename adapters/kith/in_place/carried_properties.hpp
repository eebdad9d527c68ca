// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/carry_properties.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace kith::in_place {

/// The properties of a mesh that is about to be overwritten: read, taken along from level to level by the rules of
/// `carry_properties`, written. Those of other types than property_access knows stay where they are, or go.
template <class M>
class carried_properties {
    using traits = mesh_traits<M>;
    using types = typename property_access<M>::value_types;
    template <class Handle>
    using values_on = kith::detail::property_values<Handle, M>;
    using coordinates = typename values_on<typename traits::vertex>::coordinates;

public:
    /// Cost: O(elements) per property.
    explicit carried_properties(const M& mesh)
        : at_vertices_(mesh, static_cast<types*>(nullptr))
        , at_corners_(mesh, static_cast<types*>(nullptr))
        , on_edges_(mesh, static_cast<types*>(nullptr))
        , on_faces_(mesh, static_cast<types*>(nullptr))
        , vertex_heirs_(heirs_of(at_vertices_))
        , corner_heirs_(heirs_of(at_corners_))
        , edge_heirs_(heirs_of(on_edges_))
        , face_heirs_(heirs_of(on_faces_))
    {
        for (const auto& each : at_vertices_.means())
            vertex_means_.emplace_back(each.values);
        for (const auto& each : at_corners_.means())
            corner_means_.emplace_back(each.values);
    }

    /// Makes them those of the next level; old vertices that do not move keep what they have.
    template <class Step>
    void advance(const Step& step, bool points_stay)
    {
        for (auto& each : vertex_means_) {
            auto next = each.after(step);
            for (std::size_t v = 0; points_stay and v < each.size(); ++v)
                next[v] = each[v];
            each = std::move(next);
        }
        for (auto& each : corner_means_)
            each = each.after(step);
        vertex_heirs_ = vertex_heirs_.after(step);
        corner_heirs_ = corner_heirs_.after(step);
        face_heirs_ = face_heirs_.after(step);
        if constexpr (Step::numbering_type::has_edges)
            edge_heirs_ = edge_heirs_.after(step);
        else
            edge_heirs_ = {};
    }

    /// Precondition: the mesh has the elements of the last level.
    void write(M& mesh) const
    {
        for (std::size_t i = 0; i < vertex_means_.size(); ++i)
            at_vertices_.write_mean(mesh, at_vertices_.means()[i], vertex_means_[i].values());
        for (std::size_t i = 0; i < corner_means_.size(); ++i)
            at_corners_.write_mean(mesh, at_corners_.means()[i], corner_means_[i].values());
        at_vertices_.write_heirs(mesh, vertex_heirs_.values());
        at_corners_.write_heirs(mesh, corner_heirs_.values());
        if (not edge_heirs_.empty())
            on_edges_.write_heirs(mesh, edge_heirs_.values());
        on_faces_.write_heirs(mesh, face_heirs_.values());
    }

private:
    /// Without numbers where nothing is inherited.
    template <class Values>
    static storage<std::uint32_t> heirs_of(const Values& values)
    {
        return values.has_heirs() ? values.own_heirs() : storage<std::uint32_t>();
    }

    values_on<typename traits::vertex> at_vertices_;
    values_on<typename traits::halfedge> at_corners_;
    values_on<typename traits::edge> on_edges_;
    values_on<typename traits::face> on_faces_;
    std::vector<field<field_on::vertices, coordinates, by_mask>> vertex_means_;
    std::vector<field<field_on::corners, coordinates, linear_in_faces>> corner_means_;
    field<field_on::vertices, std::uint32_t, from_vertex<>> vertex_heirs_;
    field<field_on::corners, std::uint32_t, along_sides> corner_heirs_;
    field<field_on::edges, std::uint32_t, along_edges<>> edge_heirs_;
    field<field_on::faces, std::uint32_t, from_parent<>> face_heirs_;
};

/// What a mesh without such properties carries.
struct no_properties {
    template <class M>
    explicit no_properties(const M&)
    {
    }
    template <class Step>
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
