// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "all_shapes.hpp"
#include "native_shape.hpp"

#include <kith/tiles/number/column_facts.hpp>
#include <kith/tri_quad.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

inline shapes::shape shape_of(const mesh3d& mesh)
{
    shapes::shape result{{mesh.points().begin(), mesh.points().end()}, {}};
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        result.faces.emplace_back(mesh.face(f).begin(), mesh.face(f).end());
    return result;
}

inline mesh3d of_generation(const mesh3d& mesh, int generation)
{
    return {kith::storage<shapes::point>(mesh.points()), mesh.topology(), generation};
}

/// Returns the surface with vertices and faces in random order. Faces then begin at another corner, their smallest
/// vertex. Marks of edges are kept if the scheme has marks.
template <class Scheme>
mesh3d shuffled(const mesh3d& mesh, std::uint32_t seed)
{
    const auto shape = shapes::shuffled(shape_of(mesh), seed);
    auto result = native(shape);
    if constexpr (kith::marks_edges<Scheme>) {
        std::vector<std::pair<std::uint32_t, std::uint32_t>> marked;
        for (const auto& f : shape.faces)
            marked.emplace_back(f[0], f[1]);
        result = kith::mark_edges(result, std::move(marked));
    }
    return of_generation(result, mesh.generation());
}
