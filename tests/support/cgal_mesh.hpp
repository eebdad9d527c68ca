// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include "user_mesh.hpp"

#include <kith/cgal.hpp>

#include <CGAL/boost/graph/helpers.h>

#include <concepts>
#include <stdexcept>
#include <string>

using epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using epeck = CGAL::Exact_predicates_exact_constructions_kernel;

template <class Kernel>
using surface_mesh = CGAL::Surface_mesh<CGAL::Point_3<Kernel>>;

/// Returns the property map of this name and type; throws if there is none. CGAL 5 finds maps as a pair, CGAL 6 as an
/// optional.
template <class Index, class T, class Point>
auto map_of(const CGAL::Surface_mesh<Point>& mesh, const char* name)
{
    const auto found = mesh.template property_map<Index, T>(name);
    if constexpr (requires { found.has_value(); })
        return found.value();
    else if (found.second)
        return found.first;
    else
        throw std::logic_error("there is no map of this name and type");
}

template <class Point>
struct user_mesh<CGAL::Surface_mesh<Point>> {
    using mesh = CGAL::Surface_mesh<Point>;
    using scalar = kith::scalar_of<Point>;
    static constexpr bool triangles_only = false;
    static constexpr double tolerance = std::same_as<scalar, float> ? 1e-6 : 1e-13;

    static mesh make(const std::vector<std::array<double, 3>>& points,
                     const std::vector<std::vector<std::size_t>>& faces)
    {
        mesh result;
        for (const auto& [x, y, z] : points)
            result.add_vertex(Point(scalar(x), scalar(y), scalar(z)));
        for (const auto& face : faces) {
            std::vector<typename mesh::Vertex_index> corners;
            for (const std::size_t v : face)
                corners.emplace_back(typename mesh::size_type(v));
            if (result.add_face(corners) == mesh::null_face())
                throw std::logic_error("CGAL does not take this face");
        }
        return result;
    }
    static std::string complaints(const mesh& m)
    {
        return m.is_valid(false) and CGAL::is_valid_polygon_mesh(m) ? "" : "not valid";
    }
};
