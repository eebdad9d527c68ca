// SPDX-License-Identifier: BSD-3-Clause
// Refines a CGAL mesh in ten lines: a mesh is read, and a finer mesh of the same type is written.
// Sample run: refine_cgal cage.off smooth.off     (without arguments: a tetrahedron, nothing written)

#include <kith/catmull_clark.hpp>
#include <kith/cgal.hpp>
#include <kith/refine.hpp>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <iostream>

int main(int count, char** words)
{
    using kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using point = kernel::Point_3;
    using mesh = CGAL::Surface_mesh<point>;
    mesh cage;
    if (count == 1)
        CGAL::make_tetrahedron(point(0, 0, 0), point(1, 0, 0), point(0, 1, 0), point(0, 0, 1), cage);
    else if (not CGAL::IO::read_polygon_mesh(words[1], cage))
        return 1;

    const mesh smooth = kith::refine(cage, kith::catmull_clark{}, 3);

    std::cout << smooth.number_of_vertices() << " vertices, " << smooth.number_of_faces() << " faces\n";
    if (count > 2 and not CGAL::IO::write_polygon_mesh(words[2], smooth, CGAL::parameters::stream_precision(17)))
        return 1;
    if (count == 1) { // computed by hand: three steps of Catmull-Clark's masks at a vertex of a tetrahedron
        const double x = 755. / 3888;
        if (CGAL::squared_distance(smooth.point(*smooth.vertices().begin()), point(x, x, x)) > 1e-30)
            return 1;
    }
    return smooth.is_valid() ? 0 : 1;
}
