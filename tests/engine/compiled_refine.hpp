// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/cgal_mesh.hpp"
#include "support/openmesh_mesh.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/compiled_refine.hpp>
#include <kith/loop.hpp>

// A program has such lines in its own header.
KITH_COMPILED_REFINE(kith::catmull_clark, surface_mesh<epick>)
KITH_COMPILED_REFINE(kith::loop, tri_mesh)
