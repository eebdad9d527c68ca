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

#include <kith/base/error.hpp>

#include <algorithm>
#include <initializer_list>
#include <string>

namespace kith {

/// Libraries whose conventions a scheme can follow. docs/schemes.md lists the differences.
enum class library : unsigned char { kith, cgal, openmesh, opensubdiv, libigl };

/// The scheme with the options that make it that of the library: `like<loop>(library::cgal)`.
/// Errors: mesh_error when that library does not have the scheme.
template <scheme Scheme>
Scheme like(library) = delete;

namespace detail {

template <scheme Scheme>
void require_preset(library wanted, std::initializer_list<library> present, const char* who_has_it)
{
    if (std::ranges::find(present, wanted) == present.end())
        throw mesh_error(std::string(scheme_name<Scheme>()) + ": that library does not have it; it is in " +
                         who_has_it);
}

} // namespace detail

/// CGAL and OpenMesh smooth boundary corners. OpenMesh's boundary curve is not the B-spline; see boundary_curve.
template <>
inline catmull_clark like<catmull_clark>(library other)
{
    detail::require_preset<catmull_clark>(other,
                                          {library::kith, library::cgal, library::openmesh, library::opensubdiv},
                                          "kith, CGAL, OpenMesh and OpenSubdiv");
    const bool smooth = other == library::cgal or other == library::openmesh;
    return {.corners = smooth ? boundary_corner::smoothed : boundary_corner::kept,
            .boundary = other == library::openmesh ? boundary_curve::thirds : boundary_curve::cubic};
}

/// CGAL, OpenMesh and libigl smooth boundary corners; libigl takes Warren's weights.
template <>
inline loop like<loop>(library other)
{
    const bool keep = other == library::kith or other == library::opensubdiv;
    return {.weights = other == library::libigl ? loop_weights::warren : loop_weights::loop,
            .corners = keep ? boundary_corner::kept : boundary_corner::smoothed};
}

template <>
inline doo_sabin like<doo_sabin>(library other)
{
    detail::require_preset<doo_sabin>(other, {library::kith, library::cgal}, "kith and CGAL");
    return {.boundary = other == library::cgal ? doo_sabin_boundary::drop : doo_sabin_boundary::thesis};
}

/// CGAL counts its even and odd steps anew in every call; refine there, as here, in one call.
template <>
inline sqrt3 like<sqrt3>(library other)
{
    detail::require_preset<sqrt3>(other, {library::kith, library::cgal, library::openmesh}, "kith, CGAL and OpenMesh");
    return {};
}

template <>
inline interpolatory_sqrt3 like<interpolatory_sqrt3>(library other)
{
    detail::require_preset<interpolatory_sqrt3>(other, {library::kith, library::openmesh}, "kith and OpenMesh");
    return {};
}

template <>
inline butterfly like<butterfly>(library other)
{
    detail::require_preset<butterfly>(other, {library::kith, library::openmesh}, "kith and OpenMesh");
    return {};
}

template <>
inline mid_edge like<mid_edge>(library other)
{
    detail::require_preset<mid_edge>(
        other, {library::kith, library::openmesh}, "kith and, for closed meshes, OpenMesh");
    return {};
}

template <>
inline kobbelt like<kobbelt>(library other)
{
    detail::require_preset<kobbelt>(other, {library::kith}, "kith alone");
    return {};
}

template <>
inline nasri_hasbini like<nasri_hasbini>(library other)
{
    detail::require_preset<nasri_hasbini>(other, {library::kith}, "kith alone");
    return {};
}

template <>
inline four_eight like<four_eight>(library other)
{
    detail::require_preset<four_eight>(other, {library::kith}, "kith alone");
    return {};
}

template <>
inline unified like<unified>(library other)
{
    detail::require_preset<unified>(other, {library::kith}, "kith");
    return {};
}

template <>
inline linear like<linear>(library)
{
    return {};
}

template <>
inline linear_triangles like<linear_triangles>(library)
{
    return {};
}

} // namespace kith
