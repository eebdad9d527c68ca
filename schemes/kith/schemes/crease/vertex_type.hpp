// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "boundary.hpp"
#include "creases.hpp"

#include <kith/core/base/error.hpp>
#include <kith/core/level/to_native.hpp>

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <vector>

namespace kith {

/// The type of a vertex in the rules of Catmull-Clark and Loop. Thesis 4.3.1.1; the rules themselves DeRose, Kass &
/// Truong 1998, section 3.
enum class vertex_type : unsigned char {
    inner,           ///< smooth: an inner vertex with one sharp edge (a dart) or none
    boundary,        ///< on the boundary curve
    corner,          ///< stays: sharp itself, a kept boundary corner, or inside with three sharp edges or more
    crease,          ///< an inner vertex on the curve along its two sharp edges
    boundary_crease, ///< stays: creases end there at the boundary
};

/// Returns the type of a vertex of a level with these creases. Cost: O(valence log sharp elements).
template <level Level>
vertex_type type_of(const vertex<Level>& v, const creases& sharp, boundary_corner corners = boundary_corner::kept)
{
    std::size_t sharp_inner_edges = 0;
    for (const auto e : v.edges())
        sharp_inner_edges += not e.is_boundary() and sharp.of_edge(e.index()) > 0;
    if (sharp.of_vertex(v.index()) > 0)
        return vertex_type::corner;
    if (v.is_boundary())
        return corners == boundary_corner::kept and v.face_count() == 1 ? vertex_type::corner
               : sharp_inner_edges > 0                                  ? vertex_type::boundary_crease
                                                                        : vertex_type::boundary;
    return sharp_inner_edges >= 3   ? vertex_type::corner
           : sharp_inner_edges == 2 ? vertex_type::crease
                                    : vertex_type::inner;
}

/// Returns the types of all vertices of a mesh, by their dense numbers. Errors: mesh_error for a mesh without edges.
/// Cost: O(corners log sharp elements).
template <mesh M>
std::vector<vertex_type> vertex_types(const M& mesh, const creases& sharp,
                                      boundary_corner corners = boundary_corner::kept)
{
    require_edges(mesh);
    const level_of<M> level(mesh);
    std::vector<vertex_type> result;
    result.reserve(level.vertex_count());
    for (const auto v : level.vertices())
        result.push_back(type_of(v, sharp, corners));
    return result;
}

/// Makes v a vertex of this type by setting sharpness. A corner is itself sharp. A crease has two sharp inner edges,
/// given by `along`, a boundary crease one or more; other types take no edges. All types but the corner reset the
/// sharpness of v and of its other inner edges, which may change the types of their other ends. Precondition: sharpness
/// > 0. Errors: mesh_error if v cannot be of this type; the creases are then unchanged. Cost: O(valence log sharp
/// elements), and O(sharp elements) if one of them is new.
template <level Level>
void set_type(creases& sharp, const vertex<Level>& v, vertex_type type, std::initializer_list<edge<Level>> along = {},
              double sharpness = infinitely_sharp, boundary_corner corners = boundary_corner::kept)
{
    const auto refuse = [&v](const std::string& why) {
        throw mesh_error("vertex " + std::to_string(v.index()) + ": " + why);
    };
    const bool boundary_type = type == vertex_type::boundary or type == vertex_type::boundary_crease;
    if (type != vertex_type::corner and v.is_boundary() != boundary_type)
        refuse(v.is_boundary() ? "lies on the boundary; make it boundary, boundary_crease or corner"
                               : "lies inside; make it inner, crease or corner");
    if (boundary_type and corners == boundary_corner::kept and v.face_count() == 1)
        refuse("is a boundary corner, which is kept; refine with boundary_corner::smoothed");
    for (auto e = along.begin(); e != along.end(); ++e)
        if (e->is_boundary() or not(e->org() == v or e->dst() == v) or std::find(along.begin(), e, *e) != e)
            refuse("edge " + std::to_string(e->index()) +
                   " is not an inner edge of this vertex or is given twice; give other edges");
    const bool fits = type == vertex_type::crease            ? along.size() == 2
                      : type == vertex_type::boundary_crease ? along.size() > 0
                                                             : along.size() == 0;
    if (not fits)
        refuse("was given " + std::to_string(along.size()) +
               " edges; a crease takes two, a boundary crease one or more, other types none");

    sharp.sharpen_vertex(v.index(), type == vertex_type::corner ? sharpness : 0);
    if (type == vertex_type::corner)
        return;
    for (const auto e : v.edges())
        if (not e.is_boundary())
            sharp.sharpen_edge(e.index(), std::find(along.begin(), along.end(), e) != along.end() ? sharpness : 0);
}

} // namespace kith
