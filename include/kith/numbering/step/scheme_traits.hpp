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

/// The type of a fact that a scheme leaves out.
struct unsaid {
    friend bool operator==(unsaid, unsaid) = default;
};

/// The facts that a scheme states beside its columns and its step, in one place:
///
///   static constexpr auto traits() { return kith::scheme_traits{.name = "my-scheme", .closed_only = true}; }
///
/// Every fact may be left out; the stated facts are in this order, as designated initialisers are. A word that is not
/// one of them does not compile. The functions are lambdas or pointers to members. A function that depends on options
/// of the scheme takes the scheme as its first argument:
///
///   .reach = [](const my_scheme& s, int rings) { return rings / 2 + s.width; }
template <class Require = unsaid, class Reach = unsaid, class IsMarked = unsaid, class State = unsaid,
          class IgnoresNumbers = unsaid, class Closure = unsaid>
struct scheme_traits {
    std::string_view name = "scheme";   ///< for messages
    face_shape faces = face_shape::any; ///< other faces are refused
    bool closed_only = false;           ///< a boundary is refused
    bool trusted = false;               ///< tested with every association checked; its steps are not checked any more
    /// True if the members beside `state` are constants that belong to no element: a table of weights, a function.
    /// Tiles and ranks require this fact if a member is a container, a pointer or a class that owns memory.
    bool constants_only = false;
    int valence = 0; ///< of all inner vertices that a step has made, if it is the same everywhere; else 0
    /// The function void require(const auto& level, int generation). It throws mesh_error for a control mesh that the
    /// scheme cannot take, and for options with which it can take none.
    Require require{};
    /// The function int reach(int rings): the rings of faces around a tile that a step uses up; see reaching_scheme. It
    /// is reach(int rings, int steps) if several steps together use up fewer rings than one after the other. Tiles,
    /// `evaluator` and `refine` trust it; `require_reach` tests it for single steps on a mesh.
    Reach reach{};
    /// The function bool is_marked(const auto& edge), for tiles, if columns pick edges by marks; see marks_edges.
    IsMarked is_marked{};
    /// The state of a level, such as creases: a pointer to the member, or [](auto& scheme) -> auto& {...}; see
    /// level_state.
    State state{};
    /// The function bool ignores_numbers(): true if the scheme keeps nothing by the numbers of elements, so that it may
    /// be given levels in another order of their elements. A scheme with state, which may be empty, takes itself:
    /// [](const my_scheme& s) {...}. Masks must follow from the mesh and from the members that == compares, because
    /// records of one scheme are used for all equal schemes. Schemes without members are all equal.
    IgnoresNumbers ignores_numbers{};
    /// The closure that keeps levels conforming if only some faces are refined, [](const auto& scheme) -> const auto&
    /// {...}. `lies_on_side(corner)`: the corner lies inside a side of its face and is no corner with which the face
    /// was made. `is_pair(face, face)`: both faces are parts of one face, of which the next level is made.
    Closure closure{};
};

namespace detail {

template <class T>
inline constexpr bool is_scheme_traits = false;
template <class... Facts>
inline constexpr bool is_scheme_traits<scheme_traits<Facts...>> = true;

template <class Fact>
inline constexpr bool is_said = not std::same_as<std::remove_cvref_t<Fact>, unsaid>;

/// A fact that is a function, with or without the scheme as its first argument.
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

// has_WORD is true if a class has a member of that name, of any kind and access: that member hides, or is ambiguous
// with, another member of that name.
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

/// Asserts that the stated facts have the right signatures.
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

/// The traits of a scheme: its own, or the defaults. A fact of the wrong signature does not compile, nor does a
/// traits() of another type.
template <class S>
inline constexpr auto traits_of = detail::checked_traits<S>();

/// The type of the traits of a scheme.
template <class S>
using traits_type = std::remove_const_t<decltype(traits_of<S>)>;

/// Returns the name of a scheme, which programs, messages and journals use.
template <class S>
constexpr std::string_view scheme_name()
{
    return traits_of<S>.name;
}
/// The meshes that a scheme takes; is_trusted is true if the elements that it makes are not checked (`trusted`).
template <class S>
inline constexpr bool needs_triangles = traits_of<S>.faces == face_shape::triangles;
template <class S>
inline constexpr bool needs_quads = traits_of<S>.faces == face_shape::quads;
template <class S>
inline constexpr bool needs_closed = traits_of<S>.closed_only;
template <class S>
inline constexpr bool is_trusted = traits_of<S>.trusted;

/// Returns true if a scheme may be given levels whose elements are in another order.
template <class S>
constexpr bool ignores_numbers([[maybe_unused]] const S& scheme)
{
    if constexpr (detail::says_ignores_numbers<S, traits_type<S>>)
        return detail::ask(traits_of<S>.ignores_numbers, scheme);
    else
        return false;
}

} // namespace kith
