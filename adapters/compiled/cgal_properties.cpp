// SPDX-License-Identifier: BSD-3-Clause
#include "properties_in_library.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <kith/cgal_properties.hpp>

namespace kith {

using cartesian_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using epick_mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;

KITH_PROPERTIES_IN_LIBRARY(cartesian_mesh, cartesian_mesh)
KITH_PROPERTIES_IN_LIBRARY(epick_mesh, epick_mesh)

} // namespace kith
