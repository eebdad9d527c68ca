// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_in_library.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <kith/cgal_properties.hpp>

namespace kith {

using cartesian_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using epick_mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;

#define KITH_ALL_IN_LIBRARY(mesh)                                                                                      \
    KITH_MESH_IN_LIBRARY(mesh)                                                                                         \
    KITH_PROPERTIES_IN_LIBRARY(vertex, mesh, mesh)                                                                     \
    KITH_PROPERTIES_IN_LIBRARY(halfedge, mesh, mesh)                                                                   \
    KITH_PROPERTIES_IN_LIBRARY(edge, mesh, mesh)                                                                       \
    KITH_PROPERTIES_IN_LIBRARY(face, mesh, mesh)

KITH_ALL_IN_LIBRARY(cartesian_mesh)
KITH_ALL_IN_LIBRARY(epick_mesh)

} // namespace kith
