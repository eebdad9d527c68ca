// SPDX-License-Identifier: BSD-3-Clause
// A program that uses the components WITH_<component> names, and the core where it names none.

#include <kith/core/mesh/make_mesh.hpp>

#if defined(WITH_schemes) or defined(WITH_compiled_schemes)
#include <kith/linear.hpp>
#include <kith/refine.hpp>
#endif

#if defined(WITH_compiled_schemes) and not defined(KITH_COMPILED_SCHEMES)
#error "the schemes are compiled here, too"
#endif

#if defined(WITH_distributed)
#include <kith/tiles/part/partition.hpp>
#endif

#if defined(WITH_metis)
#include <kith/metis_partition.hpp>
#endif

#if defined(WITH_mpi)
#include <kith/mpi/session.hpp>
#endif

#if defined(WITH_compiled_cgal)
#include <CGAL/Simple_cartesian.h>
#include <kith/cgal.hpp>
#include <kith/loop.hpp>
#include <kith/refine.hpp>
using cgal_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
static_assert(kith::is_compiled_mesh<cgal_mesh>, "the mesh is compiled here, too");
#endif

#if defined(WITH_compiled_openmesh)
#include <kith/loop.hpp>
#include <kith/openmesh.hpp>
#include <kith/refine.hpp>
static_assert(kith::is_compiled_mesh<OpenMesh::TriMesh_ArrayKernelT<>>, "the mesh is compiled here, too");
#endif

#if defined(WITH_cgal)
#include <CGAL/Simple_cartesian.h>
#include <kith/cgal.hpp>
static_assert(kith::refinable_mesh<CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>>);
#endif

#if defined(WITH_openmesh)
#include <kith/openmesh.hpp>
static_assert(kith::refinable_mesh<OpenMesh::PolyMesh_ArrayKernelT<>>);
#endif

#if defined(WITH_eigen)
#include <kith/eigen_mesh.hpp>
#endif

#if defined(WITH_picture)
#include <kith/picture.hpp>
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
    const auto square = kith::make_mesh(points, std::vector{std::array{0, 1, 2, 3}});
    bool is_right = square.edge_count() == 4;
#if defined(WITH_schemes) or defined(WITH_compiled_schemes)
    is_right &= kith::refine(square, kith::linear{}, 2).face_count() == 16;
#endif
#if defined(WITH_distributed)
    is_right &= kith::block_partition(square, 1).part_of.size() == 1;
#endif
#if defined(WITH_metis)
    is_right &= kith::metis_partition(square, 1).part_of.size() == 1;
#endif
#if defined(WITH_mpi)
    int version = 0, minor = 0;
    is_right &= MPI_Get_version(&version, &minor) == MPI_SUCCESS and version >= 3;
#endif
#if defined(WITH_compiled_cgal)
    cgal_mesh triangle;
    const auto a = triangle.add_vertex({0, 0, 0}), b = triangle.add_vertex({1, 0, 0}),
               c = triangle.add_vertex({0, 1, 0});
    triangle.add_face(a, b, c);
    is_right &= kith::refine(triangle, kith::loop{}, 2).number_of_faces() == 16;
#endif
#if defined(WITH_compiled_openmesh)
    OpenMesh::TriMesh_ArrayKernelT<> face;
    const auto from = face.add_vertex({0, 0, 0}), right = face.add_vertex({1, 0, 0}), up = face.add_vertex({0, 1, 0});
    face.add_face(from, right, up);
    is_right &= kith::refine(face, kith::loop{}, 2).n_faces() == 16;
#endif
#if defined(WITH_openmesh)
    is_right &= OpenMesh::PolyMesh_ArrayKernelT<>().n_vertices() == 0;
#endif
#if defined(WITH_eigen)
    is_right &= kith::points_as_matrix(square).rows() == 4;
#endif
#if defined(WITH_picture)
    is_right &= kith::picture::draw({.panels = {{.items = {kith::picture::surface_of(square)}}}}).width == 800;
#endif
#if defined(WITH_io)
    std::ostringstream out;
    kith::io::write_mesh(out, kith::io::mesh_format::off, {square});
    is_right &= kith::io::read_mesh(kith::io::mesh_format::off, out.str()).faces.size() == 1;
#endif
    return is_right ? 0 : 1;
}
