// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/error.hpp>
#include <kith/core/base/diagnostics.hpp>
#include <kith/numbering/association/columns.hpp>
#include <kith/numbering/step/scheme.hpp>

#include <concepts>
#include <string>
#include <vector>

namespace kith {

/// Returns the rings of ghost faces that a tile needs on levels 0, 1, ..., `levels` to have `last` rings at the end.
/// One coarse ring becomes several refined ones, so the rings stay bounded for any number of levels. Errors: mesh_error
/// for negative numbers and for more than 1000 levels.
template <reaching_scheme S>
std::vector<int> ring_schedule(const S& scheme, int levels, int last = 0)
{
    if (levels < 0 or last < 0)
        throw mesh_error(std::string(scheme_name<S>()) +
                         ": negative levels or rings were asked for; ask for 0 or more");
    constexpr int most = 1000; // far more than 64 bits can number, and small to allocate
    if (levels > most)
        throw mesh_error(std::string(scheme_name<S>()) + ": " + std::to_string(levels) +
                         " levels are too many; ask for at most " + std::to_string(most));
    std::vector<int> rings(std::size_t(levels) + 1);
    rings.back() = last;
    for (std::size_t level = rings.size() - 1; level > 0; --level)
        rings[level - 1] = reach_of(scheme, rings[level]);
    return rings;
}

namespace detail {

/// A stand-in for a scheme that tiles refuse, so that the compiler prints only the sentence of scheme_in_tiles.
struct any_reaching_scheme {
    template <class Scheme>
        requires(not std::same_as<Scheme, any_reaching_scheme>)
    any_reaching_scheme(const Scheme&); // NOLINT(google-explicit-constructor): every scheme becomes one

    static constexpr auto traits()
    {
        return scheme_traits{.reach = [](int rings) { return rings; }};
    }
    static constexpr auto columns()
    {
        return kith::columns(
            new_vertices(per_vertex, per_edge, per_face), new_edges(per_end, per_side), new_faces(quads(per_corner)));
    }
    template <class R>
    void operator()(const R&) const
    {
    }
};

/// The static check that refuses a scheme without reach.
template <scheme Scheme>
struct scheme_in_tiles {
    static constexpr diagnostics::scheme_without_reach<not reaching_scheme<Scheme>> sentence{};
    using type = any_reaching_scheme;
};
template <scheme Scheme>
    requires(not reaching_scheme<Scheme>)
using refused_in_tiles = typename scheme_in_tiles<Scheme>::type;

} // namespace detail

} // namespace kith
