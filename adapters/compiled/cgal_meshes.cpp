// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_in_library.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <kith/cgal.hpp>

namespace kith {

KITH_MESH_IN_LIBRARY(CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>)
KITH_MESH_IN_LIBRARY(CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>)

} // namespace kith
