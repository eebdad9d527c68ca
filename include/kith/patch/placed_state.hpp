// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/association/tuples.hpp>
#include <kith/mesh/connectivity.hpp>
#include <kith/step/level_state.hpp>
#include <kith/step/submesh.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace kith {

/// State of a level that says of which elements it says something, such as creases.
template <class State>
concept placed_state = requires(const State& state, void (*f)(tuple_kind, std::size_t)) {
    state.for_each_place(f);
    { state.of_part(part_numbers<std::uint32_t>()) } -> std::convertible_to<State>;
};

namespace detail {

template <class... State>
constexpr bool are_placed(const std::tuple<State&...>*)
{
    return (placed_state<std::remove_const_t<State>> and ...);
}

} // namespace detail

/// A scheme all of whose state, if it has any, says where it is: away from there it is the scheme without it.
template <class Scheme>
concept scheme_of_places = scheme<Scheme> and
                           detail::are_placed(
                               static_cast<const decltype(detail::states_of(std::declval<Scheme&>()))*>(nullptr));

/// What the scheme is where its state says nothing; the scheme itself, if nobody knows where that is.
template <scheme Scheme>
Scheme without_state(const Scheme& scheme)
{
    if constexpr (scheme_of_places<Scheme>)
        return detail::scheme_of_part(scheme, part_numbers<std::uint32_t>());
    else
        return scheme;
}

/// Makes the state of a scheme that of a part of a level of which `whole`, the same scheme but for its state, has it. Where nobody
/// knows where the state is nothing changes: the scheme must ignore numbers then.
template <scheme Scheme, std::unsigned_integral Index>
void take_state_of_part(Scheme& scheme, const Scheme& whole, const part_numbers<Index>& part)
{
    if constexpr (scheme_of_places<Scheme>)
        detail::for_each_state(
            scheme, whole, [&](auto& state, const auto& of_whole) { state = detail::state_of_part(of_whole, part); });
}

/// The faces of a level within so many rings of the elements of which the scheme's state says something, increasing.
/// Precondition: the mesh has its edges. Cost: O(1) without state, else O(elements).
template <scheme Scheme, class Point, std::unsigned_integral Index>
std::vector<Index> faces_near_state(const basic_mesh<Point, Index>& mesh, const Scheme& scheme, int rings)
{
    std::vector<Index> seeds;
    if constexpr (scheme_of_places<Scheme>) {
        const connectivity<Index>& t = mesh.topology();
        const auto add = [&](Index corner) {
            if (corner != t.none)
                seeds.push_back(t.face_of(corner));
        };
        const auto add_faces_of = [&](tuple_kind kind, std::size_t element) {
            if (kind == tuple_kind::f) {
                seeds.push_back(Index(element));
            } else if (kind == tuple_kind::e) {
                add(t.halfedge_corner[2 * element]);
                add(t.halfedge_corner[2 * element + 1]);
            } else {
                Index c = t.vertex_corner[element];
                do {
                    add(c);
                    c = t.next_in_fan(c);
                } while (c != t.none and c != t.vertex_corner[element]);
            }
        };
        detail::for_each_state(scheme, [&](const auto& state) { state.for_each_place(add_faces_of); });
    }
    if (seeds.empty())
        return {};
    std::ranges::sort(seeds);
    const auto twice = std::ranges::unique(seeds);
    seeds.erase(twice.begin(), twice.end());
    return submesh_cutter<Point, Index>(mesh).faces_around(seeds, rings);
}

} // namespace kith
