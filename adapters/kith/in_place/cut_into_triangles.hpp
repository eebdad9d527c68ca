// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "carried_values.hpp"
#include "refine_in_place.hpp"

#include <kith/core/mesh/make_mesh.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith::in_place {

/// Cuts each face into a fan of triangles around its first corner, and carries the values of its elements. Triangles
/// inherit from their face. Sides and corners of triangles inherit from the old edges and corners that they are.
/// Vertices stay. Cost: O(corners log(corners)).
template <class Point, class Number>
void cut_into_triangles(refined<Point>& surface, carried_values<Number>& values)
{
    using index = std::uint32_t;
    const connectivity<index> old = surface.mesh.topology();
    std::vector<std::array<index, 3>> faces;
    std::vector<index> parents, corners; // those of the old mesh
    for (std::size_t f = 0; f < old.faces; ++f) {
        const index first = old.first_corner(f);
        for (index c = first + 1; c + 1 < old.first_corner(f + 1); ++c) {
            faces.push_back({old.corner_vertex[first], old.corner_vertex[c], old.corner_vertex[c + 1]});
            parents.push_back(index(f));
            corners.insert(corners.end(), {first, c, c + 1});
        }
    }
    std::map<std::pair<index, index>, index> edges;
    const auto key = [](index a, index b) { return std::pair(std::min(a, b), std::max(a, b)); };
    for (std::size_t e = 0; e < old.edges(); ++e)
        edges[key(old.ends(e)[0], old.ends(e)[1])] = index(e);
    auto mesh = make_mesh(std::vector<Point>(surface.mesh.points().begin(), surface.mesh.points().end()), faces);
    const auto& t = mesh.topology();

    for (auto& each : values.corner_means) {
        storage<typename std::remove_cvref_t<decltype(each)>::value_type> means(t.corners());
        for (std::size_t c = 0; c < means.size(); ++c)
            means[c] = each[corners[c]];
        each = std::remove_cvref_t<decltype(each)>(means);
    }
    inherit_from(values.face_heirs, t.faces, [&](std::size_t f) { return parents[f]; });
    inherit_from(values.edge_heirs, t.edges(), [&](std::size_t e) {
        const auto found = edges.find(key(t.ends(e)[0], t.ends(e)[1]));
        return found == edges.end() ? no_element : found->second;
    });
    inherit_from(values.corner_heirs, t.corners(), [&](std::size_t c) { // along the side that leads to the corner
        const std::size_t before = c - c % 3 + (c % 3 + 2) % 3;
        const std::size_t face = parents[c / 3];
        const index next = corners[before] + 1 == old.first_corner(face + 1) ? old.first_corner(face)
                                                                             : corners[before] + 1;
        return next == corners[c] ? corners[c] : no_element;
    });
    surface.mesh = {storage<Point>(mesh.points()), mesh.topology(), surface.mesh.generation()};
}

} // namespace kith::in_place
