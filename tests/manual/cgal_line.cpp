// SPDX-License-Identifier: BSD-3-Clause
// docs/start/cgal.md: the one line.
#include <kith/cgal_subdivision.hpp>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

int main()
{
    using point = CGAL::Simple_cartesian<double>::Point_3;
    CGAL::Surface_mesh<point> mesh;
    CGAL::make_tetrahedron(point(1, 1, 1), point(1, -1, -1), point(-1, 1, -1), point(-1, -1, 1), mesh);

    // @block@

    return mesh.number_of_faces() == 4 * 3 * 16 ? 0 : 1;
}
