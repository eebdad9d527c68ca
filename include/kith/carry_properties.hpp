// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hierarchy.hpp"

#include <kith/field/field.hpp>
#include <kith/property/map_value.hpp>
#include <kith/property/property_access.hpp>
#include <kith/property/property_values.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith {

namespace detail {

/// The rule by which values of type T go that lie on elements with such handles, unless another is asked for.
template <mesh M, class Handle, class T>
auto usual_rule()
{
    using traits = mesh_traits<M>;
    if constexpr (std::same_as<Handle, typename traits::vertex>) {
        if constexpr (affine_value<T>)
            return by_mask();
        else
            return from_vertex();
    } else if constexpr (std::same_as<Handle, typename traits::edge>) {
        return along_edges();
    } else if constexpr (std::same_as<Handle, typename traits::face>) {
        return from_parent();
    } else if constexpr (affine_value<T>) {
        return linear_in_faces();
    } else {
        return along_sides();
    }
}
template <mesh M, class Handle>
inline constexpr field_on kind_of_handle = std::same_as<Handle, typename mesh_traits<M>::vertex> ? field_on::vertices
                                           : std::same_as<Handle, typename mesh_traits<M>::edge> ? field_on::edges
                                           : std::same_as<Handle, typename mesh_traits<M>::face> ? field_on::faces
                                                                                                 : field_on::corners;

} // namespace detail

/// Gives a map the values at the elements of level `to` with such handles that follow from those of another map at
/// level `from`, by a rule of fields; the usual one is that of carry_properties. A half-edge stands for the corner at
/// its target. Maps are property maps, of any kind and type, or what takes handles in brackets, such as CGAL's dynamic
/// maps and OpenMesh's property managers; to read, a function is as good. Errors and cost: those of hierarchy::carry.
template <class Handle, mesh M, scheme Scheme, class Source, class Target,
          class Rule = decltype(detail::usual_rule<M, Handle, typename detail::map_value_type<Source, Handle>::type>())>
void carry_map(const hierarchy<M, Scheme>& levels, int from, int to, const Source& source, Target&& target,
               const Rule& rule = {})
{
    using value = typename detail::map_value_type<Source, Handle>::type;
    const auto handles = detail::handles_of<Handle>(levels[from]),
               fine_handles = detail::handles_of<Handle>(levels[to]);
    storage<value> values(handles.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = detail::map_value(source, handles[i]);
    const auto fine = levels.carry(from, to, field<detail::kind_of_handle<M, Handle>, value, Rule>(values, rule));
    for (std::size_t i = 0; i < fine_handles.size(); ++i)
        detail::put_value(target, fine_handles[i], fine[i]);
}

/// A property that goes by a rule of the user, on elements with such handles and of type T, which may be any.
template <class Handle, class T, class Rule>
struct property_by_rule {
    std::string name;
    Rule rule;
};
template <class Handle, class T, class Rule>
property_by_rule<Handle, T, Rule> by_rule(std::string name, Rule rule)
{
    return {std::move(name), std::move(rule)};
}

/// What has become of the properties of a mesh, by their names.
struct property_report {
    std::vector<std::string> carried;
    std::vector<std::string> left_out; ///< of a type that is not known, or normals; what by_rule names and is not there
};

namespace detail {

template <mesh M, scheme Scheme>
void carry_values(const hierarchy<M, Scheme>& levels, int from, int to, M& fine,
                  const property_values<typename mesh_traits<M>::vertex, M>& at_vertices)
{
    for (const auto& each : at_vertices.means())
        at_vertices.write_mean(fine, each, levels.carry(from, to, on_vertices(each.values, by_mask())).values());
    if (at_vertices.has_heirs())
        at_vertices.write_heirs(fine,
                                levels.carry(from, to, on_vertices(at_vertices.own_heirs(), from_vertex())).values());
}
template <mesh M, scheme Scheme>
void carry_values(const hierarchy<M, Scheme>& levels, int from, int to, M& fine,
                  const property_values<typename mesh_traits<M>::halfedge, M>& at_corners)
{
    for (const auto& each : at_corners.means())
        at_corners.write_mean(fine, each, levels.carry(from, to, on_corners(each.values)).values());
    if (at_corners.has_heirs())
        at_corners.write_heirs(fine,
                               levels.carry(from, to, on_corners(at_corners.own_heirs(), along_sides())).values());
}
template <mesh M, scheme Scheme>
void carry_values(const hierarchy<M, Scheme>& levels, int from, int to, M& fine,
                  const property_values<typename mesh_traits<M>::edge, M>& on_all_edges)
{
    if (on_all_edges.has_heirs())
        on_all_edges.write_heirs(fine, levels.carry(from, to, on_edges(on_all_edges.own_heirs())).values());
}
template <mesh M, scheme Scheme>
void carry_values(const hierarchy<M, Scheme>& levels, int from, int to, M& fine,
                  const property_values<typename mesh_traits<M>::face, M>& on_all_faces)
{
    if (on_all_faces.has_heirs())
        on_all_faces.write_heirs(fine, levels.carry(from, to, on_faces(on_all_faces.own_heirs())).values());
}

/// Carries a property by a rule; returns whether there is one of this name and type.
template <class Handle, class T, class Rule, mesh M, scheme Scheme>
bool carry_property(const hierarchy<M, Scheme>& levels, int from, int to, M& fine, const std::string& name,
                    const Rule& rule)
{
    using access = property_access<M>;
    const auto source = access::template find<Handle, T>(levels[from], name);
    if (not source)
        return false;
    const unset_values<Handle, M> unset(levels[from], true);
    const T nothing = unset.template of<T>(name);
    auto target = add_unset<Handle>(fine, name, nothing);
    carry_map<Handle>(levels, from, to, source, target, rule);
    store_beside_faces<Handle>(fine, target, nothing);
    return true;
}

/// Types of the user that have a mean, but are not coordinates, go apart.
template <class T, class Handle, class M>
concept has_mean_of_its_own = affine_value<T> and not can_be_averaged<T> and
                              (std::same_as<Handle, typename mesh_traits<M>::vertex> or
                               std::same_as<Handle, typename mesh_traits<M>::halfedge>);

/// The same by the usual rule, if the type is one that goes apart.
template <class Handle, class T, mesh M, scheme Scheme>
bool carry_mean(const hierarchy<M, Scheme>& levels, int from, int to, M& fine, const std::string& name)
{
    if constexpr (has_mean_of_its_own<T, Handle, M>)
        return carry_property<Handle, T>(levels, from, to, fine, name, usual_rule<M, Handle, T>());
    else
        return false;
}
template <class Handle, class M, class... T>
using types_without_own_means = decltype(std::tuple_cat(
    std::declval<std::conditional_t<has_mean_of_its_own<T, Handle, M>, std::tuple<>, std::tuple<T>>>()...));

} // namespace detail

/// Gives `fine`, which has the elements of level `to` of a hierarchy, the properties of level `from` under their names:
/// on vertices, half-edges, edges and faces, of the types that property_access knows, and More.
/// On vertices, what can be averaged goes by the masks of the scheme, as the points do, and the rest stays with the
/// vertices that come from a vertex. Faces inherit from their parent, edges from the edge along which they lie. On
/// half-edges what can be averaged is that of corners, linear in each face, with its seams; the rest stays with those
/// that lie along a half-edge. All others have what the map gives to new elements, where the library has such values
/// that are no coordinates, else T(), zero where that is left open. What by_rule names goes by that rule instead.
/// Errors: mesh_error unless from <= to, or where `fine` has other elements. Cost: a step of the scheme without
/// connectivity per property that is averaged or has a rule, and one pass over the levels for the others of a kind; a
/// copy of the values of level `from`.
template <class... More, mesh M, scheme Scheme, class... Handle, class... T, class... Rule>
property_report carry_properties(const hierarchy<M, Scheme>& levels, int from, int to, M& fine,
                                 const property_by_rule<Handle, T, Rule>&... rules)
{
    using traits = mesh_traits<M>;
    const auto count = [](const M& mesh) {
        return std::array{traits::vertex_bound(mesh), traits::edge_bound(mesh), traits::face_bound(mesh)};
    };
    if (count(fine) != count(levels[to]))
        throw mesh_error("the mesh that is to have the properties is not level " + std::to_string(to) +
                         " of the hierarchy; give a copy of that level");
    property_report report;
    const auto carry = [&]<class On>(On) {
        using types = decltype(std::tuple_cat(std::declval<typename property_access<M>::value_types>(),
                                              std::declval<detail::types_without_own_means<On, M, More...>>()));
        const detail::property_values<On, M> values(levels[from], static_cast<types*>(nullptr));
        constexpr bool is_edge = std::same_as<On, typename traits::edge>;
        constexpr bool can_carry = not is_edge or numbering_of<Scheme, std::uint32_t>::has_edges;
        if constexpr (can_carry)
            detail::carry_values(levels, from, to, fine, values);
        auto& known = can_carry ? report.carried : report.left_out;
        known.insert(known.end(), values.known().begin(), values.known().end());
        for (const std::string& name : values.unknown())
            ((detail::carry_mean<On, More>(levels, from, to, fine, name) or ...) ? report.carried : report.left_out)
                .push_back(name);
    };
    carry(typename traits::vertex());
    carry(typename traits::halfedge());
    carry(typename traits::edge());
    carry(typename traits::face());

    if constexpr (requires { property_access<M>::copy_of_whole(fine, fine, report.carried); }) {
        const auto others = property_access<M>::copy_of_whole(levels[from], fine, report.carried);
        report.left_out.insert(report.left_out.end(), others.begin(), others.end());
    }

    [[maybe_unused]] const auto carry_by_rule =
        [&]<class On, class Value, class By>(const property_by_rule<On, Value, By>& each) {
            const auto left_out = std::ranges::find(report.left_out, each.name);
            const bool is_new = std::ranges::find(report.carried, each.name) == report.carried.end();
            if (not detail::carry_property<On, Value>(levels, from, to, fine, each.name, each.rule)) {
                if (is_new and left_out == report.left_out.end())
                    report.left_out.push_back(each.name);
            } else if (left_out != report.left_out.end()) {
                report.left_out.erase(left_out);
                report.carried.push_back(each.name);
            }
        };
    (carry_by_rule(rules), ...);
    return report;
}

/// `refine`, to the same points, with all properties that can be carried. Errors: as hierarchy::refine. Cost: that of
/// both; keeps all levels meanwhile.
template <class... More, mesh M, scheme Scheme, class... Handle, class... T, class... Rule>
std::pair<M, property_report> refine_with_properties(const M& mesh, const Scheme& scheme, int levels,
                                                     const property_by_rule<Handle, T, Rule>&... rules)
{
    hierarchy<M, Scheme> all(mesh, scheme);
    all.refine(levels);
    std::pair<M, property_report> result(all[levels], property_report());
    result.second = carry_properties<More...>(all, 0, levels, result.first, rules...);
    return result;
}

} // namespace kith
