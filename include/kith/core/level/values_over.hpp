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

/// The values of a step: those of the coarse level, and those of the next one, which are being made.
template <class V, class Level>
concept values_of_step = values_over<V, Level> and
                         requires(V& values, const V& made, std::size_t n, const typename V::sum& total) {
                             // Room for those of the columns; comes first.
                             values.allocate(n);
                             // Makes the n-th of them; several threads make different ones.
                             values.assign(n, total);
                             // What was made; several threads read.
                             { made.fine(n) } -> std::convertible_to<typename V::sum>;
                             // Makes one more after all of them; one thread does.
                             values.append(total);
                             // How many more there are, and any of all.
                             { made.listed_count() } -> std::convertible_to<std::size_t>;
                             { made.listed(n) } -> std::convertible_to<typename V::sum>;
                             // Others over the same coarse level, without any that are made, for another pass of the
                             // step.
                             { made.another() } -> std::same_as<V>;
                         };

} // namespace kith
