// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// All schemes, for programs that link kith::compiled_schemes and so need not compile their steps.

#include "butterfly.hpp"
#include "catmull_clark.hpp"
#include "doo_sabin.hpp"
#include "four_eight.hpp"
#include "interpolatory_sqrt3.hpp"
#include "kobbelt.hpp"
#include "linear.hpp"
#include "loop.hpp"
#include "mid_edge.hpp"
#include "nasri_hasbini.hpp"
#include "sqrt3.hpp"
#include "tri_quad.hpp"
#include "unified.hpp"
