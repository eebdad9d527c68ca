// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hierarchy.hpp"

#include <kith/fields/field.hpp>
#include <kith/fields/property/map_value.hpp>
#include <kith/fields/property/property_access.hpp>
#include <kith/fields/property/property_values.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith {

namespace detail {

/// Returns the default rule by which averaged values on elements with handles of this type are carried; vertices and
/// corners have such values. rule_of_heirs returns the default rule for values that one element inherits from another.
template <mesh M, class Handle>
auto rule_of_means()
{
    if constexpr (std::same_as<Handle, typename mesh_traits<M>::vertex>)
        return by_mask();
    else
        return linear_in_faces();
}
template <mesh M, class Handle>
auto rule_of_heirs()
{
    using traits = mesh_traits<M>;
    if constexpr (std::same_as<Handle, typename traits::vertex>)
        return from_vertex();
    else if constexpr (std::same_as<Handle, typename traits::edge>)
        return along_edges();
    else if constexpr (std::same_as<Handle, typename traits::face>)
        return from_parent();
    else
        return along_sides();
}
/// Returns the default rule for values of type T: rule_of_means if they have a mean, else rule_of_heirs.
template <mesh M, class Handle, class T>
auto usual_rule()
{
    if constexpr (has_means<Handle, M> and affine_value<T>)
        return rule_of_means<M, Handle>();
    else
        return rule_of_heirs<M, Handle>();
}
template <mesh M, class Handle>
inline constexpr field_on kind_of_handle = std::same_as<Handle, typename mesh_traits<M>::vertex> ? field_on::vertices
                                           : std::same_as<Handle, typename mesh_traits<M>::edge> ? field_on::edges
                                           : std::same_as<Handle, typename mesh_traits<M>::face> ? field_on::faces
                                                                                                 : field_on::corners;

} // namespace detail

/// Writes to `target` the values at the elements of level `to` with handles of type Handle. The values follow from
/// those of `source` at level `from` by a rule of fields; the default is the rule of carry_properties. A half-edge
/// stands for the corner at its target. Maps are property maps of any kind and type, or objects that take handles in
/// brackets, such as CGAL's dynamic maps and OpenMesh's property managers. `source` may also be a function. Errors and
/// cost: those of hierarchy::carry.
template <class Handle, mesh M, scheme Scheme, class Source, class Target,
          class Rule = decltype(detail::usual_rule<M, Handle, typename detail::map_value_type<Source, Handle>::type>())>
void carry_map(const hierarchy<M, Scheme>& levels, int from, int to, const Source& source, Target&& target,
               const Rule& rule = Rule())
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

/// A property that is carried by a rule of the user, on elements with handles of type Handle. T is the type of its
/// values, which may be any. Handle is a handle of the refined mesh. For half-edges it is mesh_traits<M>::halfedge,
/// which is Surface_mesh's Halfedge_index and OpenMesh's HalfedgeHandle. The value of a half-edge stands for the corner
/// at its target.
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

/// The names of the properties of a mesh that were carried, and of those that were left out.
struct property_report {
    std::vector<std::string> carried;
    /// The properties of unknown types, normals and properties without a name of their own. Names in by_rule are here,
    /// too, if there is no property of that name and type.
    std::vector<omission> left_out;
};

namespace detail {

/// A property in a report, with the kind of elements on which it lies: properties of several kinds may share a name.
struct told_property {
    std::string name;
    std::optional<field_on> where; ///< nothing for properties of the mesh as a whole
    std::string why;               ///< empty for carried properties

    [[nodiscard]] bool is(const std::string& other, std::optional<field_on> other_where) const
    {
        return name == other and where == other_where;
    }
};

inline constexpr const char* unknown_type = "kith does not know its type; name the type: carry_properties<type>(...)";
inline constexpr const char* no_name = "it has a default name, which may mean anything in another mesh; give it a name";
inline constexpr const char* made_of_points = "it follows from the points; compute it again by the mesh library";
inline constexpr const char* edges_unknown =
    "the scheme does not tell which new edges lie along old ones; declare its new_edges";
inline constexpr const char* absent = "by_rule names it, but no property has that name; check the name";
inline constexpr const char* other_type = "by_rule names it with a type that it does not have; name its own type";

/// Returns the reason why values of this name are not carried by their type.
template <mesh_with_properties M>
const char* why_unknown(const std::string& name)
{
    if (is_unnamed<M>(name))
        return no_name;
    return property_access<M>::follows_from_points(name) ? made_of_points : unknown_type;
}

template <class Handle, mesh M, scheme Scheme>
void carry_values(const hierarchy<M, Scheme>& levels, int from, int to, M& fine,
                  const property_values<Handle, M>& values)
{
    const auto carried = [&]<class T, class Rule>(const storage<T>& each, const Rule& rule) {
        return levels.carry(from, to, field<kind_of_handle<M, Handle>, T, Rule>(each, rule));
    };
    if constexpr (has_means<Handle, M>)
        for (const auto& each : values.means())
            values.write_mean(fine, each, carried(each.values, rule_of_means<M, Handle>()).values());
    if (values.has_heirs())
        values.write_heirs(fine, carried(values.own_heirs(), rule_of_heirs<M, Handle>()).values());
}

/// Carries a property by a rule. Returns true if level `from` has a property of this name and type.
template <class Handle, class T, class Rule, mesh M, scheme Scheme>
bool carry_property(const hierarchy<M, Scheme>& levels, int from, int to, M& fine, unset_values<M>& unset,
                    const std::string& name, const Rule& rule)
{
    using access = property_access<M>;
    const auto source = access::template find<Handle, T>(levels[from], name);
    if (not source)
        return false;
    const T nothing = unset.template of<Handle, T>(name);
    auto target = add_unset<Handle>(fine, name, nothing);
    carry_map<Handle>(levels, from, to, source, target, rule);
    store_nothing(target, handles_beside_faces<Handle>(fine), nothing);
    return true;
}

/// A type of the user whose values have a mean, but are not coordinates. Its properties are carried one by one.
template <class T, class Handle, class M>
concept has_mean_of_its_own = affine_value<T> and not can_be_averaged<T> and has_means<Handle, M>;

/// Carries a property by rule_of_means if its type has a mean of its own. Returns true if there was such a property.
template <class Handle, class T, mesh M, scheme Scheme>
bool carry_mean(const hierarchy<M, Scheme>& levels, int from, int to, M& fine, unset_values<M>& unset,
                const std::string& name)
{
    if constexpr (has_mean_of_its_own<T, Handle, M>)
        return carry_property<Handle, T>(levels, from, to, fine, unset, name, rule_of_means<M, Handle>());
    else
        return false;
}
template <class Handle, class M, class... T>
using types_without_own_means = decltype(std::tuple_cat(
    std::declval<std::conditional_t<has_mean_of_its_own<T, Handle, M>, std::tuple<>, std::tuple<T>>>()...));

} // namespace detail

/// Writes the properties of level `from` of a hierarchy to `fine`, under their names; `fine` has the elements of level
/// `to`. The properties lie on vertices, half-edges, edges and faces, and have types that property_access knows or one
/// of the types More.
/// On vertices, values that can be averaged are carried by the masks of the scheme, as points are. Other values stay
/// with the vertices that come from a vertex. Faces inherit from their parent, edges from the edge along which they
/// lie. On half-edges, values that can be averaged are carried as values of corners: linearly in each face, with seams.
/// Other values stay with the half-edges that lie along a half-edge. Elements that inherit nothing get the value that
/// the map gives to new elements, if the library has such values and they are no coordinates. Else they get T(), or
/// zero if T() is uninitialised. A property that by_rule names is carried by that rule instead. A property without a
/// name of its own is left out, because its name may stand for anything in `fine`.
/// Errors: mesh_error unless from <= to, and if `fine` has other elements. Cost: for each property that is averaged or
/// has a rule, a step of the scheme without connectivity; for the other properties of a kind of elements, one pass over
/// the levels; a copy of the values of level `from`.
template <class... More, mesh M, scheme Scheme, class... Handle, class... T, class... Rule>
property_report carry_properties(const hierarchy<M, Scheme>& levels, int from, int to, M& fine,
                                 const property_by_rule<Handle, T, Rule>&... rules)
{
    using traits = mesh_traits<M>;
    const auto count = [](const M& mesh) {
        return std::array{traits::vertex_bound(mesh), traits::edge_bound(mesh), traits::face_bound(mesh)};
    };
    if (count(fine) != count(levels[to]))
        throw mesh_error("the mesh that receives the properties is not level " + std::to_string(to) +
                         " of the hierarchy; give a copy of that level");
    std::vector<detail::told_property> carried, left_out;
    const auto tell =
        [](auto& told, const std::vector<std::string>& names, std::optional<field_on> where, const char* why = "") {
            for (const std::string& name : names)
                told.push_back({name, where, why});
        };
    detail::unset_values<M> unset(levels[from]);
    const auto carry = [&]<class On>(On) {
        using types = decltype(std::tuple_cat(std::declval<typename property_access<M>::value_types>(),
                                              std::declval<detail::types_without_own_means<On, M, More...>>()));
        detail::property_values<On, M> values(levels[from], unset, static_cast<types*>(nullptr));
        values.leave_out_unnamed();
        constexpr field_on where = detail::kind_of_handle<M, On>;
        constexpr bool is_edge = std::same_as<On, typename traits::edge>;
        constexpr bool can_carry = not is_edge or numbering_of<Scheme, std::uint32_t>::has_edges;
        if constexpr (can_carry)
            detail::carry_values(levels, from, to, fine, values);
        tell(can_carry ? carried : left_out, values.known(), where, can_carry ? "" : detail::edges_unknown);
        for (const std::string& name : values.unknown()) {
            const bool has_mean = ((not detail::is_unnamed<M>(name, typeid(More)) and
                                    detail::carry_mean<On, More>(levels, from, to, fine, unset, name)) or
                                   ...);
            (has_mean ? carried : left_out).push_back({name, where, has_mean ? "" : detail::why_unknown<M>(name)});
        }
    };
    carry(typename traits::vertex());
    carry(typename traits::halfedge());
    carry(typename traits::edge());
    carry(typename traits::face());

    if constexpr (requires(std::vector<std::string>& names) { property_access<M>::copy_of_whole(fine, fine, names); }) {
        std::vector<std::string> copied;
        for (const std::string& name : property_access<M>::copy_of_whole(levels[from], fine, copied))
            left_out.push_back({name, std::nullopt, detail::why_unknown<M>(name)});
        tell(carried, copied, std::nullopt);
    }

    [[maybe_unused]] const auto carry_by_rule =
        [&]<class On, class Value, class By>(const property_by_rule<On, Value, By>& each) {
            constexpr field_on where = detail::kind_of_handle<M, On>;
            const auto is_it = [&](const detail::told_property& told) { return told.is(each.name, where); };
            const auto found = std::ranges::find_if(left_out, is_it);
            if (detail::carry_property<On, Value>(levels, from, to, fine, unset, each.name, each.rule)) {
                if (found != left_out.end()) {
                    carried.push_back({each.name, where, ""});
                    left_out.erase(found);
                }
            } else if (found != left_out.end()) {
                found->why = detail::other_type;
            } else {
                const bool has_other_type = std::ranges::any_of(carried, is_it);
                left_out.push_back({each.name, where, has_other_type ? detail::other_type : detail::absent});
            }
        };
    (carry_by_rule(rules), ...);
    property_report report;
    for (detail::told_property& each : carried)
        report.carried.push_back(std::move(each.name));
    for (detail::told_property& each : left_out)
        report.left_out.push_back({std::move(each.name), std::move(each.why)});
    return report;
}

/// Returns the mesh that `refine` makes, with the same points and all properties that can be carried, and a report.
/// Errors: as hierarchy::refine. Cost: that of hierarchy::refine and carry_properties; all levels are in memory
/// meanwhile.
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
