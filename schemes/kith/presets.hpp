// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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
#include "sqrt3.hpp"
#include "unified.hpp"

#include <kith/core/base/error.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

namespace kith {

/// The libraries whose conventions a scheme can follow. docs/schemes.md lists the differences.
enum class library : unsigned char { kith, cgal, openmesh, opensubdiv, libigl };

namespace detail {

/// The libraries, beside kith itself, that have a scheme.
template <scheme Scheme>
inline constexpr std::array<library, 0> also_in{};
template <>
inline constexpr std::array also_in<catmull_clark>{library::cgal, library::openmesh, library::opensubdiv};
template <>
inline constexpr std::array also_in<loop>{library::cgal, library::openmesh, library::opensubdiv, library::libigl};
template <>
inline constexpr std::array also_in<doo_sabin>{library::cgal};
template <>
inline constexpr std::array also_in<sqrt3>{library::cgal, library::openmesh};
template <>
inline constexpr std::array also_in<interpolatory_sqrt3>{library::openmesh};
template <>
inline constexpr std::array also_in<butterfly>{library::openmesh};
template <>
inline constexpr std::array also_in<mid_edge>{library::openmesh};
template <>
inline constexpr std::array also_in<linear>{library::cgal, library::openmesh, library::opensubdiv, library::libigl};
template <>
inline constexpr std::array also_in<linear_triangles> = also_in<linear>;

/// Sets the options to those of another library. CGAL and OpenMesh smooth boundary corners. OpenMesh's boundary curve
/// is not the B-spline; see boundary_curve.
inline void follow(catmull_clark& scheme, library other)
{
    if (other == library::cgal or other == library::openmesh)
        scheme.corners = boundary_corner::smoothed;
    if (other == library::openmesh)
        scheme.boundary = boundary_curve::thirds;
}
/// Sets the options to those of another library. CGAL, OpenMesh and libigl smooth boundary corners; libigl takes
/// Warren's weights.
inline void follow(loop& scheme, library other)
{
    if (other == library::cgal or other == library::openmesh or other == library::libigl)
        scheme.corners = boundary_corner::smoothed;
    if (other == library::libigl)
        scheme.weights = loop_weights::warren;
}
inline void follow(doo_sabin& scheme, library other)
{
    if (other == library::cgal)
        scheme.boundary = doo_sabin_boundary::drop;
}
/// Sets nothing: all other schemes are the same in all libraries. But CGAL counts the even and odd steps of sqrt(3)
/// anew in every call, so refine in one call, there and here. OpenMesh's mid-edge takes closed meshes only.
template <scheme Scheme>
void follow(Scheme&, library)
{
}

} // namespace detail

/// Returns the scheme with the options that make it that of the library: `like<loop>(library::cgal)`. Errors:
/// mesh_error if that library does not have the scheme.
template <scheme Scheme>
Scheme like(library other)
{
    constexpr std::array names{"kith", "CGAL", "OpenMesh", "OpenSubdiv", "libigl"};
    const auto& libraries = detail::also_in<Scheme>;
    if (other != library::kith and std::ranges::find(libraries, other) == libraries.end()) {
        std::string who = names[0];
        for (const library has_it : libraries)
            who += (has_it == libraries.back() ? " and " : ", ") + std::string(names[std::size_t(has_it)]);
        throw mesh_error(std::string(scheme_name<Scheme>()) + ": " + names[std::size_t(other)] +
                         " does not have it; it is in " + who);
    }
    Scheme result;
    detail::follow(result, other);
    return result;
}

} // namespace kith
