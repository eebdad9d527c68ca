// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Splits for user-defined schemes: the columns and the connectivity of quads, triangles, duals and more.

#include <kith/schemes/split/bisection_split.hpp>
#include <kith/schemes/split/dual_split.hpp>
#include <kith/schemes/split/mid_edge_split.hpp>
#include <kith/schemes/split/quad_split.hpp>
#include <kith/schemes/split/sqrt3_split.hpp>
#include <kith/schemes/split/ternary_split.hpp>
#include <kith/schemes/split/tri_quad_splits.hpp>
#include <kith/schemes/split/triangle_split.hpp>
