// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The schemes of the library, for programs that link kith::compiled_schemes. They need not compile the steps.

#include "butterfly.hpp"
#include "catmull_clark.hpp"
#include "doo_sabin.hpp"
#include "four_eight.hpp"
#include "interpolatory_sqrt3.hpp"
#include "kobbelt.hpp"
#include "linear.hpp"
#include "loop.hpp"
#include "mid_edge.hpp"
#include "nasri_hasbini.hpp"
#include "quad_tri.hpp"
#include "registry.hpp"
#include "sqrt3.hpp"
#include "tri_quad.hpp"
#include "unified.hpp"

#include <string_view>
#include <tuple>
#include <utility>

namespace kith {

namespace detail {

#define KITH_AS_TUPLE(type, header, numbers, paper) std::declval<std::tuple<type>>(),
using tuple_of_schemes = decltype(std::tuple_cat(KITH_SCHEMES(KITH_AS_TUPLE) std::declval<std::tuple<>>()));
#undef KITH_AS_TUPLE

} // namespace detail

/// The tuple of all schemes of the library: std::tuple<catmull_clark, ...>.
using all_schemes = detail::tuple_of_schemes;

/// The paper that a scheme of the library comes from.
template <class Scheme>
inline constexpr std::string_view paper_of{};
#define KITH_PAPER(type, header, numbers, paper)                                                                       \
    template <>                                                                                                        \
    inline constexpr std::string_view paper_of<type> = paper;
KITH_SCHEMES(KITH_PAPER)
#undef KITH_PAPER

} // namespace kith
