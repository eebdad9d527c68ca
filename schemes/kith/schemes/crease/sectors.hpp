// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "creases.hpp"

#include <kith/core/level/elements.hpp>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace kith {

/// A sector of a vertex: consecutive faces around it, counter-clockwise, between two infinitely sharp edges. Boundary
/// edges are infinitely sharp. An inner vertex with at most one infinitely sharp edge has a single, closed sector.
template <level Level>
struct vertex_sector {
    corner<Level> first, last; ///< the vertex's corners in the first and in the last of these faces
    std::size_t faces = 0;
    bool is_closed = false; ///< true if it has all faces of an inner vertex
    bool has_sharp_edge = true;

    /// Returns the other end of the edge that begins the sector; last_end that of the edge that ends it.
    [[nodiscard]] vertex<Level> first_end() const { return first.next().v(); }
    [[nodiscard]] vertex<Level> last_end() const { return last.prev().v(); }
};

/// Calls use(sector) for each sector of a vertex, counter-clockwise, beginning at the first infinitely sharp edge of
/// the fan. Cost: O(valence log sharp elements).
template <level Level, class Use>
void for_each_sector(const vertex<Level>& v, const creases& sharp, const Use& use)
{
    const auto begins = [&sharp](const corner<Level>& c) { return sharp.sharpness(c.next_edge()) == infinitely_sharp; };
    std::optional<corner<Level>> start;
    std::size_t sharp_edges = v.is_boundary() ? 1 : 0; // the last edge of a boundary vertex begins no sector
    for (const auto& c : v.corners())
        if (begins(c)) {
            ++sharp_edges;
            if (not start)
                start = c;
        }
    std::optional<vertex_sector<Level>> part;
    for (const auto& c : start.value_or(v.first_corner()).fan_from_here()) {
        if (part and begins(c)) {
            use(std::as_const(*part));
            part.reset();
        }
        if (not part)
            part.emplace(vertex_sector<Level>{c, c, 0, sharp_edges < 2, sharp_edges > 0});
        part->last = c;
        ++part->faces;
    }
    use(std::as_const(*part));
}

/// A mask as a list of vertices with their weights, for `weighted`.
template <level Level>
using mask_row = std::vector<std::pair<vertex<Level>, double>>;

/// Returns a mask. It weighs the vertex of a sector by `of_vertex` and the other end of its j-th edge by of_edge(j). If
/// `WithOpposites`, it weighs the vertex opposite in the j-th face by of_face(j).
template <bool WithOpposites, level Level, class OfEdge, class OfFace>
mask_row<Level> row_over(const vertex_sector<Level>& part, double of_vertex, const OfEdge& of_edge,
                         const OfFace& of_face)
{
    mask_row<Level> row{{part.first.v(), of_vertex}};
    std::size_t j = 0;
    for (const auto& c : part.first.fan_from_here()) {
        if (j == part.faces)
            break;
        row.emplace_back(c.next().v(), of_edge(j));
        if constexpr (WithOpposites)
            row.emplace_back(c.next().next().v(), of_face(j));
        ++j;
    }
    if (not part.is_closed)
        row.emplace_back(part.last_end(), of_edge(j));
    return row;
}

} // namespace kith
