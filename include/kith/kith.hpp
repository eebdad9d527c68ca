// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What most users of kith::kith call. Properties of meshes are in <kith/carry_properties.hpp> and <kith/convert.hpp>.
// The folders beside hold what all of it is made of.
#include "evaluator.hpp"
#include "hierarchy.hpp"
#include "mesh.hpp"
#include "plan.hpp"
#include "refine.hpp"
#include "refine_with_fields.hpp"
