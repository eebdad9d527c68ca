// SPDX-License-Identifier: BSD-3-Clause
#include "foreign_back_end.hpp"

#include <kith/cgal.hpp>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace kith::tool {

refined_mesh refine_cgal(basic_mesh<> control, const refine_request& request)
{
    require_possible(request, control, mesh_kind::cgal);
    using point = CGAL::Simple_cartesian<double>::Point_3;
    return refine_on<CGAL::Surface_mesh<point>>(control, request);
}

} // namespace kith::tool
