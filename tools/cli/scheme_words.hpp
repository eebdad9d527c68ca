// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "errors.hpp"
#include "word_list.hpp"

#include <kith/doo_sabin.hpp>
#include <kith/face_varying.hpp>
#include <kith/loop.hpp>
#include <kith/presets.hpp>
#include <kith/schemes/crease/boundary.hpp>
#include <kith/schemes/crease/creases.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace kith::tool {

template <class Choice, std::size_t N>
using choice_words = std::array<std::pair<std::string_view, Choice>, N>;

/// Returns the words by which the command line names the values of a choice. There is one overload for each type of
/// choice.
constexpr auto words_for(library)
{
    return choice_words<library, 5>{{{"kith", library::kith},
                                     {"cgal", library::cgal},
                                     {"openmesh", library::openmesh},
                                     {"opensubdiv", library::opensubdiv},
                                     {"libigl", library::libigl}}};
}
constexpr auto words_for(boundary_corner)
{
    return choice_words<boundary_corner, 2>{{{"kept", boundary_corner::kept}, {"smoothed", boundary_corner::smoothed}}};
}
constexpr auto words_for(boundary_curve)
{
    return choice_words<boundary_curve, 2>{{{"cubic", boundary_curve::cubic}, {"thirds", boundary_curve::thirds}}};
}
constexpr auto words_for(loop_weights)
{
    return choice_words<loop_weights, 2>{{{"loop", loop_weights::loop}, {"warren", loop_weights::warren}}};
}
constexpr auto words_for(doo_sabin_boundary)
{
    return choice_words<doo_sabin_boundary, 3>{{{"thesis", doo_sabin_boundary::thesis},
                                                {"clamped", doo_sabin_boundary::clamped},
                                                {"drop", doo_sabin_boundary::drop}}};
}
constexpr auto words_for(doo_sabin_weights)
{
    return choice_words<doo_sabin_weights, 2>{
        {{"cosine", doo_sabin_weights::cosine}, {"averaging", doo_sabin_weights::averaging}}};
}

constexpr auto words_for(crease_method)
{
    return choice_words<crease_method, 2>{{{"uniform", crease_method::uniform}, {"chaikin", crease_method::chaikin}}};
}

constexpr auto words_for(face_varying_linear)
{
    return choice_words<face_varying_linear, 6>{{{"none", face_varying_linear::none},
                                                 {"corners", face_varying_linear::corners_only},
                                                 {"corners+1", face_varying_linear::corners_plus1},
                                                 {"corners+2", face_varying_linear::corners_plus2},
                                                 {"boundaries", face_varying_linear::boundaries},
                                                 {"all", face_varying_linear::all}}};
}

/// Returns the words of a type of choice: "kept, smoothed".
template <class Choice>
std::string all_words()
{
    std::string result;
    for (const auto& [word, choice] : words_for(Choice{}))
        append_to_list(result, word);
    return result;
}

/// Returns the word for a choice; this is the inverse of choice_from.
template <class Choice>
std::string word_of(Choice given)
{
    const auto words = words_for(Choice{});
    return std::string(std::ranges::find(words, given, &std::pair<std::string_view, Choice>::second)->first);
}

/// Returns the choice that a word names. Errors: usage_error for a word that names no choice.
template <class Choice>
Choice choice_from(std::string_view option, std::string_view given)
{
    for (const auto& [word, choice] : words_for(Choice{}))
        if (word == given)
            return choice;
    throw usage_error(std::string(option) + ": '" + std::string(given) + "' is not one of " + all_words<Choice>());
}

/// Calls f with the name of each option of a scheme and with the member that it sets.
template <class Scheme, class F>
void for_each_option(Scheme& scheme, const F& f)
{
    if constexpr (requires { scheme.corners; })
        f("--boundary-corners", scheme.corners);
    if constexpr (requires { scheme.weights; })
        f("--weights", scheme.weights);
    if constexpr (requires { scheme.boundary; })
        f("--boundary", scheme.boundary);
    if constexpr (scheme_with_creases<Scheme>)
        f("--crease-method", scheme.sharpness.method);
}

} // namespace kith::tool
