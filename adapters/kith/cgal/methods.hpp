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
        return cgal::subdivision(pmesh, scheme, np, arguments...);
    } else {
        return cgal::subdivision(pmesh, scheme, np, arguments...);
    }
}

} // namespace detail

// Named as CGAL's, so that it takes one line to go from one to the other.
// NOLINTBEGIN(readability-identifier-naming)

/// CGAL::Subdivision_method_3::CatmullClark_subdivision, to the same surface, boundaries included. Named parameters as
/// `subdivision` and do_not_modify_geometry; or a number of steps. Errors, cost: as `subdivision`, here and below.
template <class Graph, class Np = CGAL::parameters::Default_named_parameters, class... Argument>
property_report CatmullClark_subdivision(Graph& pmesh, const Np& np = CGAL::parameters::default_values(),
                                         const Argument&... arguments)
{
    return detail::subdivide<linear>(pmesh, like<catmull_clark>(library::cgal), np, arguments...);
}

/// The same for Loop; triangles.
template <class Graph, class Np = CGAL::parameters::Default_named_parameters, class... Argument>
property_report Loop_subdivision(Graph& pmesh, const Np& np = CGAL::parameters::default_values(),
                                 const Argument&... arguments)
{
    return detail::subdivide<linear_triangles>(pmesh, like<loop>(library::cgal), np, arguments...);
}

/// The same for Doo-Sabin: the surface recedes from a boundary.
template <class Graph, class Np = CGAL::parameters::Default_named_parameters, class... Argument>
property_report DooSabin_subdivision(Graph& pmesh, const Np& np = CGAL::parameters::default_values(),
                                     const Argument&... arguments)
{
    return subdivision(pmesh, like<doo_sabin>(library::cgal), np, arguments...);
}

/// The same for sqrt(3); triangles. As with CGAL the boundary is refined in every second step of one call.
template <class Graph, class Np = CGAL::parameters::Default_named_parameters, class... Argument>
property_report Sqrt3_subdivision(Graph& pmesh, const Np& np = CGAL::parameters::default_values(),
                                  const Argument&... arguments)
{
    return subdivision(pmesh, like<sqrt3>(library::cgal), np, arguments...);
}

// Schemes that CGAL does not have.

/// Modified Butterfly; triangles.
template <class Graph, class Np = CGAL::parameters::Default_named_parameters, class... Argument>
property_report Butterfly_subdivision(Graph& pmesh, const Np& np = CGAL::parameters::default_values(),
                                      const Argument&... arguments)
{
    return subdivision(pmesh, butterfly(), np, arguments...);
}

/// Interpolatory sqrt(3); closed meshes of triangles.
template <class Graph, class Np = CGAL::parameters::Default_named_parameters, class... Argument>
property_report InterpolatorySqrt3_subdivision(Graph& pmesh, const Np& np = CGAL::parameters::default_values(),
                                               const Argument&... arguments)
{
    return subdivision(pmesh, interpolatory_sqrt3(), np, arguments...);
}

/// Kobbelt's interpolating scheme; quads.
template <class Graph, class Np = CGAL::parameters::Default_named_parameters, class... Argument>
property_report Kobbelt_subdivision(Graph& pmesh, const Np& np = CGAL::parameters::default_values(),
                                    const Argument&... arguments)
{
    return subdivision(pmesh, kobbelt(), np, arguments...);
}

/// Velho and Zorin's 4-8. Any mesh becomes a tri-quad mesh first, as by `tri_quad`, unless its triangles agree on their
/// first edges, as they do after an earlier call.
template <class Graph, class Np = CGAL::parameters::Default_named_parameters, class... Argument>
property_report FourEight_subdivision(Graph& pmesh, const Np& np = CGAL::parameters::default_values(),
                                      const Argument&... arguments)
{
    return subdivision(pmesh, four_eight(), np, arguments...);
}

/// Nasri and Hasbini's ternary scheme.
template <class Graph, class Np = CGAL::parameters::Default_named_parameters, class... Argument>
property_report NasriHasbini_subdivision(Graph& pmesh, const Np& np = CGAL::parameters::default_values(),
                                         const Argument&... arguments)
{
    return subdivision(pmesh, nasri_hasbini(), np, arguments...);
}

/// The mid-edge scheme.
template <class Graph, class Np = CGAL::parameters::Default_named_parameters, class... Argument>
property_report MidEdge_subdivision(Graph& pmesh, const Np& np = CGAL::parameters::default_values(),
                                    const Argument&... arguments)
{
    return subdivision(pmesh, mid_edge(), np, arguments...);
}

/// Zorin and Schroeder's unified family, of bidegree 1 to 9; closed meshes.
template <class Graph, class Np = CGAL::parameters::Default_named_parameters, class... Argument>
property_report Unified_subdivision(Graph& pmesh, int degree, const Np& np = CGAL::parameters::default_values(),
                                    const Argument&... arguments)
{
    return subdivision(pmesh, unified{.degree = degree}, np, arguments...);
}

/// The linear splits, of polygons into quads and of triangles into triangles.
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
