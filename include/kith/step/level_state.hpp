// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scheme_traits.hpp"

#include <concepts>
#include <cstddef>
#include <functional>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>

namespace kith {

/// The elements that make up a part of a level: of its vertices, edges and faces the numbers in the level, in the order of the
/// part. They increase; a vertex whose faces in the part form several fans is there once per fan.
template <class Index>
struct part_numbers {
    std::span<const Index> vertices, edges, faces;
};

/// State of a level is what a scheme keeps by the numbers of a level's elements, such as creases. The scheme names it in its
/// traits(), `.state`: one object, a std::tie of several, or a scheme of which this one is made. Its class has
///
///   T after(level, numbering) const      the state of the next level, made by a step with this numbering
///
/// and, to be refined in tiles and on ranks,
///
///   T of_part(part_numbers) const        that of a part of the level
///   void add_part(const T&, part_numbers)   the inverse: takes over what the state of a part says. For exchanging_refinement
///   void pack(out) const                 out.add(value), out.add_array(values): plain values, as a message
///   void unpack(in)                      in.get<T>(), in.get_array<std::vector<T>>(): the same values in the same order
///
/// `refine`, `hierarchy` and the tiles of all kinds do the rest.
template <class Scheme>
inline constexpr bool has_state = detail::is_said<decltype(traits_of<Scheme>.state)>;

namespace detail {

template <class T>
inline constexpr bool is_tie = false;
template <class... T>
inline constexpr bool is_tie<std::tuple<T&...>> = true;

template <class Fact, class Scheme>
constexpr bool names_state()
{
    if constexpr (std::invocable<const Fact&, Scheme&>) {
        using named = std::invoke_result_t<const Fact&, Scheme&>;
        return std::is_lvalue_reference_v<named> or is_tie<named>;
    } else {
        return false;
    }
}

/// All state of a scheme, and of the schemes of which it is made: std::tuple<State&...>.
template <class Scheme>
constexpr auto states_of([[maybe_unused]] Scheme& scheme)
{
    using plain = std::remove_const_t<Scheme>;
    if constexpr (has_state<plain>) {
        using fact = decltype(traits_type<plain>::state);
        constexpr bool is_named = names_state<fact, plain>() and names_state<fact, const plain>();
        static_assert(
            is_named,
            "traits().state of a scheme is a pointer to its member, or a function [](auto& scheme) -> auto& {...} "
            "that returns a reference to its state, or a std::tie of several");
        if constexpr (is_named) {
            const auto one = []<class State>(State& state) {
                if constexpr (requires { std::remove_const_t<State>::traits(); })
                    return states_of(state); // a scheme of which this one is made
                else
                    return std::tie(state);
            };
            if constexpr (std::is_lvalue_reference_v<std::invoke_result_t<const fact&, Scheme&>>)
                return one(std::invoke(traits_of<plain>.state, scheme));
            else
                return std::apply([&](auto&... states) { return std::tuple_cat(one(states)...); },
                                  std::invoke(traits_of<plain>.state, scheme));
        } else {
            return std::tuple<>();
        }
    } else {
        return std::tuple<>();
    }
}
template <class Scheme, class F>
void for_each_state(Scheme& scheme, const F& f)
{
    std::apply([&](auto&... state) { (f(state), ...); }, states_of(scheme));
}
/// Calls f with each state of one and the same of another scheme of that type.
template <class Scheme, class F>
void for_each_state(Scheme& scheme, const Scheme& other, const F& f)
{
    const auto ours = states_of(scheme);
    const auto theirs = states_of(other);
    [&]<std::size_t... I>(std::index_sequence<I...>) {
        (f(std::get<I>(ours), std::get<I>(theirs)), ...);
    }(std::make_index_sequence<std::tuple_size_v<decltype(ours)>>());
}

} // namespace detail

/// Makes a scheme the scheme of the next level, whose numbering is that of the step: its state becomes that of the level.
template <class Scheme, class Level, class Numbering>
void advance(Scheme& scheme, const Level& coarse, const Numbering& ids)
{
    detail::for_each_state(scheme, [&]<class State>(State& state) {
        constexpr bool goes_on = requires {
            { std::as_const(state).after(coarse, ids) } -> std::convertible_to<State>;
        };
        static_assert(
            goes_on,
            "the state that a scheme names in its traits() needs after(level, numbering) const, which returns that "
            "of the next level");
        if constexpr (goes_on)
            state = std::as_const(state).after(coarse, ids);
    });
}

namespace detail {

/// The scheme of a part of a level: the same, with the state of that part.
template <class Scheme, class Index>
Scheme scheme_of_part(Scheme scheme, const part_numbers<Index>& part)
{
    for_each_state(scheme, [&]<class State>(State& state) {
        constexpr bool parts = requires {
            { std::as_const(state).of_part(part) } -> std::convertible_to<State>;
        };
        static_assert(
            parts,
            "the state that a scheme names in its traits() needs of_part(const part_numbers<Index>&) const, which "
            "returns that of a part of the level, to be refined in tiles and to have limits");
        if constexpr (parts)
            state = std::as_const(state).of_part(part);
    });
    return scheme;
}

} // namespace detail

} // namespace kith
