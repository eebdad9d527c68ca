// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mask.hpp"

#include <type_traits>
#include <utility>

namespace kith {

/// A mask that is one of two masks, chosen at run time. Each is given by a function, so that only the chosen mask has
/// to exist.
template <class Then, class Else>
struct mask_choice : mask_base {
    bool condition;
    Then then;
    Else otherwise;

    mask_choice(bool condition, Then then, Else otherwise)
        : condition(condition), then(std::move(then)), otherwise(std::move(otherwise))
    {
    }

    template <value_space Values>
    [[nodiscard]] typename Values::sum evaluate(const Values& values) const
    {
        if (condition)
            return then().evaluate(values);
        return otherwise().evaluate(values);
    }
};

/// Returns the mask of `then` if the condition is true, else the mask of `otherwise`. Only the chosen function is
/// called, when the mask is evaluated.
template <class Then, class Else>
    requires mask<std::invoke_result_t<Then>> and mask<std::invoke_result_t<Else>>
[[nodiscard]] auto choose(bool condition, Then then, Else otherwise)
{
    return mask_choice<Then, Else>(condition, std::move(then), std::move(otherwise));
}

} // namespace kith
