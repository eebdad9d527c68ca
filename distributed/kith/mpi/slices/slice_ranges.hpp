// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/tiles/ply/ply_slice.hpp>

#include <kith/core/base/error.hpp>
#include <kith/tiles/part/partition.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace kith::mpi {

/// The faces and vertices that each rank reads: rank r reads the faces [face[r], face[r + 1]), and vertices likewise.
/// The faces are those of block_partition.
struct slice_ranges {
    std::vector<global_id> face, vertex;

    slice_ranges(global_id vertices, global_id faces, int degree, int ranks)
    {
        const auto parts = std::size_t(ranks);
        for (std::size_t r = 0; r <= parts; ++r) {
            vertex.push_back(vertices / parts * r + std::min<global_id>(r, vertices % parts));
            global_id low = 0;
            for (global_id end = faces; low < end;) { // finds the first face whose part is not below r
                const global_id middle = low + (end - low) / 2;
                const auto part = kith::detail::block_of(
                    middle * global_id(degree), degree, faces * global_id(degree), parts);
                (part < r ? low = middle + 1 : end = middle);
            }
            face.push_back(low);
        }
        face.back() = faces;
    }
    [[nodiscard]] std::size_t rank_of_face(global_id f) const { return rank_of(face, f); }
    [[nodiscard]] std::size_t rank_of_vertex(global_id v) const { return rank_of(vertex, v); }

private:
    static std::size_t rank_of(const std::vector<global_id>& first, global_id x)
    {
        return std::size_t(std::ranges::upper_bound(first, x) - first.begin()) - 1;
    }
};

/// Rotates each face to start at its smallest vertex, as make_mesh does. Local. Errors: mesh_error for a face that
/// contains a vertex twice, and for coordinates that are not finite.
template <class Point>
void start_at_smallest(mesh_slice<Point>& slice)
{
    const auto degree = std::ptrdiff_t(slice.degree);
    for (auto face = slice.corners.begin(); face != slice.corners.end(); face += degree) {
        std::rotate(face, std::min_element(face, face + degree), face + degree);
        auto sorted = std::vector<global_id>(face, face + degree);
        std::ranges::sort(sorted);
        if (std::ranges::adjacent_find(sorted) != sorted.end())
            throw mesh_error(
                "face " +
                std::to_string(slice.first_face + global_id(face - slice.corners.begin()) / global_id(degree)) +
                " contains a vertex twice; remove the repeated corner or the face");
    }
    for (std::size_t v = 0; v < slice.points.size(); ++v)
        if (not std::ranges::all_of(slice.points[v], [](double x) { return std::isfinite(x); }))
            throw mesh_error("vertex " + std::to_string(slice.first_vertex + v) +
                             ": a coordinate is not a finite number; give finite coordinates");
}

} // namespace kith::mpi
