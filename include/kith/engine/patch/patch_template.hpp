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

/// The result of some steps on a face and its neighbourhood, for all faces whose neighbourhoods are alike. It tells
/// where the coarse points are, how they become the fine ones, and which numbers are written where. It is made once, by
/// the code of the scheme. A face owns its children, those of the edges whose left face it is, and those of the
/// vertices whose fans start in it. For these it writes the points and first corners of vertices, the corners of faces,
/// and the half-edges at these corners. At the boundary it also writes that nothing lies across.
template <std::floating_point Scalar, std::unsigned_integral Index>
struct patch_template {
    using numbers = patch_numbers<Index>;

    std::vector<walk_step> steps;                      ///< to the faces that inputs and sources lie in
    std::vector<walked_element> inputs;                ///< the vertices that fill the first slots of the program
    lane_program<Scalar> program;                      ///< its outputs are the points of the owned vertices
    std::vector<walked_element> sources;               ///< the elements from whose numbers the others follow
    std::vector<typename numbers::multiple> multiples; ///< those that only numbers of faces need come last,
    std::size_t multiples_of_others;                   ///< after this many others
    std::vector<typename numbers::run> vertices, corners, halfedges; ///< the places that are written
    std::vector<typename numbers::face_run> faces;                   ///< the faces of the corners, in the same order
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
