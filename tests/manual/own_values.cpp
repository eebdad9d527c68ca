// SPDX-License-Identifier: BSD-3-Clause
// docs/how/properties.md: values of a type that kith does not know.
#include <kith/cgal_subdivision.hpp>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <cmath>

using point = CGAL::Simple_cartesian<double>::Point_3;
using surface = CGAL::Surface_mesh<point>;

struct load {
    double newtons = 0;
};
template <>
struct kith::affine<load> : kith::coordinates_affine<double, 1> {
    static sum load(const ::load& value) { return {value.newtons}; }
    static ::load store(const sum& total) { return {total[0]}; }
};

int main()
{
    surface mesh;
    CGAL::make_tetrahedron(point(1, 1, 1), point(1, -1, -1), point(-1, 1, -1), point(-1, -1, 1), mesh);
    const auto loads = mesh.add_property_map<surface::Vertex_index, load>("v:load", load{7}).first;
    const auto areas = mesh.add_property_map<surface::Face_index, double>("f:area", 16.).first;
    const auto quarter = [](double area) { return area / 4; };

    // @block@

    bool is_right = report.left_out.empty() and mesh.number_of_faces() == 64;
    for (const auto v : mesh.vertices())
        is_right = is_right and std::abs(loads[v].newtons - 7) < 1e-12;
    for (const auto f : mesh.faces())
        is_right = is_right and areas[f] == 1;
    return is_right ? 0 : 1;
}
