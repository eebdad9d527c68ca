// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/counts.hpp>
#include <kith/core/mesh/connectivity.hpp>
#include <kith/numbering/step/surface_order.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <utility>
#include <vector>

namespace kith {

/// Some faces of a mesh with their vertices and edges. The elements are numbered from 0 in the order of the mesh.
template <std::unsigned_integral Index>
struct closure_of_faces {
    std::vector<Index> vertices, edges, faces; ///< for each element its number in the mesh, increasing
    element_numbers<Index> numbers;            ///< for each element of the mesh its number here; `none` for others

    /// Numbers the closure of `of_faces`, which increase and all have this degree. Cost: O(elements of the mesh).
    closure_of_faces(const connectivity<Index>& mesh, std::vector<Index> of_faces, std::size_t degree)
        : faces(std::move(of_faces))
    {
        numbers.degree = degree;
        numbers.vertices = unnumbered(mesh.vertices);
        numbers.edges = unnumbered(mesh.edges());
        numbers.faces = unnumbered(mesh.faces);
        for (const Index f : faces) {
            numbers.faces[f] = 0;
            for (Index c = mesh.first_corner(f); c < mesh.first_corner(f + std::size_t(1)); ++c) {
                numbers.vertices[mesh.corner_vertex[c]] = 0;
                numbers.edges[mesh.corner_halfedge[c] / 2] = 0;
            }
        }
        number(numbers.vertices, vertices);
        number(numbers.edges, edges);
        faces.clear();
        number(numbers.faces, faces);
    }

    /// Returns the counts of the closure. A half-edge without one of the faces is at the boundary.
    [[nodiscard]] counts count() const
    {
        return {vertices.size(), edges.size(), faces.size(), 2 * edges.size() - numbers.degree * faces.size()};
    }

private:
    static storage<Index> unnumbered(std::size_t size)
    {
        storage<Index> result(size);
        std::ranges::fill(result, connectivity<Index>::none);
        return result;
    }
    /// Numbers the elements that are marked by 0, and lists them.
    static void number(storage<Index>& all, std::vector<Index>& listed)
    {
        for (std::size_t i = 0; i < all.size(); ++i)
            if (all[i] == 0) {
                all[i] = Index(listed.size());
                listed.push_back(Index(i));
            }
    }
};

} // namespace kith
