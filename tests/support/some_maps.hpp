// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cgal_mesh.hpp"
#include "shapes.hpp"

#include <kith/cgal_properties.hpp>
#include <kith/convert.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

/// A mesh of CGAL with property maps, and functions that read properties of any mesh by name.
namespace some_maps {

using kernel = CGAL::Simple_cartesian<double>;
using cgal_mesh = surface_mesh<kernel>;
using vertex = cgal_mesh::Vertex_index;
using edge = cgal_mesh::Edge_index;
using face = cgal_mesh::Face_index;
using halfedge = cgal_mesh::Halfedge_index;
using uv = std::array<float, 2>;
using names = std::vector<std::string>;

inline cgal_mesh cgal(const shapes::shape& s)
{
    return user_mesh<cgal_mesh>::make(s.points, s.faces);
}

/// Adds property maps on all kinds of elements, boundary half-edges included.
inline cgal_mesh with_maps(cgal_mesh m)
{
    auto color = m.add_property_map<vertex, CGAL::IO::Color>("v:color").first;
    auto normal = m.add_property_map<vertex, kernel::Vector_3>("v:normal").first;
    auto place = m.add_property_map<vertex, kernel::Point_3>("v:place").first;
    for (const auto v : m.vertices()) {
        color[v] = CGAL::IO::Color(7 * std::uint8_t(v), 200, 255);
        normal[v] = kernel::Vector_3(1, 0.1 * int(v), 0);
        place[v] = kernel::Point_3(0, 0, 0.1 * int(v));
    }
    auto is_sharp = m.add_property_map<edge, bool>("e:is_sharp").first;
    for (const auto e : m.edges())
        is_sharp[e] = e.idx() % 3 == 0;
    auto material = m.add_property_map<face, std::string>("f:material").first;
    for (const auto f : m.faces())
        material[f] = "material " + std::to_string(f.idx());
    auto texture = m.add_property_map<halfedge, uv>("h:uv").first;
    for (const auto h : m.halfedges())
        texture[h] = {float(h.idx()), float(h.idx() % 5)};
    return m;
}

template <class Handle, class T, class M>
auto property(const M& mesh, const char* name)
{
    const auto found = kith::property_access<M>::template find<Handle, T>(mesh, name);
    EXPECT_TRUE(bool(found)) << name;
    return found;
}

/// Returns the values of a property in the order of the elements.
template <class Handle, class T, class M>
std::vector<T> values(const M& mesh, const char* name)
{
    std::vector<T> result;
    const auto from = property<Handle, T>(mesh, name);
    for (const auto x : kith::detail::all_handles<Handle>(mesh))
        result.push_back(from[x]);
    return result;
}

} // namespace some_maps
