// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What most users of kith::kith call. Properties of meshes are in <kith/carry_properties.hpp>, <kith/property_mesh.hpp>
// and <kith/convert.hpp>; the folders beside hold what all of it is made of.
#include "evaluator.hpp"
#include "hierarchy.hpp"
#include "plan.hpp"
#include "refine.hpp"
#include "refine_with_fields.hpp"

#include <kith/mesh/make_mesh.hpp>
