// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scheme.hpp"

#include <kith/core/level/to_native.hpp>
#include <kith/core/mesh/mesh_traits.hpp>

#include <concepts>
#include <cstddef>
#include <functional>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>

namespace kith {

/// The elements of a part of a level: the number in the level of each vertex, edge and face of the part, in the order
/// of the part. The numbers increase. A vertex whose faces in the part form several fans occurs once per fan.
template <std::unsigned_integral Index>
struct part_numbers {
    /// The corners of a face in the level: its first corner, and their count.
    struct face_corners {
        Index first, count;
    };

    std::span<const Index> vertices, edges, faces;
    std::size_t degree = 0;                  ///< of all faces, if they have one degree; else 0
    std::span<const face_corners> corners{}; ///< if `degree` is 0: the corners of each face

    [[nodiscard]] std::size_t vertex_count() const { return vertices.size(); }
    [[nodiscard]] std::size_t edge_count() const { return edges.size(); }
    [[nodiscard]] std::size_t face_count() const { return faces.size(); }
    [[nodiscard]] std::size_t corner_count() const
    {
        std::size_t result = degree * faces.size();
        for (const auto& [first, count] : corners)
            result += count;
        return result;
    }
    /// Calls f(number in the part, number in the level) for each corner of the faces.
    template <class F>
    void for_each_corner(const F& f) const
    {
        std::size_t here = 0;
        const auto in_face = [&](std::size_t first, std::size_t count) {
            for (std::size_t k = 0; k < count; ++k)
                f(here++, first + k);
        };
        for (const auto& [first, count] : corners)
            in_face(first, count);
        for (std::size_t i = 0; degree != 0 and i < faces.size(); ++i)
            in_face(degree * std::size_t(faces[i]), degree);
    }
};

/// The result of a step, as the state of a level sees it.
template <scheme Scheme, level Level, level_numbering Numbering, mesh Fine>
struct step_result {
    using numbering_type = Numbering;

    const Scheme& scheme; ///< with its state of the coarse level
    const Level& coarse;
    int generation;       ///< of the coarse level
    const Numbering& ids; ///< of the next level
    const Fine& fine_mesh;

    /// Returns the elements of the next level; for a native mesh without edges, only its faces and corners. Cost: for a
    /// mesh of another library a sweep over it.
    [[nodiscard]] level_of<Fine> fine() const { return level_of<Fine>(fine_mesh); }
    /// Returns the number of vertices of the next level, with those of the dictionary.
    [[nodiscard]] std::size_t fine_vertices() const
    {
        if constexpr (requires { fine_mesh.topology(); })
            return fine_mesh.vertex_count();
        else
            return std::size_t(mesh_traits<Fine>::vertex_bound(fine_mesh));
    }
};

/// The result of a step, as rules of fields see it: step_result.
template <class S>
concept finished_step = requires(const S& step) {
    requires scheme<std::remove_cvref_t<decltype(step.scheme)>>;       // with its state of the coarse level
    requires level<std::remove_cvref_t<decltype(step.coarse)>>;        // the coarse level
    { step.generation } -> std::convertible_to<int>;                   // of the coarse level
    requires level_numbering<std::remove_cvref_t<decltype(step.ids)>>; // of the next level
    requires level<std::remove_cvref_t<decltype(step.fine())>>;        // the next level
    { step.fine_vertices() } -> std::convertible_to<std::size_t>;      // with those of the dictionary
};

/// True if a scheme has state of a level: data that it keeps by the numbers of a level's elements, such as creases. Its
/// traits() name the state, `.state`: one object, a std::tie of several, or another scheme on which it is built.
/// The class of the state has
///
///   T after(level, numbering) const      the state of the next level, made by a step with this numbering, or
///   T after(const auto& step) const      the same from a step_result, for a state that needs more
///
/// and, to be refined in tiles and on ranks,
///
///   T of_part(part_numbers) const        the state of a part of the level
///   void add_part(const T&, part_numbers)  the inverse: takes over the state of a part, for exchanging_refinement
///   void pack(out) const                 out.add(value), out.add_array(values): plain values, as a message
///   void unpack(in)                      in.get<T>(), in.get_array<std::vector<T>>(): the same in the same order
///
/// It may have
///
///   void require_one_each(level) const   throws mesh_error for a state of another level, before that level is
///                                        refined or cut
///
///   void for_each_place(f) const         f(tuple_kind, number, value) for each vertex, edge and face (v, e, f) with a
///                                        value, which can be copied as bytes. The values are all that the state of a
///                                        part holds beyond the state of an empty part. Without this function the
///                                        state may depend on any element
///
/// State follows from the numbers of the elements and from the step, not from points: it stays when points move.
/// Conditions of columns may read it. `when` and the counts of later levels may read only data that the state of an
/// empty part has, too, such as a number of steps. `reach` holds for the state of every level.
///
/// `refine`, `hierarchy` and all kinds of tiles do the rest. `field` is such a class for values on elements.
template <scheme Scheme>
inline constexpr bool has_state = detail::is_said<decltype(traits_of<Scheme>.state)>;

namespace detail {

template <class T>
inline constexpr bool is_tie = false;
template <class... T>
inline constexpr bool is_tie<std::tuple<T&...>> = true;

template <class Fact, scheme Scheme>
constexpr bool names_state()
{
    if constexpr (std::invocable<const Fact&, Scheme&>) {
        using named = std::invoke_result_t<const Fact&, Scheme&>;
        return std::is_lvalue_reference_v<named> or is_tie<named>;
    } else {
        return false;
    }
}

/// Returns all state of a scheme, and of the schemes on which it is built: std::tuple<State&...>.
template <scheme Scheme>
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
                    return states_of(state); // a scheme on which this one is built
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
template <scheme Scheme, class F>
void for_each_state(Scheme& scheme, const F& f)
{
    std::apply([&](auto&... state) { (f(state), ...); }, states_of(scheme));
}
/// Calls f with each state of a scheme and the corresponding state of another scheme of that type.
template <scheme Scheme, class F>
void for_each_state(Scheme& scheme, const Scheme& other, const F& f)
{
    const auto ours = states_of(scheme);
    const auto theirs = states_of(other);
    [&]<std::size_t... I>(std::index_sequence<I...>) {
        (f(std::get<I>(ours), std::get<I>(theirs)), ...);
    }(std::make_index_sequence<std::tuple_size_v<decltype(ours)>>());
}

/// Throws mesh_error if a state can tell that it belongs to another level.
template <scheme Scheme, level Level>
void require_states_of(const Level& level, const Scheme& scheme)
{
    for_each_state(scheme, [&](const auto& state) {
        if constexpr (requires { state.require_one_each(level); })
            state.require_one_each(level);
    });
}

/// Throws mesh_error if require_input does, or if the state of the scheme can tell that it belongs to another level.
template <scheme Scheme, level Level>
void require_control_level(const Scheme& scheme, const Level& level, int generation)
{
    require_input(scheme, level, generation);
    require_states_of(level, scheme);
}

template <class State, finished_step Step>
State next_state(const State& state, const Step& step)
{
    constexpr bool by_numbering = requires {
        { state.after(step.coarse, step.ids) } -> std::convertible_to<State>;
    };
    constexpr bool by_step = requires {
        { state.after(step) } -> std::convertible_to<State>;
    };
    static_assert(
        by_numbering or by_step,
        "the state that a scheme names in its traits() needs after(level, numbering) const, which returns that "
        "of the next level");
    if constexpr (by_numbering)
        return state.after(step.coarse, step.ids);
    else if constexpr (by_step)
        return state.after(step);
    else
        return state;
}

} // namespace detail

/// Advances a scheme to the next level: its state becomes that of the level that a step has made, with this numbering,
/// of a level of this generation.
template <scheme Scheme, level Level, level_numbering Numbering, mesh Fine>
void advance(Scheme& scheme, const Level& coarse, int generation, const Numbering& ids, const Fine& fine)
{
    if constexpr (has_state<Scheme>) {
        const step_result<Scheme, Level, Numbering, Fine> step{scheme, coarse, generation, ids, fine};
        std::apply(
            [&]<class... State>(
                State&... states) { // a state may look at the others, so all are made before any changes
                std::tuple<State...> next{detail::next_state(std::as_const(states), step)...};
                std::tie(states...) = std::move(next);
            },
            detail::states_of(scheme));
    }
}

/// Exchanges the state of two schemes of one type. Their other members, which need not be assignable, are the same in
/// both.
template <scheme Scheme>
void swap_states(Scheme& a, Scheme& b)
{
    const auto of_a = detail::states_of(a), of_b = detail::states_of(b);
    [&]<std::size_t... I>(std::index_sequence<I...>) {
        (std::swap(std::get<I>(of_a), std::get<I>(of_b)), ...);
    }(std::make_index_sequence<std::tuple_size_v<decltype(of_a)>>());
}

namespace detail {

template <class State, std::unsigned_integral Index>
State state_of_part(const State& state, const part_numbers<Index>& part)
{
    constexpr bool parts = requires {
        { state.of_part(part) } -> std::convertible_to<State>;
    };
    static_assert(
        parts,
        "the state that a scheme names in its traits() needs of_part(const part_numbers<Index>&) const, which "
        "returns that of a part of the level, to be refined in tiles and to have limits");
    if constexpr (parts)
        return state.of_part(part);
    else
        return state;
}

/// Sets the state of a scheme to that of a part of a level. `of_level` is the scheme of the level: it is the same but
/// for its state, or `scheme` itself.
template <scheme Scheme, std::unsigned_integral Index>
void restrict_state(Scheme& scheme, const Scheme& of_level, const part_numbers<Index>& part)
{
    for_each_state(scheme, of_level, [&](auto& state, const auto& whole) { state = state_of_part(whole, part); });
}
/// Returns the scheme of a part of a level: the same scheme with the state of that part.
template <scheme Scheme, std::unsigned_integral Index>
Scheme scheme_of_part(Scheme scheme, const part_numbers<Index>& part)
{
    restrict_state(scheme, scheme, part);
    return scheme;
}

} // namespace detail

} // namespace kith
