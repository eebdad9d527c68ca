// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/carry_properties.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <tuple>
#include <type_traits>
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

/// The properties of one type that go by a rule of the user, or by the usual one for types with a mean of their own.
template <mesh_with_properties M, class Handle, class T, class Rule>
class ruled_properties {
    static constexpr field_on where = kith::detail::kind_of_handle<M, Handle>;

public:
    using handle = Handle;
    using value_type = T;

    /// Reads a property. Returns what its library knows it by; nothing if it is not there in this type.
    std::vector<kith::detail::known_property> read(const M& mesh, const std::vector<Handle>& handles,
                                                   kith::detail::unset_values<M>& unset, const std::string& name,
                                                   const Rule& rule)
    {
        const auto from = property_access<M>::template find<Handle, T>(mesh, name);
        if (not from)
            return {};
        storage<T> values(handles.size());
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = from[handles[i]];
        all_.push_back({name, field<where, T, Rule>(values, rule), unset.template of<Handle, T>(name)});
        const void* array = nullptr;
        if constexpr (requires { from.array(); })
            array = from.array();
        return {{name, typeid(T), array}};
    }
    /// Takes the values to the next level; old vertices that do not move keep theirs.
    template <finished_step Step>
    void advance(const Step& step, bool points_stay)
    {
        for (one& each : all_) {
            field<where, T, Rule> next(each.values.rule());
            if constexpr (where != field_on::edges or Step::numbering_type::has_edges)
                next = each.values.after(step);
            if constexpr (where == field_on::vertices)
                for (std::size_t v = 0; points_stay and v < each.values.size(); ++v)
                    next[v] = each.values[v];
            each.values = std::move(next);
        }
    }
    [[nodiscard]] bool empty() const { return all_.empty(); }
    /// Writes the values; `swaps` gets how they are exchanged with others.
    void write(M& mesh, const kith::detail::written_places<Handle>& places,
               std::vector<std::unique_ptr<kith::detail::value_exchange>>* swaps) const
    {
        for (const one& each : all_) {
            auto to = kith::detail::add_unset<Handle>(mesh, each.name, each.nothing);
            for (std::size_t i = 0; i < places.elements.size(); ++i)
                to[places.elements[i]] = i < each.values.size() ? each.values[i] : each.nothing;
            kith::detail::store_nothing(to, places.beside_faces, each.nothing);
            if constexpr (mesh_with_other_properties<M>)
                if (swaps != nullptr)
                    swaps->push_back(std::make_unique<kith::detail::value_exchange_in<M, Handle, T, decltype(to)>>(to));
        }
    }

private:
    struct one {
        std::string name;
        field<where, T, Rule> values;
        T nothing;
    };
    std::vector<one> all_;
};

/// Carried values with those that go by rules.
template <class Number, class... Ruled>
struct values_with_rules : carried_values<Number> {
    using carried_values<Number>::carried_values;

    template <finished_step Step>
    void advance(const Step& step, bool points_stay)
    {
        carried_values<Number>::advance(step, points_stay);
        std::apply([&](Ruled&... each) { (each.advance(step, points_stay), ...); }, ruled);
    }

    std::tuple<Ruled...> ruled;
};

} // namespace kith::in_place
