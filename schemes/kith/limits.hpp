// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The limit surface at the vertices of a level: `limit_surface_of`, its matrices, and `limit_evaluator` for points
/// that move.

#include <kith/limits/limit_evaluator.hpp>
#include <kith/limits/limit_matrix.hpp>
#include <kith/limits/limit_surface.hpp>
#include <kith/limits/tangent_matrix.hpp>
