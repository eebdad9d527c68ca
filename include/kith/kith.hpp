// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Includes the headers that most users of kith::kith need. Headers for properties of meshes are
// <kith/carry_properties.hpp> and <kith/convert.hpp>.
#include "evaluator.hpp"
#include "hierarchy.hpp"
#include "mesh.hpp"
#include "plan.hpp"
#include "refine.hpp"
#include "refine_with_fields.hpp"
