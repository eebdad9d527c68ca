// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Includes all schemes, and the functions that go with them.
#include "compiled_schemes.hpp"
#include "face_varying.hpp"
#include "presets.hpp"
#include "selected.hpp"

#include <kith/limits/limit_matrix.hpp>
#include <kith/limits/limit_surface.hpp>
#include <kith/limits/tangent_matrix.hpp>
#include <kith/make_creases.hpp>
#include <kith/schemes/crease/vertex_type.hpp>
