// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Includes all schemes, and the functions that go with them.
#include "butterfly.hpp"
#include "catmull_clark.hpp"
#include "doo_sabin.hpp"
#include "face_varying.hpp"
#include "four_eight.hpp"
#include "interpolatory_sqrt3.hpp"
#include "kobbelt.hpp"
#include "linear.hpp"
#include "loop.hpp"
#include "mid_edge.hpp"
#include "nasri_hasbini.hpp"
#include "presets.hpp"
#include "quad_tri.hpp"
#include "selected.hpp"
#include "sqrt3.hpp"
#include "tri_quad.hpp"
#include "unified.hpp"

#include <kith/limits/limit_matrix.hpp>
#include <kith/limits/limit_surface.hpp>
#include <kith/limits/tangent_matrix.hpp>
#include <kith/make_creases.hpp>
#include <kith/schemes/crease/vertex_type.hpp>
