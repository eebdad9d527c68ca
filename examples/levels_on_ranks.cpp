// SPDX-License-Identifier: BSD-3-Clause
// Refines a CGAL mesh on a cluster in about thirty lines. Rank 0 has the mesh, with heat at its vertices, a material on
// its faces and constrained edges. The program keeps all levels of all tiles, moves them to other ranks, and asks from
// which faces theirs descend. It writes the last level to one file, which has the same bytes on any number of ranks.
// Sample run: mpirun -n 4 levels_on_ranks fine.vtu

#include <kith/catmull_clark.hpp>
#include <kith/cgal_properties.hpp>
#include <kith/convert.hpp>
#include <kith/fields/with_fields.hpp>
#include <kith/make_creases.hpp>
#include <kith/metis_partition.hpp>
#include <kith/mpi/ranks/repartition.hpp>
#include <kith/mpi/ranks/write_level.hpp>
#include <kith/refine_on_ranks.hpp>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <cstddef>
#include <utility>

using kith::element_kind;
using kith::field_named;
using kith::field_on;
using surface = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int material_of(std::size_t control_face)
{
    return int(control_face) / 16;
}

surface users_mesh()
{
    surface plate;
    CGAL::make_grid(
        8, 6, plate, [](auto x, auto y) { return surface::Point(double(x), double(y), double(x * y % 3)); });
    auto heat = plate.add_property_map<surface::Vertex_index, double>("v:heat").first;
    auto material = plate.add_property_map<surface::Face_index, int>("f:material").first;
    auto constrained = plate.add_property_map<surface::Edge_index, bool>("e:is_constrained").first;
    for (const auto v : plate.vertices())
        heat[v] = plate.point(v).x();
    for (const auto f : plate.faces())
        material[f] = material_of(f);
    for (const auto e : plate.edges())
        constrained[e] = plate.point(plate.vertex(e, 0)).x() == 4 and plate.point(plate.vertex(e, 1)).x() == 4;
    return plate;
}

int main(int count, char** words)
{
    kith::mpi::session session(count, words);
    kith::mpi::communicator comm(MPI_COMM_WORLD);
    kith::property_mesh<> cage; // the mesh and its values stay empty on all other ranks
    kith::storage<double> heat;
    kith::storage<int> material;
    kith::catmull_clark scheme;
    kith::partition parts;
    if (comm.is_root()) {
        cage = kith::convert<kith::property_mesh<>>(users_mesh()).mesh;
        heat = cage.get<field_on::vertices, double>("v:heat");
        material = cage.get<field_on::faces, int>("f:material");
        const auto constrained = cage.get<field_on::edges, bool>("e:is_constrained");
        scheme.sharpness = kith::make_creases(cage.native(), [&](auto e) { return constrained[e.value]; });
        parts = kith::metis_partition(cage.native(), 2 * std::size_t(comm.size()));
    }
    const auto dressed = kith::with_fields(scheme, kith::on_vertices(heat, kith::by_mask{}), kith::on_faces(material));
    kith::mpi::rank_refinement refinement(comm, cage.native(), dressed, 3, parts, 0);
    auto kept = refinement.keep_levels(kith::mpi::sharing::manager);
    const auto faces = kith::mpi::owned_faces(comm, kept, 3, refinement.tiles());
    kept = kith::mpi::repartition(comm, std::move(kept), kith::mpi::balanced_ranks(faces, comm.size()), dressed);
    const auto lineage = refinement.lineage();
    std::size_t others = 0; // faces on any level whose material differs from that of their ancestor on level 0
    for (const auto& [number, level, tile, its_scheme] : kept)
        for (std::size_t f = 0; f < tile.mesh.face_count(); ++f)
            others += its_scheme.field<1>()[f] !=
                      material_of(lineage.ancestor(level, {element_kind::face, tile.face_ids[f]}, 0).number);
    const char* const path = count > 1 ? words[1] : "fine.vtu";
    kith::mpi::write_level(comm, path, kept, 3, lineage.counts(3), field_named<0>("heat"), field_named<1>("material"));
    return others == 0 ? 0 : 1;
}
