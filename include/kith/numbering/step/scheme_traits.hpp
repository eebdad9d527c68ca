// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/in_library.hpp>

#include <concepts>
#include <functional>
#include <string_view>
#include <type_traits>

namespace kith {

/// The faces that a scheme takes.
enum class face_shape : unsigned char { any, triangles, quads };

/// The type of a fact that a scheme leaves unsaid.
struct unsaid {
    friend bool operator==(unsaid, unsaid) = default;
};

/// What a scheme says of itself beside its columns and its step, in one place:
///
///   static constexpr auto traits() { return kith::scheme_traits{.name = "my-scheme", .closed_only = true}; }
///
/// Every fact may be left out; those that are said stand in this order, as designated initialisers do. A word that is
/// not one of them does not compile. The functions are lambdas or pointers to members. Those that depend on options of
/// the scheme take it as their first argument:
///
///   .reach = [](const my_scheme& s, int rings) { return rings / 2 + s.width; }
template <class Require = unsaid, class Reach = unsaid, class IsMarked = unsaid, class State = unsaid,
          class IgnoresNumbers = unsaid, class Closure = unsaid>
struct scheme_traits {
    std::string_view name = "scheme";   ///< for messages
    face_shape faces = face_shape::any; ///< others are refused
    bool closed_only = false;           ///< a boundary is refused
    bool trusted = false; ///< its text has been tested with every association checked: they need no check any more
    /// Its members beside `state` are constants, which belong to no element: a table of weights, a function. Tiles and
    /// ranks ask for this word where a member is a container, a pointer or a class that owns memory.
    bool constants_only = false;
    int valence = 0; ///< of all inner vertices that a step has made, where it is the same everywhere; else 0
    /// void require(const auto& level, int generation): throws mesh_error for a control mesh that it cannot take, and
    /// for options with which it can take none.
    Require require{};
    /// int reach(int rings), or reach(int rings, int steps) where several steps together use up fewer than one after
    /// the other: the rings of faces around a tile that they use up; see reaching_scheme. Tiles, `evaluator` and
    /// `refine` believe it; `require_reach` tries what it says of single steps on a mesh.
    Reach reach{};
    /// bool is_marked(const auto& edge): for tiles, where columns pick edges by marks; see marks_edges.
    IsMarked is_marked{};
    /// Its state of a level, such as creases: a pointer to the member, or [](auto& scheme) -> auto& {...}; see
    /// level_state.
    State state{};
    /// bool ignores_numbers(): it keeps nothing by the numbers of elements, so that it may be given levels whose
    /// elements are in another order. One with state says it of itself, [](const my_scheme& s) {...}: it may be empty.
    /// Its masks follow from the mesh and from what its == compares, since what has been recorded of one scheme is used
    /// for all that are equal; those without members all are.
    IgnoresNumbers ignores_numbers{};
    /// What keeps its levels conforming where it refines some faces only, [](const auto& scheme) -> const auto& {...}.
    /// `lies_on_side(corner)`: the corner lies inside a side of its face and is none of those the face was born with.
    /// `is_pair(face, face)`: both are parts of one face, of which the next level is made.
    Closure closure{};
};

namespace detail {

template <class T>
inline constexpr bool is_scheme_traits = false;
template <class... Facts>
inline constexpr bool is_scheme_traits<scheme_traits<Facts...>> = true;

template <class Fact>
inline constexpr bool is_said = not std::same_as<std::remove_cvref_t<Fact>, unsaid>;

/// A fact that may, but need not take the scheme as its first argument.
template <class Fact, class S, class... Arguments>
concept fact_about = std::invocable<const Fact&, const S&, Arguments...> or std::invocable<const Fact&, Arguments...>;
template <class Fact, class S, class... Arguments>
    requires fact_about<Fact, S, Arguments...>
constexpr auto ask(const Fact& fact, const S& scheme, const Arguments&... arguments)
{
    if constexpr (std::invocable<const Fact&, const S&, const Arguments&...>)
        return std::invoke(fact, scheme, arguments...);
    else
        return std::invoke(fact, arguments...);
}
template <class Result, class Fact, class S, class... Arguments>
constexpr bool answers()
{
    if constexpr (fact_about<Fact, S, Arguments...>)
        return std::convertible_to<
            decltype(ask(std::declval<const Fact&>(), std::declval<const S&>(), std::declval<Arguments>()...)),
            Result>;
    else
        return false;
}

// A member of that name, whatever it is and whoever may see it: then it hides, or is ambiguous with, another of that
// name.
#define KITH_HAS_MEMBER(word)                                                                                          \
    struct with_##word {                                                                                               \
        int word;                                                                                                      \
    };                                                                                                                 \
    template <class S>                                                                                                 \
    struct beside_##word : S, with_##word {};                                                                          \
    template <class S>                                                                                                 \
    consteval bool has_##word()                                                                                        \
    {                                                                                                                  \
        if constexpr (std::is_class_v<S> and not std::is_final_v<S>)                                                   \
            return not requires { &beside_##word<S>::word; };                                                          \
        else                                                                                                           \
            return requires { &S::word; };                                                                             \
    }
KITH_HAS_MEMBER(limit_position)
KITH_HAS_MEMBER(traits)
#undef KITH_HAS_MEMBER

template <class S, class Traits>
inline constexpr bool says_reach_of_steps = answers<int, decltype(Traits::reach), S, int, int>();
template <class S, class Traits>
inline constexpr bool says_reach = says_reach_of_steps<S, Traits> or answers<int, decltype(Traits::reach), S, int>();
template <class S, class Traits>
inline constexpr bool says_ignores_numbers = answers<bool, decltype(Traits::ignores_numbers), S>();

/// What is said has the right signature.
template <class S, class Traits>
consteval void require_signatures()
{
    static_assert(not is_said<decltype(Traits::reach)> or says_reach<S, Traits>,
                  "traits().reach of a scheme is a function of (int rings), (int rings, int steps), or of (const "
                  "the_scheme&, ...) and these, that returns int");
    static_assert(not is_said<decltype(Traits::ignores_numbers)> or says_ignores_numbers<S, Traits>,
                  "traits().ignores_numbers of a scheme is a function of (), or of (const the_scheme&), that returns "
                  "bool");
    static_assert(
        not is_said<decltype(Traits::ignores_numbers)> or not is_said<decltype(Traits::state)> or
            std::invocable<decltype(Traits::ignores_numbers), const S&>,
        "traits().ignores_numbers of a scheme with state is a function of (const the_scheme&): its state, kept by "
        "numbers, may be empty or not");
}

template <class S>
consteval auto checked_traits()
{
    if constexpr (has_traits<S>()) {
        if constexpr (requires { S::traits(); }) {
            static_assert(is_scheme_traits<decltype(S::traits())>,
                          "traits() of a scheme returns kith::scheme_traits{...}");
            require_signatures<S, decltype(S::traits())>();
            return S::traits();
        } else {
            static_assert(
                not has_traits<S>(),
                "traits() of a scheme is public, static constexpr, takes nothing and returns kith::scheme_traits{...}; "
                "its words, in this order, are .name .faces .closed_only .trusted .constants_only .valence .require "
                ".reach .is_marked .state .ignores_numbers .closure");
            return scheme_traits{};
        }
    } else {
        return scheme_traits{};
    }
}

} // namespace detail

/// Traits of a scheme: its own, or the defaults. A fact of the wrong signature does not compile, nor does a traits() of
/// another type.
template <class S>
inline constexpr auto traits_of = detail::checked_traits<S>();

/// The type of what a scheme says of itself.
template <class S>
using traits_type = std::remove_const_t<decltype(traits_of<S>)>;

/// The name of a scheme, which programs, messages and journals call it by.
template <class S>
constexpr std::string_view scheme_name()
{
    return traits_of<S>.name;
}
/// The meshes that a scheme takes, and whether what it makes goes without checks (`trusted`).
template <class S>
inline constexpr bool needs_triangles = traits_of<S>.faces == face_shape::triangles;
template <class S>
inline constexpr bool needs_quads = traits_of<S>.faces == face_shape::quads;
template <class S>
inline constexpr bool needs_closed = traits_of<S>.closed_only;
template <class S>
inline constexpr bool is_trusted = traits_of<S>.trusted;

/// Whether a scheme may be given levels whose elements are in another order.
template <class S>
constexpr bool ignores_numbers([[maybe_unused]] const S& scheme)
{
    if constexpr (detail::says_ignores_numbers<S, traits_type<S>>)
        return detail::ask(traits_of<S>.ignores_numbers, scheme);
    else
        return false;
}

} // namespace kith
