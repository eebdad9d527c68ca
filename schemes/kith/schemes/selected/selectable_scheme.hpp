// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/numbering/step/scheme.hpp>
#include <kith/schemes/split/quad_split.hpp>
#include <kith/schemes/split/triangle_split.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <string_view>

namespace kith {

namespace detail {

template <class Scheme>
inline constexpr bool splits_triangles = std::same_as<columns_type<Scheme>, decltype(triangle_split::columns())>;
template <class Scheme>
inline constexpr bool splits_into_quads = std::same_as<columns_type<Scheme>, decltype(quad_split::columns())>;

/// Returns true if the masks reach beyond the faces at an element. Such masks have negative weights, as Butterfly's do.
/// They magnify the steps in size between green faces from level to level: angles would shrink without end.
template <scheme Scheme>
[[nodiscard]] bool is_wide()
{
    if constexpr (reaching_scheme<Scheme> and std::default_initializable<Scheme>)
        return reach_of(Scheme(), 1) > 1; // without its creases
    else
        return false;
}

template <class Scheme>
constexpr auto letters_of_selected()
{
    constexpr std::string_view before = "selected-", own = scheme_name<Scheme>();
    std::array<char, before.size() + own.size()> result{};
    std::ranges::copy(own, std::ranges::copy(before, result.begin()).out);
    return result;
}
template <class Scheme>
inline constexpr auto name_of_selected = letters_of_selected<Scheme>();

} // namespace detail

/// Requirements of a scheme that can refine some faces of a level alone, by `selected`. It splits triangles in four
/// (loop, butterfly, linear_triangles) or polygons of any kind into quads (catmull_clark, linear). A user's own scheme
/// needs the columns of such a split.
template <class S>
concept selectable_scheme = scheme<S> and
                            ((detail::splits_triangles<S> and needs_triangles<S>) or
                             (detail::splits_into_quads<S> and not needs_quads<S> and not needs_triangles<S>));

} // namespace kith
