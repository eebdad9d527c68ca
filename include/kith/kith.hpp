// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// All that a user of kith::kith calls; the folders beside hold what it is made of.
#include "evaluator.hpp"
#include "hierarchy.hpp"
#include "plan.hpp"
#include "refine.hpp"
#include "refine_in_surface_order.hpp"
#include "refine_with_fields.hpp"

#include <kith/mesh/make_mesh.hpp>
