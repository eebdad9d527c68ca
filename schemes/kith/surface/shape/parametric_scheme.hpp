// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bisection_domain.hpp"
#include "dual_domains.hpp"
#include "face_domain.hpp"
#include "sqrt3_domain.hpp"

#include <kith/engine/neighbourhood/sparse_state.hpp>
#include <kith/limits/limit.hpp>
#include <kith/limits/limit_rings.hpp>
#include <kith/numbering/step/scheme.hpp>
#include <kith/schemes/crease/creases.hpp>

#include <concepts>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace kith {

namespace detail {

/// The face_domain of the split of a scheme.
template <class Scheme>
using domain_of = face_domain<std::remove_cvref_t<decltype(columns_of(std::declval<const Scheme&>(), 0))>>;
template <class Scheme>
concept has_quad_parameters = domain_of<Scheme>::sides == 4;

} // namespace detail

/// Requirements of a scheme whose limit surface has parameters: kith knows how its split cuts those of a face, and how
/// far its masks reach.
template <class Scheme>
concept parametric_scheme = searchable_scheme<Scheme> and requires { detail::domain_of<Scheme>::sides; };

namespace detail {

/// Returns the number of rings around a face that determine its limit surface: a step makes as many rings from as many.
template <searchable_scheme Scheme>
int rings_of_surface(const Scheme& scheme)
{
    if (domain_of<Scheme>::rings > 0)
        return domain_of<Scheme>::rings;
    int rings = 1;
    while (limit_rules<Scheme>::reach(scheme, rings) > rings)
        ++rings;
    return rings;
}

/// Returns the degree of the splines that are searched for. Errors: mesh_error if it is too high.
template <class Scheme>
std::size_t degree_of_polynomials([[maybe_unused]] const Scheme& scheme)
{
    if constexpr (requires { domain_of<Scheme>::degree_of(scheme); })
        return domain_of<Scheme>::degree_of(scheme);
    else
        return domain_of<Scheme>::degree;
}

/// Returns true if the state of the scheme is the same on this level and on all later ones.
template <scheme Scheme>
bool is_settled(const Scheme& scheme)
{
    bool result = true;
    for_each_state(scheme, [&](const auto& state) {
        if constexpr (sparse_state<std::remove_cvref_t<decltype(state)>>)
            state.for_each_place([&](tuple_kind, std::size_t, const auto& value) {
                if constexpr (requires { value == infinitely_sharp; })
                    result = result and value == infinitely_sharp;
                else
                    result = false;
            });
        else
            result = false;
    });
    return result;
}

/// Returns true if an edge is infinitely sharp. Precondition: the state is settled.
template <scheme Scheme>
bool is_sharp(const Scheme& scheme, std::size_t edge)
{
    bool result = false;
    for_each_state(scheme, [&](const auto& state) {
        if constexpr (requires { state.of_edge(edge) == infinitely_sharp; })
            result = result or state.of_edge(edge) == infinitely_sharp;
    });
    return result;
}

} // namespace detail

} // namespace kith
