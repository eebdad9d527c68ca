// SPDX-License-Identifier: BSD-3-Clause
#include <kith/catmull_clark.hpp>
#include <kith/refine.hpp>

#if defined(WITH_cgal)
#include <CGAL/Simple_cartesian.h>
#include <kith/cgal.hpp>
static_assert(kith::refinable_mesh<CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>>);
#endif

#if defined(WITH_openmesh)
#include <kith/openmesh.hpp>
static_assert(kith::refinable_mesh<OpenMesh::PolyMesh_ArrayKernelT<>>);
#endif

#if defined(WITH_io)
#include <kith/read_mesh.hpp>
#include <kith/write_mesh.hpp>
#include <sstream>
#endif

#include <array>
#include <vector>

int main()
{
    const std::vector<std::array<double, 3>> points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const std::vector<std::array<int, 4>> faces{{0, 1, 2, 3}};
    const auto fine = kith::refine(kith::make_mesh(points, faces), kith::catmull_clark{}, 2);
#if defined(WITH_io)
    std::ostringstream out;
    kith::io::write_mesh(out, kith::io::mesh_format::off, {fine});
    if (kith::io::read_mesh(kith::io::mesh_format::off, out.str()).faces.size() != 16)
        return 1;
#endif
    return fine.face_count() == 16 ? 0 : 1;
}
