// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "back_end.hpp"
#include "limit_surface.hpp"

#include <kith/core/level/to_native.hpp>
#include <kith/hierarchy.hpp>
#include <kith/tags_of_creases.hpp>

#include <algorithm>
#include <array>
#include <utility>
#include <variant>

namespace kith::tool {

/// Returns true if the remaining sharpness is requested and some edge or vertex is still sharp.
inline bool keeps_tags(const refine_request& request)
{
    return request.with_tags and sharp_after(request.scheme, request.levels).any();
}

/// Throws mesh_error for a mesh that the scheme does not take, and for a job that needs more memory than it may have.
inline void require_possible(const refine_request& request, const basic_mesh<>& control, mesh_kind mesh)
{
    require_scheme_takes(request.scheme, control);
    require_memory(request.scheme,
                   control,
                   request.levels,
                   {.mesh = mesh,
                    .limit = request.limit,
                    .corner_normals = request.corner_normals,
                    .holes = not request.holes.empty(),
                    .tags = keeps_tags(request),
                    .attributes = request.counted},
                   request.memory);
}

/// Returns the mesh with points of another type.
template <class To, class From>
basic_mesh<To> with_points(const basic_mesh<From>& mesh, int generation)
{
    storage<To> points(mesh.vertex_count());
    std::ranges::transform(mesh.points(), points.begin(), [](const From& p) {
        return affine<To>::store(typename affine<To>::sum(affine<From>::load(p)));
    });
    return {std::move(points), mesh.topology(), generation};
}

/// Adds the requested data that the edges and the scheme of the last level tell: the remaining sharpness, the limit
/// positions and the normals.
template <scheme Scheme>
void add_sharpness_and_limit(refined_mesh& refined, const Scheme& scheme, const refine_request& request)
{
    if constexpr (scheme_with_creases<Scheme>)
        if (request.with_tags)
            refined.tags = io::tags_of(scheme.sharpness, level_of<basic_mesh<>>(refined.mesh));
    if (request.limit) {
        auto normals = move_to_limit(refined.mesh, scheme, request.corner_normals);
        refined.normals = std::move(normals.of_vertices);
        refined.corner_normals = std::move(normals.of_corners);
    }
}

/// Refines on meshes of type M, with one mesh for each level.
template <class M>
refined_mesh refine_on(const basic_mesh<>& control, const refine_request& request)
{
    using traits = mesh_traits<M>;
    return std::visit(
        [&]<class Scheme>(const Scheme& scheme) {
            hierarchy<M, Scheme> levels(
                traits::build(with_points<typename traits::point>(control, control.generation())),
                scheme,
                {.memory_limit = request.memory.bytes});
            levels.refine(request.levels);
            const int generation = control.generation() + request.levels; // which other libraries forget
            refined_mesh refined{with_points<std::array<double, 3>>(to_native(levels.finest()), generation)};
            refined.edges = refined.mesh.edge_count();
            if constexpr (scheme_with_creases<Scheme>)
                refined.holes = levels.carry(0, request.levels, request.holes);
            refined.attributes = request.attributes.carried(
                [&](const auto& field) { return levels.carry(0, request.levels, field); });
            add_sharpness_and_limit(refined, levels.scheme(request.levels), request);
            return refined;
        },
        request.scheme);
}

} // namespace kith::tool
