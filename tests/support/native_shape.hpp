// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shapes.hpp"

#include <kith/core/mesh/make_mesh.hpp>

#include <cstdint>

using mesh3d = kith::basic_mesh<std::array<double, 3>, std::uint32_t>;

/// Returns a shape as a native mesh.
inline mesh3d native(const shapes::shape& s)
{
    return kith::make_mesh(s.points, s.faces);
}
