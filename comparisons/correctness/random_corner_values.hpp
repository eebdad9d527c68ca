// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "random_meshes.hpp"

#include <kith/core/level/to_native.hpp>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace kith::comparison {

/// A numbering of the values at the corners of a mesh: corners of one vertex with the same number share one value.
struct numbered_corners {
    std::vector<int> numbers;
    int count = 0;
};

/// Cuts the fan of each vertex along the marked edges and gives each piece its own value; at a few vertices joins two
/// pieces. A seam ends at an inner vertex with only one marked edge. Four and more pieces all get different values,
/// since OpenSubdiv may split a value that occurs again there. `sum` counts the cases.
inline numbered_corners cut_along(const basic_mesh<>& mesh, const std::vector<bool>& is_marked, random_numbers& random,
                                  std::map<std::string, std::size_t>& sum)
{
    const level_of<basic_mesh<>> level(mesh);
    numbered_corners result{std::vector<int>(level.corner_count()), 0};
    for (const auto v : level.vertices()) {
        std::vector<int> piece_of; // in the order of the fan
        int cuts = 0;
        for (const auto c : v.corners()) {
            piece_of.push_back(cuts);
            const auto p = c.prev();
            cuts += not p.is_boundary() and is_marked[p.next_edge().index()];
        }
        // At an inner vertex, the corners after the last cut belong to the first piece.
        const int pieces = v.is_boundary() ? cuts + 1 : std::max(cuts, 1);
        const bool joins_two = (pieces == 2 or pieces == 3) and random.one_in(5);
        auto piece = piece_of.begin();
        for (const auto c : v.corners()) {
            const int own = *piece++ % pieces;
            result.numbers[c.index()] = result.count + (joins_two ? own % (pieces - 1) : own);
        }
        result.count += pieces;
        if (cuts != 0)
            ++sum[not v.is_boundary() and cuts == 1 ? "seams that end inside"
                  : joins_two                       ? "vertices of two pieces with one value"
                  : pieces == 2                     ? "vertices of two pieces"
                                                    : "vertices of more pieces"];
    }
    return result;
}

/// Marks one edge in `one_in` at random; none if that is 0.
inline std::vector<bool> marked_edges(const basic_mesh<>& mesh, std::size_t one_in, random_numbers& random)
{
    std::vector<bool> result(mesh.edge_count());
    for (std::size_t e = 0; e < result.size(); ++e)
        result[e] = one_in != 0 and random.one_in(one_in);
    return result;
}

} // namespace kith::comparison
