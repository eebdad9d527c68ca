// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Reads and writes meshes with their tags, writes matrices, and saves and loads hierarchies.
#include "attributes_of.hpp"
#include "matrix_market.hpp"
#include "read_mesh.hpp"
#include "saved_levels.hpp"
#include "tags_of_creases.hpp"
#include "write_mesh.hpp"
