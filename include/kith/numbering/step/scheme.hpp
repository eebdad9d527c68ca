// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "next_counts.hpp"
#include "scheme_traits.hpp"

#include <kith/core/base/counts.hpp>
#include <kith/core/base/error.hpp>
#include <kith/numbering/association/numbering.hpp>

#include <concepts>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>

namespace kith {

/// A scheme: a function object on a refinement, with the columns that it fills:
///
///   columns() or columns(generation)    the tuples that make vertices, edges and faces
///   operator()(refinement)              one step
///
/// and, if it states more, `static constexpr auto traits()`: scheme_traits.
template <class S>
concept scheme = requires(const S& s) {
    requires std::copy_constructible<S>; // each level has its own
    { columns_of(s, 0) } -> declared_columns;
};

/// The columns of a scheme.
template <scheme Scheme>
using columns_type = decltype(columns_of(std::declval<const Scheme&>(), 0));
/// The numbering that one step of a scheme leaves behind.
template <scheme Scheme, std::unsigned_integral Index>
using numbering_of = numbering<columns_type<Scheme>, Index>;

/// A scheme whose levels can be counted before they are made. A scheme for closed meshes only need not count the
/// boundary.
template <class S>
concept countable_scheme = scheme<S> and
                           countable_columns<decltype(columns_of(std::declval<const S&>(), 0)), needs_closed<S>>;

/// A scheme that has state beside another scheme, plain(), which makes its steps; with_fields is such a scheme. The
/// steps of plain() are compiled once, for any state beside it.
template <class S>
concept wrapped_scheme = scheme<S> and requires(const S& s) {
    requires scheme<std::remove_cvref_t<decltype(s.plain())>>;
    requires std::derived_from<S, std::remove_cvref_t<decltype(s.plain())>>;
    requires not std::same_as<S, std::remove_cvref_t<decltype(s.plain())>>;
};

/// Returns the scheme that makes the steps: plain() of a wrapped scheme, any other scheme itself.
template <scheme Scheme>
const auto& plain_scheme(const Scheme& scheme)
{
    if constexpr (wrapped_scheme<Scheme>)
        return scheme.plain();
    else
        return scheme;
}

/// A scheme that states in its traits() how far its masks reach. `reach` is a function of k: the number of rings of
/// faces (that share a vertex) needed around some faces of a level. Then k rings around their children are right on the
/// next level: points, faces and fans within. The proofs are in docs/distributed.md.
template <class S>
concept reaching_scheme = scheme<S> and detail::says_reach<S, traits_type<S>>;

/// Returns the number of rings of faces needed around some faces of a level for `rings` rings after `steps` steps. If
/// `reach` of the scheme takes several steps, levels between may be wrong at the cut.
template <reaching_scheme S>
constexpr int reach_of(const S& scheme, int rings, int steps = 1)
{
    if constexpr (detail::says_reach_of_steps<S, traits_type<S>>) {
        return steps == 0 ? rings : detail::ask(traits_of<S>.reach, scheme, rings, steps);
    } else {
        for (; steps > 0; --steps)
            rings = detail::ask(traits_of<S>.reach, scheme, rings);
        return rings;
    }
}

/// Returns the counts of the next level. Cost: O(1).
template <countable_scheme S>
counts next_counts(const S& scheme, const counts& coarse, int generation)
{
    return next_counts<needs_closed<S>>(columns_of(scheme, generation), coarse, generation);
}

namespace detail {

/// Returns true if ids follow from tuples in one way in meshes that differ in the order of their elements. Then no
/// column has a condition or, in a closed mesh, a condition on anything but the boundary.
template <class... Columns>
constexpr bool is_free_of_order(const std::tuple<Columns...>*, bool closed)
{
    return (picks_without_condition<decltype(Columns::where)>(closed) and ...);
}

template <scheme Scheme>
constexpr bool is_free_of_order(bool closed)
{
    using columns = decltype(columns_of(std::declval<const Scheme&>(), 0));
    return is_free_of_order(static_cast<const decltype(columns::vertices.list)*>(nullptr), closed) and
           is_free_of_order(static_cast<const decltype(columns::edges.list)*>(nullptr), closed) and
           is_free_of_order(static_cast<const decltype(columns::faces.list)*>(nullptr), closed);
}

} // namespace detail

/// A scheme that makes the same bits of a part of a mesh, and of a mesh in another order of its elements.
template <class Scheme, class Index>
concept separable_scheme = is_trusted<Scheme> and countable_scheme<Scheme> and
                           numbering_of<Scheme, Index>::has_edges and
                           detail::says_ignores_numbers<Scheme, traits_type<Scheme>>;
/// A scheme that may refine a mesh in another order of its elements, with the numbers of the given mesh.
template <class Scheme, class Index>
concept orderable_scheme = separable_scheme<Scheme, Index> and numbering_of<Scheme, Index>::common_degree != 0 and
                           detail::is_free_of_order<Scheme>(true);

/// Throws mesh_error if no scheme of this type can take the faces of this level of a control mesh, or its boundary.
template <scheme S, level Level>
void require_shape(const Level& level)
{
    [[maybe_unused]] const auto number = [&level](const auto& x) { return std::to_string(number_in_mesh(level, x)); };
    if constexpr (needs_triangles<S> or needs_quads<S>)
        for (const auto f : level.faces())
            if (f.degree() != (needs_triangles<S> ? 3 : 4))
                throw mesh_error(std::string(scheme_name<S>()) + ": face " + number(f) + " has " +
                                 std::to_string(f.degree()) + " vertices; " +
                                 (needs_triangles<S> ? "triangulate the mesh first"
                                                     : "split it into quads first, by one step of the linear scheme"));
    if constexpr (needs_closed<S>)
        for (const auto e : level.edges())
            if (e.is_boundary())
                throw mesh_error(std::string(scheme_name<S>()) + ": edge " + number(e) + " between vertices " +
                                 number(e.org()) + " and " + number(e.dst()) +
                                 " is a boundary edge; close the mesh first, or take a scheme with a boundary rule");
}

namespace detail {

/// Calls traits().require of the scheme, if there is one, which throws for levels that the scheme cannot take.
template <scheme S, level Level>
void require_by_traits([[maybe_unused]] const S& scheme, const Level& level, int generation)
{
    if constexpr (is_said<decltype(traits_of<S>.require)>) {
        constexpr bool is_function = fact_about<decltype(traits_of<S>.require), S, const Level&, int>;
        static_assert(is_function,
                      "traits().require of a scheme is a function of (const auto& level, int generation), or of (const "
                      "the_scheme&, ...) and these");
        if constexpr (is_function)
            ask(traits_of<S>.require, scheme, level, generation);
    }
}

} // namespace detail

/// Throws mesh_error if the scheme cannot take this level of a control mesh, or has options with which it can take
/// none.
template <scheme S, level Level>
void require_input(const S& scheme, const Level& level, int generation = 0)
{
    require_shape<S>(level);
    detail::require_by_traits(scheme, level, generation);
}

} // namespace kith
