// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/diagnostics.hpp>
#include <kith/numbering/step/level_state.hpp>
#include <kith/tiles/part/checksum.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <ranges>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

namespace kith {

namespace detail {

/// A value that converts to every type but T and its bases, so that it initializes any member of an aggregate T.
template <class T>
struct any_member {
    template <class Member>
        requires(not std::is_base_of_v<Member, T>)
    operator Member() const; // NOLINT(google-explicit-constructor): an initializer converts
};
/// A value that converts to the bases of T only.
template <class T>
struct any_base {
    template <class Base>
        requires(std::is_base_of_v<Base, T> and not std::same_as<Base, T>)
    operator Base() const; // NOLINT(google-explicit-constructor): an initializer converts
};
template <class T, std::size_t>
using any_member_of = any_member<T>;

template <class T, std::size_t... Before, std::size_t... After>
consteval bool has_member_between(std::index_sequence<Before...>, std::index_sequence<After...>)
{
    return requires { T{any_member_of<T, Before>{}..., {}, any_member_of<T, After>{}...}; } or
           requires { T{any_member_of<T, Before>{}..., {any_member<T>{}}, any_member_of<T, After>{}...}; };
}
/// Returns true if each of `Count` initializers initializes one member. An array would take several initializers, and
/// an ambiguous one none.
template <class T, std::size_t... I>
consteval bool has_each_member(std::index_sequence<I...> all)
{
    constexpr std::size_t count = sizeof...(I);
    return not requires { T{any_member_of<T, I>{}..., {}}; } and
           (has_member_between<T>(std::make_index_sequence<I>(), std::make_index_sequence<count - 1 - I>()) and ...) and
           all.size() == count;
}
template <class T, std::size_t... I>
consteval bool takes_members(std::index_sequence<I...>)
{
    return requires { T{any_member_of<T, I>{}...}; };
}

inline constexpr std::size_t most_members = 12;
inline constexpr std::size_t unlisted = ~std::size_t(0);

/// Returns the number of members of an aggregate without bases, or `unlisted` for other types and for too many members.
template <class T, std::size_t Count = most_members + 1>
consteval std::size_t member_count()
{
    if constexpr (not std::is_aggregate_v<T> or std::is_array_v<T> or Count > most_members + 1)
        return unlisted;
    else if constexpr (requires { T{any_base<T>{}}; })
        return unlisted;
    else if constexpr (takes_members<T>(std::make_index_sequence<Count>()))
        return Count <= most_members and has_each_member<T>(std::make_index_sequence<Count>()) ? Count : unlisted;
    else if constexpr (Count == 0)
        return unlisted;
    else
        return member_count<T, Count - 1>();
}

/// Calls f(members...). Precondition: member_count<T>() is not `unlisted`.
template <class T, class F>
constexpr decltype(auto) with_members(T& x, const F& f)
{
    constexpr std::size_t count = member_count<std::remove_const_t<T>>();
    static_assert(most_members == 12);
    if constexpr (count == 0) {
        return f();
    } else if constexpr (count == 1) {
        auto& [a] = x;
        return f(a);
    } else if constexpr (count == 2) {
        auto& [a, b] = x;
        return f(a, b);
    } else if constexpr (count == 3) {
        auto& [a, b, c] = x;
        return f(a, b, c);
    } else if constexpr (count == 4) {
        auto& [a, b, c, d] = x;
        return f(a, b, c, d);
    } else if constexpr (count == 5) {
        auto& [a, b, c, d, e] = x;
        return f(a, b, c, d, e);
    } else if constexpr (count == 6) {
        auto& [a, b, c, d, e, g] = x;
        return f(a, b, c, d, e, g);
    } else if constexpr (count == 7) {
        auto& [a, b, c, d, e, g, h] = x;
        return f(a, b, c, d, e, g, h);
    } else if constexpr (count == 8) {
        auto& [a, b, c, d, e, g, h, i] = x;
        return f(a, b, c, d, e, g, h, i);
    } else if constexpr (count == 9) {
        auto& [a, b, c, d, e, g, h, i, j] = x;
        return f(a, b, c, d, e, g, h, i, j);
    } else if constexpr (count == 10) {
        auto& [a, b, c, d, e, g, h, i, j, k] = x;
        return f(a, b, c, d, e, g, h, i, j, k);
    } else if constexpr (count == 11) {
        auto& [a, b, c, d, e, g, h, i, j, k, l] = x;
        return f(a, b, c, d, e, g, h, i, j, k, l);
    } else {
        auto& [a, b, c, d, e, g, h, i, j, k, l, m] = x;
        return f(a, b, c, d, e, g, h, i, j, k, l, m);
    }
}

template <class T>
inline constexpr bool is_text = std::same_as<T, std::string> or std::same_as<T, std::string_view>;
template <class T>
inline constexpr bool is_array = std::is_array_v<T>;
template <class T, std::size_t N>
inline constexpr bool is_array<std::array<T, N>> = true;

/// The conditions under which a value may hold one value per element: it is a pointer to an object, a range of any
/// length, or owns memory.
template <class T>
inline constexpr bool owns_nothing = std::is_trivially_destructible_v<T> and std::is_trivially_copy_constructible_v<T>;
template <class T>
inline constexpr bool may_hold_elements = not is_text<T> and ((std::is_pointer_v<T> and
                                                               not std::is_function_v<std::remove_pointer_t<T>>) or
                                                              std::ranges::range<const T&> or not owns_nothing<T>);

template <class... T>
struct type_list {};
template <class... A, class... B>
type_list<A..., B...> operator+(type_list<A...>, type_list<B...>);

template <class T, class... States>
consteval auto leaves_of(type_list<States...> states);

/// The list of the types of the members of T. Aggregates among them are replaced by their own members, down to types
/// that are state or cannot be listed.
template <class T, class... States>
using leaves = decltype(leaves_of<std::remove_cvref_t<T>>(type_list<States...>()));

template <class T, class... States>
consteval auto leaves_of(type_list<States...> states)
{
    if constexpr ((std::same_as<T, States> or ...) or is_text<T>)
        return type_list<T>();
    else if constexpr (is_array<T>)
        return leaves_of<std::remove_cvref_t<decltype(std::declval<T&>()[0])>>(states);
    else if constexpr (std::is_empty_v<T>)
        return type_list<>();
    else if constexpr (member_count<T>() != unlisted and not std::ranges::range<const T&>)
        return decltype(with_members(
            std::declval<T&>(), []<class... M>(M&...) { return (type_list<>() + ... + leaves<M, States...>()); }))();
    else
        return type_list<T>();
}

/// Returns true if all members that may hold elements are named as state. It compares how often a type occurs among the
/// members (`Leaves`) and in the state that the scheme names (`States`).
template <class Scheme, class... States, class... Leaves>
consteval bool names_all(type_list<States...>, type_list<Leaves...>)
{
    constexpr auto is_state = []<class T>(std::type_identity<T>) { return (std::same_as<T, States> or ...); };
    [[maybe_unused]] const auto count = []<class T>(std::type_identity<T>) {
        return std::pair((std::size_t(std::same_as<T, Leaves>) + ... + 0),
                         (std::size_t(std::same_as<T, States>) + ... + 0));
    };
    bool all = true;
    std::size_t hidden = 0; // bytes of state within members that cannot be listed
    [[maybe_unused]] const auto look_for = [&]<class T>(std::type_identity<T> type) {
        const auto [members, named] = count(type);
        all = all and not(may_hold_elements<T> and members > named);
        hidden += members < named ? (named - members) * sizeof(T) / named : 0;
    };
    (look_for(std::type_identity<States>()), ...);
    [[maybe_unused]] const auto is_covered = [&]<class T>(std::type_identity<T> type) {
        return is_state(type) or not may_hold_elements<T> or
               (hidden != 0 and sizeof(T) < hidden + 2 * sizeof(void*)); // the rest is too small for a container
    };
    return all and (is_covered(std::type_identity<Leaves>()) and ...);
}

template <class... States>
type_list<std::remove_cvref_t<States>...> types_of(const std::tuple<States&...>&);
template <class Scheme>
using state_types = decltype(types_of(states_of(std::declval<Scheme&>())));

/// Returns true if all members of a scheme that may hold a value per element are state, as far as members can be
/// listed.
template <scheme Scheme>
consteval bool names_all_state()
{
    if constexpr (wrapped_scheme<Scheme>)
        return names_all_state<std::remove_cvref_t<decltype(std::declval<const Scheme&>().plain())>>();
    else if constexpr (traits_of<Scheme>.constants_only)
        return true;
    else
        return names_all<Scheme>(state_types<Scheme>(), leaves_of<Scheme>(state_types<Scheme>()));
}

/// Refuses at compile time a scheme that may hold values per element beside its state. Tiles number their elements from
/// 0 on, so each tile would read the values of other elements.
template <scheme Scheme>
constexpr void require_named_state()
{
    static_cast<void>(diagnostics::unnamed_state<not names_all_state<Scheme>()>());
}

template <class T, class... States>
void add_options(word_hash& hash, const T& x, type_list<States...> states)
{
    if constexpr ((std::same_as<T, States> or ...)) {
        return; // state is sent with the tiles
    } else if constexpr (std::is_arithmetic_v<T> or std::is_enum_v<T>) {
        std::uint64_t word = 0;
        std::memcpy(&word, &x, std::min(sizeof x, sizeof word));
        hash.add(word);
    } else if constexpr (is_array<T> or std::ranges::range<const T&>) {
        hash.add(std::uint64_t(std::ranges::distance(x)));
        for (const auto& value : x)
            add_options(hash, value, states);
    } else if constexpr (std::is_class_v<T> and not std::is_empty_v<T> and member_count<T>() != unlisted) {
        with_members(x, [&](const auto&... members) { (add_options(hash, members, states), ...); });
    }
}

/// Returns a hash of the options of a scheme, which are its members beside the state: numbers, enumerators, texts, and
/// ranges and aggregates of these.
template <scheme Scheme>
std::uint64_t sum_of_options(const Scheme& scheme)
{
    if constexpr (wrapped_scheme<Scheme>) {
        return sum_of_options(scheme.plain());
    } else {
        word_hash hash(0);
        add_options(hash, scheme, state_types<Scheme>());
        return hash.bits();
    }
}

} // namespace detail

} // namespace kith
