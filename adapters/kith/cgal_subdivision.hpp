// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The functions of CGAL's Subdivision_method_3, under the same names in namespace kith::cgal, with the same surfaces.
/// All other schemes of kith have functions of the same form. See docs/start/cgal.md.
#include <kith/cgal/masks.hpp>
#include <kith/cgal/methods.hpp>
