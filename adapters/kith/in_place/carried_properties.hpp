// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/carry_properties.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace kith::in_place {

/// The properties of a mesh that is about to be overwritten: read, taken along from level to level by the rules of
/// `carry_properties`, written. Those of other types than property_access knows stay where they are, or go.
template <class M>
class carried_properties {
    using traits = mesh_traits<M>;
    using access = property_access<M>;
    using number = typename access::number;
    using coordinates = detail::four_numbers<number>;

public:
    /// Cost: O(elements) per property.
    explicit carried_properties(const M& mesh)
    {
        read(typename traits::vertex(), at_vertices_, vertex_heirs_, mesh);
        read(typename traits::halfedge(), at_corners_, nobody_, mesh);
        read(typename traits::edge(), none_, edge_heirs_, mesh);
        read(typename traits::face(), none_, face_heirs_, mesh);
    }

    /// Makes them those of the next level; old vertices that do not move keep what they have.
    template <class Step>
    void advance(const Step& step, bool points_stay)
    {
        for (auto& each : at_vertices_) {
            auto next = each.values.after(step);
            for (std::size_t v = 0; points_stay and v < each.values.size(); ++v)
                next[v] = each.values[v];
            each.values = std::move(next);
        }
        for (auto& each : at_corners_)
            each.values = each.values.after(step);
        vertex_heirs_.numbers = vertex_heirs_.numbers.after(step);
        face_heirs_.numbers = face_heirs_.numbers.after(step);
        if constexpr (Step::numbering_type::has_edges)
            edge_heirs_.numbers = edge_heirs_.numbers.after(step);
        else
            edge_heirs_ = {};
    }

    /// Precondition: the mesh has the elements of the last level.
    void write(M& mesh) const
    {
        for (const auto& each : at_vertices_)
            each.write(mesh, each.values.values());
        for (const auto& each : at_corners_)
            each.write(mesh, each.values.values());
        vertex_heirs_.write_all(mesh);
        edge_heirs_.write_all(mesh);
        face_heirs_.write_all(mesh);
    }

private:
    template <field_on Where, class Rule>
    struct averaged {
        field<Where, coordinates, Rule> values;
        std::function<void(M&, std::span<const coordinates>)> write;
    };
    /// One more than the number of the element that each has everything from, 0 for those that have T().
    template <field_on Where, class Rule>
    struct inherited {
        field<Where, std::uint32_t, Rule> numbers;
        std::vector<std::function<void(M&, std::span<const std::uint32_t>)>> write;

        void write_all(M& mesh) const
        {
            for (const auto& each : write)
                each(mesh, numbers.values());
        }
    };
    struct nothing {};

    template <class Handle, class Averaged, class Inherited>
    void read(Handle, Averaged& means, Inherited& heirs, const M& mesh)
    {
        std::vector<Handle> handles;
        detail::for_each_handle<Handle>(mesh, [&](Handle x) { handles.push_back(x); });
        const auto read_as = [&]<class... T>(std::tuple<T...>*, const std::string& name) {
            static_cast<void>((read_one<T>(name, handles, means, heirs, mesh) or ...));
        };
        for (const std::string& name : access::template names<Handle>(mesh))
            if (not access::follows_from_points(name))
                read_as(static_cast<typename access::value_types*>(nullptr), name);
    }
    template <class T, class Handle, class Averaged, class Inherited>
    bool read_one(const std::string& name, const std::vector<Handle>& handles, Averaged& means, Inherited& heirs,
                  const M& mesh)
    {
        constexpr bool averages = not std::same_as<Averaged, nothing> and detail::can_be_averaged<T>;
        if constexpr (not averages and std::same_as<Inherited, nothing>) {
            return false;
        } else {
            const auto from = access::template find<Handle, T>(mesh, name);
            if (not from)
                return false;
            if constexpr (averages)
                means.push_back({read_means<T>(*from, handles, means), write_means<Handle, T>(name)});
            else
                read_heirs<T>(name, *from, handles, heirs);
            return true;
        }
    }
    template <class T, class From, class Handle, class Averaged>
    static auto read_means(const From& from, const std::vector<Handle>& handles, const Averaged&)
    {
        storage<coordinates> values(handles.size());
        for (std::size_t i = 0; i < handles.size(); ++i)
            values[i] = averaged_value<T>::template load<number>(from[handles[i]]);
        return decltype(std::declval<typename Averaged::value_type>().values)(values);
    }
    template <class Handle, class T>
    static auto write_means(const std::string& name)
    {
        return [name](M& mesh, std::span<const coordinates> values) {
            auto to = access::template add<Handle, T>(mesh, name);
            std::size_t i = 0;
            detail::for_each_handle<Handle>(
                mesh, [&](Handle x) { to[x] = averaged_value<T>::template store<number>(values[i++]); });
        };
    }
    template <class T, class From, class Handle, class Inherited>
    static void read_heirs(const std::string& name, const From& from, const std::vector<Handle>& handles,
                           Inherited& heirs)
    {
        std::vector<T> values;
        values.reserve(handles.size());
        for (const Handle x : handles)
            values.push_back(from[x]);
        if (heirs.numbers.empty()) {
            storage<std::uint32_t> numbers(handles.size());
            for (std::size_t i = 0; i < numbers.size(); ++i)
                numbers[i] = std::uint32_t(i + 1);
            heirs.numbers = decltype(heirs.numbers)(numbers);
        }
        heirs.write.push_back([name, values = std::move(values)](M& mesh, std::span<const std::uint32_t> numbers) {
            auto to = access::template add<Handle, T>(mesh, name);
            std::size_t i = 0;
            detail::for_each_handle<Handle>(mesh, [&](Handle x) {
                const std::uint32_t heir = numbers[i++];
                to[x] = heir == 0 ? detail::value_of_nothing<T>() : T(values[heir - 1]);
            });
        });
    }

    std::vector<averaged<field_on::vertices, by_mask>> at_vertices_;
    std::vector<averaged<field_on::corners, linear_in_faces>> at_corners_;
    inherited<field_on::vertices, from_vertex<>> vertex_heirs_;
    inherited<field_on::edges, along_edges<>> edge_heirs_;
    inherited<field_on::faces, from_parent<>> face_heirs_;
    nothing none_, nobody_;
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
