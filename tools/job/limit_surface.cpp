// SPDX-License-Identifier: BSD-3-Clause
#include "limit_surface.hpp"

#include <kith/limits/limit_surface.hpp>
#include <kith/limits_of_tile.hpp>

#include <algorithm>
#include <array>
#include <utility>
#include <variant>

namespace kith::tool {

namespace {

surface_normals take(basic_mesh<>& mesh, limit_surface<std::array<double, 3>> limits, bool with_corners)
{
    std::ranges::copy(std::as_const(limits.positions), mesh.points().begin());
    surface_normals result;
    if (with_corners)
        result.of_corners = normals_of_corners(mesh, limits);
    result.of_vertices = std::move(limits.normals);
    return result;
}

} // namespace

bool has_sides(const any_scheme& scheme)
{
    return std::visit(
        []<class Scheme>(const Scheme& s) {
            if constexpr (scheme_with_creases<Scheme>)
                return std::ranges::any_of(s.sharpness.edges(),
                                           [](const auto& edge) { return edge.second == infinitely_sharp; });
            else
                return false;
        },
        scheme);
}

surface_normals move_to_limit(basic_mesh<>& mesh, const any_scheme& scheme, bool with_corners)
{
    auto limits = std::visit([&](const auto& s) { return limit_surface_of(mesh, s); }, scheme);
    return take(mesh, std::move(limits), with_corners);
}

void move_to_limit(tile<std::array<double, 3>>& part, const any_scheme& scheme, bool with_corners)
{
    auto limits = std::visit([&](const auto& s) { return limit_surface_of(part, s).surface; }, scheme);
    surface_normals normals = take(part.mesh, std::move(limits), with_corners);
    part.normals = std::move(normals.of_vertices);
    part.corner_normals = std::move(normals.of_corners);
}

int rings_for_limit(const any_scheme& scheme)
{
    return std::visit([](const auto& s) { return rings_for_limits(s); }, scheme);
}

std::optional<int> rings_of_last_level(const any_scheme& scheme, bool limit, bool has_attributes)
{
    if (limit)
        return rings_for_limit(scheme);
    return has_attributes ? std::optional(0) : std::nullopt;
}

} // namespace kith::tool
