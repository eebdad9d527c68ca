// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "level.hpp"

#include <kith/core/mask/value_space.hpp>

#include <concepts>
#include <cstddef>

namespace kith {

/// A value space with a value at each vertex of a level.
template <class V, class Level>
concept values_over = value_space<V> and requires(const V& values, const vertex<Level>& v) {
    { values.coarse(v) } -> std::convertible_to<typename V::sum>; // several threads read
};

/// The values of a step: those of the coarse level, and those of the next level, which are being computed.
template <class V, class Level>
concept values_of_step = values_over<V, Level> and
                         requires(V& values, const V& made, std::size_t n, const typename V::sum& total) {
                             // Allocates the values of the columns; is called first.
                             values.allocate(n);
                             // Sets the n-th of them; several threads set different ones.
                             values.assign(n, total);
                             // A value that was set; several threads read.
                             { made.fine(n) } -> std::convertible_to<typename V::sum>;
                             // Appends one more value after all of them; is called by one thread.
                             values.append(total);
                             // The number of appended values, and any of all values.
                             { made.listed_count() } -> std::convertible_to<std::size_t>;
                             { made.listed(n) } -> std::convertible_to<typename V::sum>;
                             // A new object over the same coarse level, without new values, for another pass of the
                             // step.
                             { made.another() } -> std::same_as<V>;
                         };

} // namespace kith
