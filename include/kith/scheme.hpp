// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "counts.hpp"
#include "error.hpp"
#include "numbering.hpp"

#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>

namespace kith {

/// A scheme is a function object on a refinement, with the columns it fills:
///
///   columns() or columns(generation)    which tuples give birth to what
///   operator()(refinement)              one step
///
/// and, if it has them,
///
///   static constexpr std::string_view name            for messages
///   static constexpr bool triangles_only = true       it refuses other faces; likewise quads_only
///   static constexpr bool closed_only = true          it refuses a boundary
///   counts next(counts, generation)                   the next level's counts in closed form, for plans over many levels
///   static void require(level, generation)            throws mesh_error for a control mesh that it cannot take
///   int reach(int rings)                              for tiles: rings of faces around a tile that a step uses up
///   static bool is_marked(edge)                       for tiles, where columns pick edges by marks
///   S after(level, numbering)                         the scheme of the next level, when it carries state of its level
///   static constexpr bool trusted = true              its associations need no check at every access
///   bool ignores_numbers() const                      it keeps nothing by the numbers of elements, so that it may be
///                                                     given levels whose elements are in another order
template <class S>
concept scheme = requires(const S& s) { columns_of(s, 0); };

template <class S>
constexpr std::string_view scheme_name()
{
    if constexpr (requires { S::name; })
        return S::name;
    else
        return "scheme";
}

template <class S>
inline constexpr bool needs_triangles = requires { requires S::triangles_only; };

template <class S>
inline constexpr bool needs_quads = requires { requires S::quads_only; };

template <class S>
inline constexpr bool needs_closed = requires { requires S::closed_only; };

template <class S>
concept countable_scheme = requires(const S& s, const counts& c) {
    { s.next(c, 0) } -> std::same_as<counts>;
};

/// Throws mesh_error when the scheme cannot take the faces of this level of a control mesh, or its boundary.
template <class S, class Level>
void require_input(const Level& level, [[maybe_unused]] int generation = 0)
{
    if constexpr (needs_triangles<S> or needs_quads<S>)
        for (const auto f : level.faces())
            if (f.degree() != (needs_triangles<S> ? 3 : 4))
                throw mesh_error(std::string(scheme_name<S>()) + ": face " + std::to_string(f.index()) + " has " +
                                 std::to_string(f.degree()) + " vertices; " +
                                 (needs_triangles<S> ? "triangulate the mesh first"
                                                     : "split it into quads first, by one step of the linear scheme"));
    if constexpr (needs_closed<S>)
        for (const auto e : level.edges())
            if (e.is_boundary())
                throw mesh_error(std::string(scheme_name<S>()) + ": edge " + std::to_string(e.index()) +
                                 " between vertices " + std::to_string(e.org().index()) + " and " +
                                 std::to_string(e.dst().index()) +
                                 " is a boundary edge; close the mesh first, or take a scheme with a boundary rule");
    if constexpr (requires { S::require(level, generation); })
        S::require(level, generation);
}

} // namespace kith
