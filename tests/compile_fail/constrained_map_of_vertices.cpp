// SPDX-License-Identifier: BSD-3-Clause
#include <CGAL/Simple_cartesian.h>

#include <kith/cgal_subdivision.hpp>

using mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

void refine(mesh& m)
{
    const auto sharp = m.add_property_map<mesh::Vertex_index, bool>("v:sharp").first;
    kith::cgal::Loop_subdivision(m, CGAL::parameters::edge_is_constrained_map(sharp));
}
