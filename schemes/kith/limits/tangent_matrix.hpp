// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limit.hpp"

#include <kith/core/mask/stencil.hpp>
#include <kith/hierarchy.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

namespace kith {

namespace detail {

/// Returns true if all weights are finite. Tangent masks have infinite weights if a surface has no tangent plane: those
/// of Catmull-Clark at inner vertices of valence 2.
inline bool has_finite_weights(const stencil_row& row)
{
    return std::ranges::all_of(row.entries, [](const auto& entry) { return std::isfinite(entry.second); });
}

} // namespace detail

/// Two tangents of the limit surface at each vertex, a row per vertex in each matrix, as weights of the vertices of
/// another level. Their cross product points outward for counter-clockwise faces.
struct tangent_matrices {
    subdivision_matrix first, second;
};

/// Returns the tangents at the vertices of level `to` as weights of the vertices of level `from`. They use the
/// closed-form masks of limit_normals, so their normalised cross products are its normals. Both rows are empty if no
/// mask is known on level `to`, or it has no finite weights; docs/schemes.md, Limit, lists these cases. Rows sum to
/// zero; the length of a tangent depends on the mask. For schemes with tangent masks. Errors: mesh_error unless from <=
/// to. Cost: as that of matrix(from, to).
template <mesh M, scheme Scheme>
tangent_matrices tangent_matrices_of(const hierarchy<M, Scheme>& levels, int from, int to)
{
    const auto& level = levels.elements(to);
    using level_type = typename hierarchy<M, Scheme>::level_type;
    static_assert(has_limit_tangents<Scheme, vertex<level_type>, level_type>,
                  "this scheme has no tangent masks for vertices; docs/schemes.md, Limit, lists those that have");
    const std::size_t columns = levels.elements(from).vertex_count();
    const auto unit = unit_rows(columns);
    const auto rows = levels.carry(from, to, std::span<const stencil_row>(unit));
    const attribute_values<stencil_row> values({rows.data(), rows.size()});
    storage<stencil_row> first(rows.size()), second(rows.size());
    const auto& rules = limit_rules<Scheme>::on(levels.scheme(to), level);
    for (const auto v : level.vertices())
        limit_rules<Scheme>::tangents(rules, v, [&](const auto& one, const auto& other) {
            stencil_row a = one.evaluate(values), b = other.evaluate(values);
            if (not detail::has_finite_weights(a) or not detail::has_finite_weights(b))
                return;
            first[v.index()] = std::move(a);
            second[v.index()] = std::move(b);
        });
    return {make_matrix(first, columns), make_matrix(second, columns)};
}

} // namespace kith
