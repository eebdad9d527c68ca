// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "carried_values.hpp"
#include "properties_on.hpp"
#include "property_arguments.hpp"

#include <kith/core/mesh/connectivity.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith::in_place {

/// The properties of a mesh that is about to be overwritten. The class reads them, has the values that the caller
/// carries to the last level, and writes these. Arguments are by_rule(...) and value_types<T...>().
template <mesh_with_properties M, class... Argument>
class carried_properties {
    using traits = mesh_traits<M>;
    using access = property_access<M>;
    using types = typename access::value_types;
    using vertex = typename traits::vertex;
    using halfedge = typename traits::halfedge;
    using edge = typename traits::edge;
    using face = typename traits::face;
    using ruled = decltype(std::tuple_cat(std::declval<typename ruled_for<M, Argument>::type>()...));
    using values_type = typename values_for<typename access::number, ruled>::type;
    template <class Handle>
    using kind = properties_on<Handle, M>;
    template <class Handle>
    using places = kith::detail::written_places<Handle>;

public:
    /// Reads the properties. `joined` has the numbers of the vertices with a face; if it is empty, every vertex has
    /// one. Cost: O(elements) per property.
    explicit carried_properties(M& mesh, const std::vector<std::uint32_t>& joined = {}, const Argument&... arguments)
        : carried_properties(mesh, kith::detail::unset_values<M>(mesh), joined, arguments...)
    {
    }

    /// Returns the values, which the caller carries to the last level.
    [[nodiscard]] values_type& values() { return values_; }
    /// Returns true if there is nothing to write.
    [[nodiscard]] bool empty() const
    {
        return vertices_.empty() and corners_.empty() and edges_.empty() and faces_.empty();
    }

    /// Writes to a mesh that has the elements of the last level; `vertices` are its vertices in the order of that
    /// level.
    void write(M& mesh, const std::vector<vertex>& vertices)
    {
        write_to(mesh,
                 {vertices, {}},
                 kith::detail::places_in<halfedge>(mesh),
                 kith::detail::places_in<edge>(mesh),
                 kith::detail::places_in<face>(mesh));
    }

    /// Writes to the staged places, which have the values of new elements. Everything that can fail does so here,
    /// except the copies that commit() names.
    void stage(M& mesh, const staged_places& at)
    {
        const auto& t = *at.topology;
        places<halfedge> corners{std::vector<halfedge>(t.corners()), {}};
        for (std::size_t f = 0; f < t.faces; ++f) {
            const std::size_t first = t.first_corner(f), end = t.first_corner(f + 1);
            for (std::size_t c = first; c < end; ++c) // a half-edge stands for the corner at its target
                corners.elements[c] = traits::template at<halfedge>(2 * at.edges +
                                                                    t.corner_halfedge[c == first ? end - 1 : c - 1]);
        }
        for (std::size_t h = 0; h < 2 * t.edges(); ++h)
            if (t.halfedge_corner[h] == t.none)
                corners.beside_faces.push_back(traits::template at<halfedge>(2 * at.edges + h));
        write_to(mesh,
                 behind<vertex>(at.vertices, t.vertices),
                 corners,
                 behind<edge>(at.edges, t.edges()),
                 behind<face>(at.faces, t.faces));
        vertices_.stage_others(mesh, behind<vertex>(at.vertices, t.vertices), values_.vertex_heirs);
        corners_.stage_others(mesh, corners, values_.corner_heirs);
        edges_.stage_others(mesh, behind<edge>(at.edges, t.edges()), values_.edge_heirs);
        faces_.stage_others(mesh, behind<face>(at.faces, t.faces), values_.face_heirs);
    }
    /// Exchanges the values in staged places with those in the final ones. Fails only if a copy of a value of an
    /// unnamed type fails, in a library that exchanges these by copies. All values are then exchanged back.
    void commit(const staged_places& at)
    {
        try {
            for_each_kind_at(at, [](auto& k, std::size_t size, const auto& of) { k.exchange_others(size, of); });
        } catch (...) {
            for_each_kind_at(at, [](auto& k, std::size_t size, const auto& of) { k.exchange_others_back(size, of); });
            throw;
        }
        for_each_kind_at(at, [](auto& k, std::size_t size, const auto& of) { k.exchange(size, of); });
    }

    /// Returns which properties were carried. Edges inherit only if the scheme tells along which old edges they lie.
    [[nodiscard]] property_report report(bool edges_inherit)
    {
        property_report result;
        for_each_kind([&](auto& k, bool is_whole) {
            k.tell(result, not std::same_as<std::remove_cvref_t<decltype(k)>, kind<edge>> or edges_inherit, is_whole);
        });
        return result;
    }

private:
    carried_properties(M& mesh, kith::detail::unset_values<M>&& unset, const std::vector<std::uint32_t>& joined,
                       const Argument&... arguments)
        : vertices_(mesh, unset)
        , corners_(mesh, unset)
        , edges_(mesh, unset)
        , faces_(mesh, unset)
        , values_((read_more(mesh, unset, joined, arguments...), vertices_.known), corners_.known, edges_.known,
                  faces_.known)
    {
        if constexpr (std::tuple_size_v<ruled> != 0)
            values_.ruled = std::move(ruled_);
    }

    void read_more(M& mesh, kith::detail::unset_values<M>& unset, const std::vector<std::uint32_t>& joined,
                   const Argument&... arguments)
    {
        for_each_kind([&](auto& k, bool) { (read_types(mesh, unset, k, arguments), ...); });
        if (not joined.empty())
            vertices_.known.keep(joined);
        constexpr auto all = std::make_index_sequence<sizeof...(Argument)>();
        read_rules(mesh, unset, all, arguments...);
        for_each_kind([&](auto& k, bool) { k.read_others(mesh); });
    }
    template <class Handle, class... T>
    static void read_types(const M& mesh, kith::detail::unset_values<M>& unset, kind<Handle>& k,
                           const kith::value_types<T...>&)
    {
        using more = kith::detail::types_without_own_means<Handle, M, T...>;
        k.known.add(kith::detail::property_values<Handle, M>(mesh, unset, static_cast<more*>(nullptr)));
    }
    template <class Handle, class On, class T, class Rule>
    static void read_types(const M&, kith::detail::unset_values<M>&, kind<Handle>&,
                           const property_by_rule<On, T, Rule>&)
    {
    }
    /// Reads the properties that each argument names into its lists in `ruled`, which have the order of the arguments.
    template <std::size_t... I>
    void read_rules(M& mesh, kith::detail::unset_values<M>& unset, std::index_sequence<I...>,
                    const Argument&... arguments)
    {
        [[maybe_unused]] const auto args = std::tie(arguments...);
        [[maybe_unused]] static constexpr std::array<std::size_t, sizeof...(Argument) + 1> sizes{
            std::tuple_size_v<typename ruled_for<M, Argument>::type>..., 0};
        (read_rule(
             mesh,
             unset,
             std::get<I>(args),
             std::integral_constant<std::size_t, std::accumulate(sizes.begin(), sizes.begin() + I, std::size_t(0))>(),
             std::make_index_sequence<sizes[I]>()),
         ...);
    }
    template <class Handle, class T, class Rule, std::size_t First, std::size_t... I>
    void read_rule(M& mesh, kith::detail::unset_values<M>& unset, const property_by_rule<Handle, T, Rule>& each,
                   std::integral_constant<std::size_t, First>, std::index_sequence<I...>)
    {
        kind<Handle>& k = of<Handle>();
        if (k.has_rule(each.name, typeid(T)))
            return; // the first rule counts
        auto found = std::get<First>(ruled_).read(mesh, k.known.handles(), unset, each.name, each.rule);
        if (found.empty()) {
            const auto names = access::template names<Handle>(mesh);
            const bool is_there = std::ranges::find(names, each.name) != names.end();
            k.left_out.push_back({each.name, is_there ? kith::detail::other_type : kith::detail::absent});
        } else {
            k.known.leave_out(each.name, typeid(T));
            k.by_rule.push_back(std::move(found.front()));
        }
    }
    template <class... T, std::size_t First, std::size_t... I>
    void read_rule(M& mesh, kith::detail::unset_values<M>& unset, const kith::value_types<T...>&,
                   std::integral_constant<std::size_t, First>, std::index_sequence<I...>)
    {
        [[maybe_unused]] const auto read = [&](auto& list) {
            using list_type = std::remove_cvref_t<decltype(list)>;
            using handle = typename list_type::handle;
            kind<handle>& k = of<handle>();
            for (const std::string& name : access::template names<handle>(mesh))
                if (not k.has_rule(name, typeid(typename list_type::value_type)))
                    for (auto& found :
                         list.read(mesh, k.known.handles(), unset, name, kith::detail::rule_of_means<M, handle>()))
                        k.by_rule.push_back(std::move(found));
        };
        (read(std::get<First + I>(ruled_)), ...);
    }
    template <class Handle>
    static places<Handle> behind(std::size_t bound, std::size_t size)
    {
        places<Handle> result;
        result.elements.reserve(size);
        for (std::size_t i = 0; i < size; ++i)
            result.elements.push_back(traits::template at<Handle>(bound + i));
        return result;
    }
    void write_to(M& mesh, const places<vertex>& at_vertices, const places<halfedge>& at_corners,
                  const places<edge>& on_edges, const places<face>& on_faces)
    {
        vertices_.write_means(mesh, at_vertices, values_.vertex_means);
        corners_.write_means(mesh, at_corners, values_.corner_means);
        vertices_.write_heirs(mesh, at_vertices, values_.vertex_heirs);
        corners_.write_heirs(mesh, at_corners, values_.corner_heirs);
        edges_.write_heirs(mesh, on_edges, values_.edge_heirs);
        faces_.write_heirs(mesh, on_faces, values_.face_heirs);
        if constexpr (std::tuple_size_v<ruled> != 0)
            std::apply(
                [&](const auto&... each) {
                    const auto write = [&](const auto& list) {
                        using handle = typename std::remove_cvref_t<decltype(list)>::handle;
                        if constexpr (std::same_as<handle, vertex>)
                            list.write(mesh, at_vertices, &vertices_.swaps);
                        else if constexpr (std::same_as<handle, halfedge>)
                            list.write(mesh, at_corners, &corners_.swaps);
                        else if constexpr (std::same_as<handle, edge>)
                            list.write(mesh, on_edges, &edges_.swaps);
                        else
                            list.write(mesh, on_faces, &faces_.swaps);
                    };
                    (write(each), ...);
                },
                values_.ruled);
    }
    template <class Handle>
    kind<Handle>& of()
    {
        if constexpr (std::same_as<Handle, vertex>)
            return vertices_;
        else if constexpr (std::same_as<Handle, halfedge>)
            return corners_;
        else if constexpr (std::same_as<Handle, edge>)
            return edges_;
        else
            return faces_;
    }
    /// Calls f(properties on one kind of elements, number of elements, places). places(i) returns the final and the
    /// staged place of element i.
    template <class F>
    void for_each_kind_at(const staged_places& at, const F& f)
    {
        const auto& t = *at.topology;
        f(vertices_, t.vertices, [&at](std::size_t i) {
            return std::array{std::size_t((*at.final_vertices)[i]), at.vertices + i};
        });
        f(corners_, 2 * t.edges(), [&at](std::size_t i) { return std::array{i, 2 * at.edges + i}; });
        f(edges_, t.edges(), [&at](std::size_t i) { return std::array{i, at.edges + i}; });
        f(faces_, t.faces, [&at](std::size_t i) { return std::array{i, at.faces + i}; });
    }
    /// Calls f(properties on one kind of elements, is_whole); is_whole is true if all these elements inherit by copies.
    template <class F>
    void for_each_kind(const F& f)
    {
        f(vertices_, false);
        f(corners_, false);
        f(edges_, true);
        f(faces_, true);
    }

    ruled ruled_;
    kind<vertex> vertices_;
    kind<halfedge> corners_;
    kind<edge> edges_;
    kind<face> faces_;
    values_type values_;
};

} // namespace kith::in_place
