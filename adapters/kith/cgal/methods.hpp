// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "subdivision.hpp"

#include <kith/in_place/compiled.hpp>
#include <kith/in_place/split_with_creases.hpp>
#include <kith/kobbelt.hpp>
#include <kith/presets.hpp>
#include <kith/quad_tri.hpp>

namespace kith::cgal {

namespace detail {

/// Subdivides by the scheme, or by the linear split if do_not_modify_geometry is set.
template <class Linear, class Graph, scheme Scheme, class Np, class... Argument>
property_report subdivide(Graph& pmesh, const Scheme& scheme, const Np& np, const Argument&... arguments)
{
    if constexpr (steps<Np>) {
        return cgal::subdivision(pmesh, scheme, np, arguments...);
    } else if constexpr (is_given<Np, parameters::do_not_modify_geometry_t>) {
        if (CGAL::parameters::get_parameter(np, parameters::do_not_modify_geometry_tag)) {
            in_place::split_with_creases<Linear> split;
            return refine(graph_of(pmesh), split, np, arguments...);
        }
        Scheme own = scheme; // its creases become those of the last level
        return refine(graph_of(pmesh), own, np, arguments...);
    } else {
        return cgal::subdivision(pmesh, scheme, np, arguments...);
    }
}

} // namespace detail

// Named like CGAL's functions, so that one changed line takes a program from CGAL to kith.
// NOLINTBEGIN(readability-identifier-naming)

/// Subdivides like CGAL::Subdivision_method_3::CatmullClark_subdivision, to the same surface, boundaries included.
/// Takes the named parameters of `subdivision` and do_not_modify_geometry, or a number of steps. Errors, cost: as
/// `subdivision`, also of the functions below.
template <class Graph, class Np = CGAL::parameters::Default_named_parameters, class... Argument>
property_report CatmullClark_subdivision(Graph& pmesh, const Np& np = CGAL::parameters::default_values(),
                                         const Argument&... arguments)
{
    return detail::subdivide<linear>(pmesh, like<catmull_clark>(library::cgal), np, arguments...);
}

/// Subdivides triangles like CGAL's Loop_subdivision, to the same surface. Parameters: as CatmullClark_subdivision.
template <class Graph, class Np = CGAL::parameters::Default_named_parameters, class... Argument>
property_report Loop_subdivision(Graph& pmesh, const Np& np = CGAL::parameters::default_values(),
                                 const Argument&... arguments)
{
    return detail::subdivide<linear_triangles>(pmesh, like<loop>(library::cgal), np, arguments...);
}

/// Subdivides like CGAL's DooSabin_subdivision, to the same surface, which recedes from a boundary. Takes the named
/// parameters of `subdivision`, or a number of steps, as do all functions below.
template <class Graph, class Np = CGAL::parameters::Default_named_parameters, class... Argument>
property_report DooSabin_subdivision(Graph& pmesh, const Np& np = CGAL::parameters::default_values(),
                                     const Argument&... arguments)
{
    return subdivision(pmesh, like<doo_sabin>(library::cgal), np, arguments...);
}

/// Subdivides triangles like CGAL's Sqrt3_subdivision, to the same surface. As in CGAL, every second step of one call
/// refines the boundary.
template <class Graph, class Np = CGAL::parameters::Default_named_parameters, class... Argument>
property_report Sqrt3_subdivision(Graph& pmesh, const Np& np = CGAL::parameters::default_values(),
                                  const Argument&... arguments)
{
    return subdivision(pmesh, like<sqrt3>(library::cgal), np, arguments...);
}

// Schemes that CGAL does not have.

/// Subdivides triangles by the Modified Butterfly scheme.
template <class Graph, class Np = CGAL::parameters::Default_named_parameters, class... Argument>
property_report Butterfly_subdivision(Graph& pmesh, const Np& np = CGAL::parameters::default_values(),
                                      const Argument&... arguments)
{
    return subdivision(pmesh, butterfly(), np, arguments...);
}

/// Subdivides closed meshes of triangles by the interpolatory sqrt(3) scheme.
template <class Graph, class Np = CGAL::parameters::Default_named_parameters, class... Argument>
property_report InterpolatorySqrt3_subdivision(Graph& pmesh, const Np& np = CGAL::parameters::default_values(),
                                               const Argument&... arguments)
{
    return subdivision(pmesh, interpolatory_sqrt3(), np, arguments...);
}

/// Subdivides quads by Kobbelt's interpolating scheme.
template <class Graph, class Np = CGAL::parameters::Default_named_parameters, class... Argument>
property_report Kobbelt_subdivision(Graph& pmesh, const Np& np = CGAL::parameters::default_values(),
                                    const Argument&... arguments)
{
    return subdivision(pmesh, kobbelt(), np, arguments...);
}

/// Subdivides by the 4-8 scheme of Velho and Zorin. Any mesh is first made a tri-quad mesh, as by `tri_quad`.
/// Exceptions are meshes whose triangles agree on their first edges, as they do after an earlier call.
template <class Graph, class Np = CGAL::parameters::Default_named_parameters, class... Argument>
property_report FourEight_subdivision(Graph& pmesh, const Np& np = CGAL::parameters::default_values(),
                                      const Argument&... arguments)
{
    return subdivision(pmesh, four_eight(), np, arguments...);
}

/// Subdivides by the quad-triangle scheme of Stam and Loop.
template <class Graph, class Np = CGAL::parameters::Default_named_parameters, class... Argument>
property_report QuadTri_subdivision(Graph& pmesh, const Np& np = CGAL::parameters::default_values(),
                                    const Argument&... arguments)
{
    return subdivision(pmesh, quad_tri(), np, arguments...);
}

/// Subdivides by the ternary scheme of Nasri and Hasbini.
template <class Graph, class Np = CGAL::parameters::Default_named_parameters, class... Argument>
property_report NasriHasbini_subdivision(Graph& pmesh, const Np& np = CGAL::parameters::default_values(),
                                         const Argument&... arguments)
{
    return subdivision(pmesh, nasri_hasbini(), np, arguments...);
}

/// Subdivides by the mid-edge scheme.
template <class Graph, class Np = CGAL::parameters::Default_named_parameters, class... Argument>
property_report MidEdge_subdivision(Graph& pmesh, const Np& np = CGAL::parameters::default_values(),
                                    const Argument&... arguments)
{
    return subdivision(pmesh, mid_edge(), np, arguments...);
}

/// Subdivides closed meshes by Zorin and Schroeder's unified family of schemes; `degree` is the bidegree, 1 to 9.
template <class Graph, class Np = CGAL::parameters::Default_named_parameters, class... Argument>
property_report Unified_subdivision(Graph& pmesh, int degree, const Np& np = CGAL::parameters::default_values(),
                                    const Argument&... arguments)
{
    return subdivision(pmesh, unified{.degree = degree}, np, arguments...);
}

/// Subdivides by a linear split: Linear_subdivision of polygons into quads, LinearTriangles_subdivision of triangles
/// into triangles.
template <class Graph, class Np = CGAL::parameters::Default_named_parameters, class... Argument>
property_report Linear_subdivision(Graph& pmesh, const Np& np = CGAL::parameters::default_values(),
                                   const Argument&... arguments)
{
    return subdivision(pmesh, linear(), np, arguments...);
}
template <class Graph, class Np = CGAL::parameters::Default_named_parameters, class... Argument>
property_report LinearTriangles_subdivision(Graph& pmesh, const Np& np = CGAL::parameters::default_values(),
                                            const Argument&... arguments)
{
    return subdivision(pmesh, linear_triangles(), np, arguments...);
}

// NOLINTEND(readability-identifier-naming)

} // namespace kith::cgal
