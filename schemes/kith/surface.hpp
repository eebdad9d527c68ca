// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The limit surface anywhere in the faces of a mesh: `surface_locator`, `normals_of`, `curvatures_of`,
/// `quadrature_places`, `tessellate`.

#include <kith/surface/curvature.hpp>
#include <kith/surface/quadrature.hpp>
#include <kith/surface/surface_locator.hpp>
#include <kith/surface/tessellation/tessellate.hpp>
