// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Includes the doors that most users of kith::kith need. Properties of meshes are in <kith/carry_properties.hpp> and
// <kith/convert.hpp>.
#include "evaluator.hpp"
#include "hierarchy.hpp"
#include "mesh.hpp"
#include "plan.hpp"
#include "refine.hpp"
#include "refine_with_fields.hpp"
