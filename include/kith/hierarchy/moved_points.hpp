// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/error.hpp>
#include <kith/core/base/storage.hpp>
#include <kith/core/level/level.hpp>
#include <kith/core/mesh/make_mesh.hpp>
#include <kith/core/mesh/mesh_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>

namespace kith {

/// Throws mesh_error if a new point of a level is not finite. Cost: O(points).
template <class Point>
void require_finite(int level, std::span<const Point> points)
{
    const auto bad = std::ranges::find_if_not(points, [](const Point& p) { return detail::point_is_finite(p); });
    if (bad != points.end())
        throw mesh_error("level " + std::to_string(level) + ": the new point of vertex " +
                         std::to_string(bad - points.begin()) + " is not finite; give all vertices finite coordinates");
}

/// Moves the vertices of a mesh, which `here` walks on, to these points. Precondition: there is a point per vertex, by
/// dense numbers.
template <movable_mesh M, level Level>
void set_points(M& mesh, const Level& here, const storage<typename mesh_traits<M>::point>& points)
{
    auto* const all = mesh_traits<M>::points(mesh);
    for (std::size_t v = 0; v < points.size(); ++v)
        all[mesh_traits<M>::index(mesh, here.vertex_at(v))] = points[v];
}

} // namespace kith
