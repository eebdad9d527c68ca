// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "patch_numbers.hpp"

#include <kith/engine/lane/lane_program.hpp>
#include <kith/engine/neighbourhood/element_finder.hpp>
#include <kith/engine/neighbourhood/face_walk.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace kith {

/// What some steps make of a face and its neighbourhood, for all faces whose neighbourhoods are alike: where the coarse
/// points are, how they become the fine ones, and which numbers are written where. Made once, by the scheme's own text.
/// A face owns what it, its left sides of edges and the starts of fans in it give birth to: the points and starts of
/// these vertices, the corners of these faces, what lies on the half-edges at these corners, and that nothing lies
/// across where they are at the boundary.
template <std::floating_point Scalar, std::unsigned_integral Index>
struct patch_template {
    using numbers = patch_numbers<Index>;

    std::vector<walk_step> steps;                      ///< to the faces that inputs and sources lie in
    std::vector<walked_element> inputs;                ///< the vertices that fill the first slots of the program
    lane_program<Scalar> program;                      ///< its outputs are the points of the owned vertices
    std::vector<walked_element> sources;               ///< the elements whose numbers others follow from
    std::vector<typename numbers::multiple> multiples; ///< those that only the numbers of faces follow from come last,
    std::size_t multiples_of_others;                   ///< after so many
    std::vector<typename numbers::run> vertices, corners, halfedges; ///< the places that are written
    std::vector<typename numbers::face_run> faces;                   ///< that the corners are of, in the same order
    typename numbers::list vertex_corner, vertex_halfedge, corner_vertex, corner_halfedge,
        halfedge_corner; ///< what is written, run after run

    [[nodiscard]] std::size_t bytes() const
    {
        const auto of = [](const auto&... list) { return ((list.size() * sizeof(list[0])) + ...); };
        const auto of_numbers = [&](const auto&... list) { return (of(list.offset, list.of) + ...); };
        return program.bytes() + of(steps, inputs, sources, multiples, vertices, corners, halfedges, faces) +
               of_numbers(vertex_corner, vertex_halfedge, corner_vertex, corner_halfedge, halfedge_corner);
    }
};

} // namespace kith
