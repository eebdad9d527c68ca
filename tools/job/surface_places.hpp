// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "schemes.hpp"

#include <kith/surface/located_places.hpp>
#include <kith/surface/surface_place.hpp>
#include <kith/surface/tessellation/tessellate.hpp>

#include <array>
#include <span>
#include <string_view>

namespace kith::tool {

using surface_triangles = tessellation<std::array<double, 3>>;

/// Tessellates a control mesh. `task` names the task in errors. Errors: usage_error unless the scheme is Catmull-Clark
/// or Loop; those of tessellate.
surface_triangles tessellate_with(const any_scheme& scheme, std::string_view task, const basic_mesh<>& control,
                                  const tessellation_options& options);

/// Locates places on the limit surface of a control mesh. Errors: as tessellate_with.
located_places locate_with(const any_scheme& scheme, std::string_view task, const basic_mesh<>& control,
                           std::span<const surface_place> places);

/// Returns true for the schemes that these functions take.
bool has_places(const any_scheme& scheme);

} // namespace kith::tool
