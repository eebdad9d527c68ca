// SPDX-License-Identifier: BSD-3-Clause
#include "limit_surface.hpp"

#include <kith/limit/limit_surface.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <variant>

namespace kith::tool {

storage<std::array<double, 3>> move_to_limit(basic_mesh<>& mesh, const any_scheme& scheme,
                                             std::span<const unsigned char> marks)
{
    auto limits = std::visit([&](const auto& s) { return limit_surface_around(mesh, s, marks); }, scheme);
    std::ranges::copy(limits.positions, mesh.points().begin());
    return std::move(limits.normals);
}

void move_to_limit(tile<std::array<double, 3>>& part, const any_scheme& scheme)
{
    std::vector<unsigned char> marks(part.mesh.vertex_count(), 0);
    for (std::size_t f = 0; f < part.mesh.face_count(); ++f)
        if (part.owns_face(f))
            for (const auto v : part.mesh.face(f))
                marks[v] = 1;
    part.normals = move_to_limit(part.mesh, scheme, marks);
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
