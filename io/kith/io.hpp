// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Meshes and tags from files and into files, matrices into files, hierarchies saved and loaded.
#include "attributes_of.hpp"
#include "matrix_market.hpp"
#include "read_mesh.hpp"
#include "saved_levels.hpp"
#include "tags_of_creases.hpp"
#include "write_mesh.hpp"
