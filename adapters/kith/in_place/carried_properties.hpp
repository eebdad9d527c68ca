// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "carried_values.hpp"

#include <kith/mesh/connectivity.hpp>

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

namespace kith {

/// Names types of values that kith does not know by itself, for the dialects: properties of these types go by the usual
/// rules, averaged where the type has a mean.
template <class... T>
struct value_types {};

namespace in_place {

/// The places of new elements while a mesh still holds the old ones: behind these, by number. When all values are
/// there they are exchanged with those in the final places.
struct staged_places {
    std::size_t vertices, edges, faces; ///< how many handles the old mesh has
    const std::vector<std::uint32_t>* final_vertices;
    const connectivity<std::uint32_t>* topology;
};

/// The lists of ruled properties that an argument of a dialect asks for.
template <class M, class Argument>
struct ruled_for;
template <class M, class Handle, class T, class Rule>
struct ruled_for<M, property_by_rule<Handle, T, Rule>> {
    using type = std::tuple<ruled_properties<M, Handle, T, Rule>>;
};
template <class M, class... T>
struct ruled_for<M, kith::value_types<T...>> {
    template <class Handle, class Value>
    using own_mean = std::conditional_t<
        kith::detail::has_mean_of_its_own<Value, Handle, M>,
        std::tuple<ruled_properties<M, Handle, Value, decltype(kith::detail::rule_of_means<M, Handle>())>>,
        std::tuple<>>;
    using type = decltype(std::tuple_cat(std::declval<own_mean<typename mesh_traits<M>::vertex, T>>()...,
                                         std::declval<own_mean<typename mesh_traits<M>::halfedge, T>>()...));
};
template <class Number, class Tuple>
struct values_for;
template <class Number>
struct values_for<Number, std::tuple<>> {
    using type = carried_values<Number>; // compiled with the schemes
};
template <class Number, class... Ruled>
struct values_for<Number, std::tuple<Ruled...>> {
    using type = values_with_rules<Number, Ruled...>;
};

/// The properties of a mesh that is about to be overwritten: read, taken along, written. Arguments are by_rule(...) and
/// value_types<T...>().
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
    using values_on = kith::detail::property_values<Handle, M>;
    template <class Handle>
    using places = kith::detail::written_places<Handle>;

    /// The properties on elements of one kind.
    template <class Handle>
    struct kind {
        kind(const M& mesh, kith::detail::unset_values<M>& unset) : known(mesh, unset, static_cast<types*>(nullptr)) {}

        values_on<Handle> known;
        std::vector<kith::detail::any_property> others;
        std::vector<kith::detail::known_property> by_rule;
        std::vector<omission> left_out;
        std::vector<std::unique_ptr<kith::detail::value_exchange>> swaps; ///< of values that wait in staged places
    };

public:
    /// Reads the properties; `joined`, unless empty, says which vertices have a face. Cost: O(elements) per property.
    explicit carried_properties(M& mesh, const std::vector<std::uint32_t>& joined = {}, const Argument&... arguments)
        : carried_properties(mesh, kith::detail::unset_values<M>(mesh), joined, arguments...)
    {
    }

    /// To be taken to the last level.
    [[nodiscard]] values_type& values() { return values_; }
    /// Whether there is anything to write.
    [[nodiscard]] bool empty() const
    {
        const auto is_empty = [](const auto& k) {
            return k.known.found().empty() and k.others.empty() and k.by_rule.empty();
        };
        return is_empty(vertices_) and is_empty(corners_) and is_empty(edges_) and is_empty(faces_);
    }

    /// Writes to a mesh that has the elements of the last level. Values of unknown types are not written.
    void write(M& mesh)
    {
        write_to(mesh,
                 kith::detail::places_in<vertex>(mesh),
                 kith::detail::places_in<halfedge>(mesh),
                 kith::detail::places_in<edge>(mesh),
                 kith::detail::places_in<face>(mesh));
        for_each_kind([](auto& k, bool) {
            for (const auto& each : k.others)
                k.left_out.push_back({each.name, kith::detail::unknown_type});
            k.others.clear();
        });
    }

    /// Writes to staged places, which have the values of new elements. Whatever can fail does so here.
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
        stage_others(mesh, vertices_, behind<vertex>(at.vertices, t.vertices), values_.vertex_heirs);
        stage_others(mesh, corners_, corners, values_.corner_heirs);
        stage_others(mesh, edges_, behind<edge>(at.edges, t.edges()), values_.edge_heirs);
        stage_others(mesh, faces_, behind<face>(at.faces, t.faces), values_.face_heirs);
    }
    /// Exchanges the values in staged places with those in the final ones. Fails only where copies of values of a type
    /// that kith does not know fail in a library that has no other way to exchange them.
    void commit(const staged_places& at) noexcept
    {
        const auto& t = *at.topology;
        exchange(vertices_, t.vertices, [&](std::size_t i) {
            return std::array{std::size_t((*at.final_vertices)[i]), at.vertices + i};
        });
        exchange(corners_, 2 * t.edges(), [&](std::size_t i) { return std::array{i, 2 * at.edges + i}; });
        exchange(edges_, t.edges(), [&](std::size_t i) { return std::array{i, at.edges + i}; });
        exchange(faces_, t.faces, [&](std::size_t i) { return std::array{i, at.faces + i}; });
    }

    /// Which properties were carried; edges inherit if the scheme tells along which they lie.
    [[nodiscard]] property_report report(bool edges_inherit)
    {
        property_report result;
        for_each_kind([&](auto& k, bool is_whole) {
            const bool is_carried = not std::same_as<std::remove_cvref_t<decltype(k)>, kind<edge>> or edges_inherit;
            const auto tell = [&](const std::string& name, bool is_known, const char* why) {
                if (is_known)
                    result.carried.push_back(name);
                else
                    result.left_out.push_back({name, why});
            };
            for (const std::string& name : k.known.known())
                tell(name, is_carried, kith::detail::edges_unknown);
            for (const auto& each : k.by_rule)
                tell(each.name, is_carried, kith::detail::edges_unknown);
            for (const auto& each : k.others)
                tell(each.name,
                     is_carried and is_whole,
                     is_carried ? "kith does not know its type: values stay where an element comes from one alone, "
                                  "others have the default; name the type, value_types<type>()"
                                : kith::detail::edges_unknown);
            result.left_out.insert(result.left_out.end(), k.left_out.begin(), k.left_out.end());
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
        if constexpr (mesh_with_other_properties<M>)
            for_each_kind([&](auto& k, bool) { read_others(mesh, k); });
    }
    template <class Handle, class... T>
    static void read_types(const M& mesh, kith::detail::unset_values<M>& unset, kind<Handle>& k,
                           const kith::value_types<T...>&)
    {
        using more = kith::detail::types_without_own_means<Handle, M, T...>;
        k.known.add(values_on<Handle>::read_here(mesh, unset, static_cast<more*>(nullptr)));
    }
    template <class Handle, class On, class T, class Rule>
    static void read_types(const M&, kith::detail::unset_values<M>&, kind<Handle>&,
                           const property_by_rule<On, T, Rule>&)
    {
    }
    /// Every argument has its lists in `ruled`, in their order.
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
        const auto read = [&](auto& list) {
            using list_type = std::remove_cvref_t<decltype(list)>;
            using handle = typename list_type::handle;
            kind<handle>& k = of<handle>();
            for (const std::string& name : access::template names<handle>(mesh))
                for (auto& found :
                     list.read(mesh, k.known.handles(), unset, name, kith::detail::rule_of_means<M, handle>()))
                    k.by_rule.push_back(std::move(found));
        };
        (read(std::get<First + I>(ruled_)), ...);
    }
    /// Properties of types that nobody named, and names that stand for several.
    template <class Handle>
    static void read_others(M& mesh, kind<Handle>& k)
    {
        std::vector<kith::detail::known_property> known = k.known.found();
        known.insert(known.end(), k.by_rule.begin(), k.by_rule.end());
        k.others = access::template other_properties<Handle>(mesh, known);
        if (not k.others.empty())
            k.known.expect_others();
        std::vector<std::string> names = access::template names<Handle>(mesh);
        std::erase_if(names, access::follows_from_points);
        const auto is_here = [&](const auto& each) {
            if (const auto found = std::ranges::find(names, each.name); found != names.end())
                names.erase(found);
        };
        std::ranges::for_each(known, is_here);
        std::ranges::for_each(k.others, is_here);
        for (std::string& name : names)
            k.left_out.push_back({std::move(name), "another property of these elements has its name; rename one"});
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
        write_means(mesh, vertices_, at_vertices, values_.vertex_means);
        write_means(mesh, corners_, at_corners, values_.corner_means);
        write_heirs(mesh, vertices_, at_vertices, values_.vertex_heirs);
        write_heirs(mesh, corners_, at_corners, values_.corner_heirs);
        write_heirs(mesh, edges_, on_edges, values_.edge_heirs);
        write_heirs(mesh, faces_, on_faces, values_.face_heirs);
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
    template <class Handle, class Means>
    static void write_means(M& mesh, kind<Handle>& k, const places<Handle>& to, const Means& means)
    {
        for (std::size_t i = 0; i < means.size(); ++i)
            k.swaps.push_back(k.known.means()[i].write(mesh, k.known.means()[i], to, means[i].values()));
    }
    /// Elements of schemes that tell nothing inherit nothing.
    template <class Handle, class Heirs>
    static void write_heirs(M& mesh, kind<Handle>& k, const places<Handle>& to, const Heirs& heirs)
    {
        if (not k.known.has_heirs())
            return;
        const storage<std::uint32_t> none(heirs.empty() ? to.elements.size() : 0, 0);
        k.known.write_heirs(mesh,
                            to,
                            heirs.empty() ? std::span<const std::uint32_t>(none.data(), none.size()) : heirs.values(),
                            &k.swaps);
    }
    template <class Handle, class Heirs>
    static void stage_others(const M& mesh, kind<Handle>& k, const places<Handle>& to, const Heirs& heirs)
    {
        for (const auto& each : k.others)
            for (std::size_t i = 0; i < heirs.size(); ++i)
                if (heirs[i] != 0)
                    each.copy(each.array,
                              traits::index(mesh, k.known.handles()[heirs[i] - 1]),
                              traits::index(mesh, to.elements[i]));
    }
    /// In ascending order: a final place may be the staged one of an element before.
    template <class Handle, class PlacesOf>
    static void exchange(kind<Handle>& k, std::size_t size, const PlacesOf& places_of) noexcept
    {
        for (const auto& each : k.others)
            for (std::size_t i = 0; i < size; ++i)
                if (const auto [a, b] = places_of(i); a != b)
                    each.swap(each.array, a, b);
        for (const auto& each : k.swaps)
            for (std::size_t i = 0; i < size; ++i)
                if (const auto [a, b] = places_of(i); a != b)
                    each->swap(a, b);
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
    /// Calls f(kind, whether all its elements inherit by copies).
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

/// The properties of a mesh that has none with names.
class no_properties {
public:
    template <class M, class... Argument>
    explicit no_properties(const M&, const std::vector<std::uint32_t>&, const Argument&...)
    {
        static_assert(sizeof...(Argument) == 0, "this graph has no properties with names; leave out by_rule and types");
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
    [[nodiscard]] static property_report report(bool) { return {}; }
};

template <class M, class... Argument>
struct properties_of {
    using type = no_properties;
};
template <mesh_with_properties M, class... Argument>
struct properties_of<M, Argument...> {
    using type = carried_properties<M, Argument...>;
};

} // namespace in_place

} // namespace kith
