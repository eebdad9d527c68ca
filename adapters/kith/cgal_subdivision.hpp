// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// What CGAL's Subdivision_method_3 has, under the same names in namespace kith::cgal, to the same surfaces; and all
/// schemes of kith in that shape. docs/start/cgal.md.
#include <kith/cgal/masks.hpp>
#include <kith/cgal/methods.hpp>
