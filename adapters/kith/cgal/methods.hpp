// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "subdivision.hpp"

#include <kith/in_place/compiled.hpp>
#include <kith/in_place/split_with_creases.hpp>
#include <kith/kobbelt.hpp>
#include <kith/presets.hpp>

namespace kith::cgal {

namespace detail {

/// The scheme, or the linear split where nothing is to move.
template <class Linear, class Graph, scheme Scheme, class Np>
void subdivide(Graph& pmesh, const Scheme& scheme, const Np& np)
{
    if constexpr (steps<Np>) {
        cgal::subdivision(pmesh, scheme, np);
    } else if constexpr (is_given<Np, parameters::do_not_modify_geometry_t>) {
        if (CGAL::parameters::get_parameter(np, parameters::do_not_modify_geometry_tag)) {
            in_place::split_with_creases<Linear> split;
            return refine(pmesh, split, np);
        }
        cgal::subdivision(pmesh, scheme, np);
    } else {
        cgal::subdivision(pmesh, scheme, np);
    }
}

} // namespace detail

// Named as CGAL's, so that it takes one line to go from one to the other.
// NOLINTBEGIN(readability-identifier-naming)

/// CGAL::Subdivision_method_3::CatmullClark_subdivision, to the same surface, boundaries included. Named parameters as
/// `subdivision` and do_not_modify_geometry; or a number of steps. Errors, cost: as `subdivision`, here and below.
template <class Graph, class Np = CGAL::parameters::Default_named_parameters>
void CatmullClark_subdivision(Graph& pmesh, const Np& np = CGAL::parameters::default_values())
{
    detail::subdivide<linear>(pmesh, like<catmull_clark>(library::cgal), np);
}

/// The same for Loop; triangles.
template <class Graph, class Np = CGAL::parameters::Default_named_parameters>
void Loop_subdivision(Graph& pmesh, const Np& np = CGAL::parameters::default_values())
{
    detail::subdivide<linear_triangles>(pmesh, like<loop>(library::cgal), np);
}

/// The same for Doo-Sabin: the surface recedes from a boundary.
template <class Graph, class Np = CGAL::parameters::Default_named_parameters>
void DooSabin_subdivision(Graph& pmesh, const Np& np = CGAL::parameters::default_values())
{
    subdivision(pmesh, like<doo_sabin>(library::cgal), np);
}

/// The same for sqrt(3); triangles. As with CGAL the boundary is refined in every second step of one call.
template <class Graph, class Np = CGAL::parameters::Default_named_parameters>
void Sqrt3_subdivision(Graph& pmesh, const Np& np = CGAL::parameters::default_values())
{
    subdivision(pmesh, like<sqrt3>(library::cgal), np);
}

// Schemes that CGAL does not have.

/// Modified Butterfly; triangles.
template <class Graph, class Np = CGAL::parameters::Default_named_parameters>
void Butterfly_subdivision(Graph& pmesh, const Np& np = CGAL::parameters::default_values())
{
    subdivision(pmesh, butterfly(), np);
}

/// Interpolatory sqrt(3); closed meshes of triangles.
template <class Graph, class Np = CGAL::parameters::Default_named_parameters>
void InterpolatorySqrt3_subdivision(Graph& pmesh, const Np& np = CGAL::parameters::default_values())
{
    subdivision(pmesh, interpolatory_sqrt3(), np);
}

/// Kobbelt's interpolating scheme; quads.
template <class Graph, class Np = CGAL::parameters::Default_named_parameters>
void Kobbelt_subdivision(Graph& pmesh, const Np& np = CGAL::parameters::default_values())
{
    subdivision(pmesh, kobbelt(), np);
}

/// Velho and Zorin's 4-8. Any mesh becomes a tri-quad mesh first, as by `tri_quad`, unless its triangles agree on their
/// first edges, as they do after an earlier call.
template <class Graph, class Np = CGAL::parameters::Default_named_parameters>
void FourEight_subdivision(Graph& pmesh, const Np& np = CGAL::parameters::default_values())
{
    subdivision(pmesh, four_eight(), np);
}

/// Nasri and Hasbini's ternary scheme.
template <class Graph, class Np = CGAL::parameters::Default_named_parameters>
void NasriHasbini_subdivision(Graph& pmesh, const Np& np = CGAL::parameters::default_values())
{
    subdivision(pmesh, nasri_hasbini(), np);
}

/// The mid-edge scheme.
template <class Graph, class Np = CGAL::parameters::Default_named_parameters>
void MidEdge_subdivision(Graph& pmesh, const Np& np = CGAL::parameters::default_values())
{
    subdivision(pmesh, mid_edge(), np);
}

/// Zorin and Schroeder's unified family, of bidegree 1 to 9; closed meshes.
template <class Graph, class Np = CGAL::parameters::Default_named_parameters>
void Unified_subdivision(Graph& pmesh, int degree, const Np& np = CGAL::parameters::default_values())
{
    subdivision(pmesh, unified{.degree = degree}, np);
}

/// The linear splits, of polygons into quads and of triangles into triangles.
template <class Graph, class Np = CGAL::parameters::Default_named_parameters>
void Linear_subdivision(Graph& pmesh, const Np& np = CGAL::parameters::default_values())
{
    subdivision(pmesh, linear(), np);
}
template <class Graph, class Np = CGAL::parameters::Default_named_parameters>
void LinearTriangles_subdivision(Graph& pmesh, const Np& np = CGAL::parameters::default_values())
{
    subdivision(pmesh, linear_triangles(), np);
}

// NOLINTEND(readability-identifier-naming)

} // namespace kith::cgal
