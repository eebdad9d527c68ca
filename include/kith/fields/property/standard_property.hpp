// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/mesh/mesh_traits.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <string>

namespace kith {

/// The properties beside points for which libraries have a name and a type of their own.
enum class standard_property : unsigned char { color, normal, texture_coordinates, none };

namespace detail {

/// Returns the name of a property on elements with such handles: a library's word after the letter of the elements,
/// such as "v:color". Returns "" for `none`.
template <mesh M, class Handle>
std::string standard_name(standard_property which, const std::array<const char*, 3>& words)
{
    using traits = mesh_traits<M>;
    if (which == standard_property::none)
        return "";
    const char* const letter = std::same_as<Handle, typename traits::vertex>     ? "v:"
                               : std::same_as<Handle, typename traits::halfedge> ? "h:"
                               : std::same_as<Handle, typename traits::edge>     ? "e:"
                                                                                 : "f:";
    return std::string(letter) + words[std::size_t(which)];
}

} // namespace detail

} // namespace kith
