// SPDX-License-Identifier: BSD-3-Clause
#include <CGAL/Simple_cartesian.h>

#include <kith/cgal_subdivision.hpp>

using mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

void refine(mesh& m)
{
    kith::cgal::DooSabin_subdivision(m, kith::cgal::parameters::do_not_modify_geometry(true));
}
