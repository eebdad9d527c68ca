// SPDX-License-Identifier: BSD-3-Clause
// Defines two schemes and runs each on the native mesh, on CGAL::Surface_mesh and on OpenMesh without further code.
// Sample run: own_scheme

#include <kith/cgal.hpp>
#include <kith/hierarchy.hpp>
#include <kith/openmesh.hpp>

#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <vector>

/// A scheme that makes a quad from every corner and smooths nothing.
struct linear_split {
    static constexpr auto traits() { return kith::scheme_traits{.name = "linear-split"}; }
    static constexpr auto columns()
    {
        return kith::columns(kith::new_vertices(kith::per_vertex, kith::per_edge, kith::per_face),
                             kith::new_faces(quads(kith::per_corner)));
    }
    template <class R>
    void operator()(const R& r) const
    {
        using namespace kith::targets;
        const auto& [coarse, assoc, generation] = r;
        for_each(coarse.vertices(), [&](auto v) { assoc(v, V) = v; });
        for_each(coarse.edges(), [&](auto e) { assoc(e, V) = average(e.org(), e.dst()); });
        for_each(coarse.faces(), [&](auto f) { assoc(f, V) = average(f.vertices()); });
        for_each(coarse.corners(), [&](auto c) {
            assoc(c, F) = polygon(assoc(c.v(), V), assoc(c.next_edge(), V), assoc(c.f(), V), assoc(c.prev_edge(), V));
        });
    }
};

/// The simplest scheme: joins the edge midpoints in every face and around every vertex. Peters & Reif 1997.
struct mid_edge {
    static constexpr auto columns()
    {
        const auto degree = [](const auto& f) { return f.degree(); };
        const auto valence = [](const auto& v) { return v.valence(); };
        return kith::columns(kith::new_vertices(kith::per_edge),
                             kith::new_faces(kith::per_face.of_degree(degree), kith::per_vertex.of_degree(valence)));
    }
    template <class R>
    void operator()(const R& r) const
    {
        using namespace kith::targets;
        const auto& [coarse, assoc, generation] = r;
        for_each(coarse.edges(), [&](auto e) { assoc(e, V) = average(e.org(), e.dst()); });
        for_each(coarse.faces(), [&](auto f) { assoc(f, F) = polygon(assoc(f.edges(), V)); });
        for_each(coarse.vertices(), [&](auto v) { assoc(v, F) = polygon(assoc(v.edges(), V)); });
    }
};

template <class Mesh>
Mesh cube()
{
    using traits = kith::mesh_traits<Mesh>;
    const std::vector<typename traits::point> points{
        {-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}};
    const std::vector<std::vector<int>> faces{
        {0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    return traits::build(kith::make_mesh(points, faces));
}

/// Returns true if two levels have the same points up to the precision of meshes with float coordinates.
template <class Level, class OtherLevel>
bool same_points(const Level& a, const OtherLevel& b)
{
    bool same = a.vertex_count() == b.vertex_count();
    for (std::size_t v = 0; same and v < a.vertex_count(); ++v)
        for (int x = 0; x < 3; ++x)
            same = same and std::abs(double(a.vertices()[v].point()[x]) - double(b.vertices()[v].point()[x])) < 1e-6;
    return same;
}

template <class Mesh, class Scheme>
bool try_on(const char* mesh_name, const char* scheme_name, std::size_t vertices)
{
    const Mesh control = cube<Mesh>();
    const kith::basic_mesh<> native_control = cube<kith::basic_mesh<>>();
    kith::hierarchy<Mesh, Scheme> levels(control); // every level is a mesh of the user's type
    levels.refine(2);
    kith::hierarchy<kith::basic_mesh<>, Scheme> native_levels(native_control);
    native_levels.refine(2);
    const auto& coarse = levels.elements(1);
    const auto& fine = levels.elements(2);
    std::printf("%-9s %-7s %zu -> %zu -> %zu vertices\n",
                scheme_name,
                mesh_name,
                levels.elements(0).vertex_count(),
                coarse.vertex_count(),
                fine.vertex_count());
    return fine.vertex_count() == vertices and same_points(fine, native_levels.elements(2));
}

template <class Mesh>
bool try_both_on(const char* name)
{
    return try_on<Mesh, linear_split>(name, "linear", 98) and try_on<Mesh, mid_edge>(name, "mid-edge", 24);
}

int main()
{
    using cgal_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
    const bool all = try_both_on<kith::basic_mesh<>>("native") and try_both_on<cgal_mesh>("CGAL") and
                     try_both_on<OpenMesh::PolyMesh_ArrayKernelT<>>("OpenMesh");
    return all ? 0 : 1;
}
