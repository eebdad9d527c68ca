// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/level/level.hpp>
#include <kith/core/mask/mask.hpp>

#include <concepts>
#include <type_traits>

namespace kith {

/// A level, or a block of its faces with the elements that belong to them, over which `for_each` loops.
template <class L>
concept level_or_block = requires(const L& elements) {
    elements.vertices();
    elements.edges();
    elements.faces();
    elements.corners();
    { elements.is_closed() } -> std::convertible_to<bool>; // of the whole level
};

/// The argument with which a scheme is called, and its rules and its split: `auto& [coarse, assoc, generation] = r;`
/// All members stay valid while the scheme runs.
template <class R>
concept step_context = requires(const R& r) {
    requires weight_number<typename R::scalar>;                       // the weights of its masks
    requires level_or_block<std::remove_cvref_t<decltype(r.coarse)>>; // is read
    requires mask_evaluator<std::remove_cvref_t<decltype(r.assoc)>>;  // makes the elements of the next level
    { r.generation } -> std::convertible_to<int>;                     // of the coarse level
};

} // namespace kith
