// SPDX-License-Identifier: BSD-3-Clause
// Writes the dual split as associations, in the three ways in which Euler operators can make it (thesis 3.3; Shiue &
// Peters 2005): factoring, splitting and tilting. The mesh has to be closed.
// Sample run: euler_encodings

#include "../tests/support/figures.hpp"
#include "same_faces.hpp"

#include <kith/doo_sabin.hpp>
#include <kith/mid_edge.hpp>
#include <kith/refine.hpp>

#include <cstddef>
#include <vector>

using namespace kith::targets;

constexpr auto corners_of = [](const auto& f) { return f.degree(); };
constexpr auto faces_at = [](const auto& v) { return v.face_count(); };

/// The point of a corner: the mean of its vertex, the midpoints of its two edges and the centre of its face.
constexpr auto corner_point = [](const auto& c) {
    return average(c.v(), average(c.v(), c.next().v()), average(c.f().vertices()), average(c.v(), c.prev().v()));
};

/// Factoring: two mid-edge steps. Each edge of the first step's mesh is a corner (v,f) of the control mesh.
struct factoring {
    static constexpr auto columns()
    {
        return kith::columns(kith::new_vertices(kith::per_corner),
                             kith::new_faces(kith::per_face.of_degree(corners_of),
                                             quads(kith::per_edge),
                                             kith::per_vertex.of_degree(faces_at)));
    }
    template <class R>
    void operator()(const R& r) const
    {
        const auto& [coarse, assoc, generation] = r;
        const auto first = assoc.pass(kith::new_vertices(kith::per_edge));
        for_each(coarse.edges(), [&](auto e) { first(e, V) = average(e.org(), e.dst()); });
        for_each(coarse.corners(),
                 [&](auto c) { assoc(c, V) = average(first(c.prev_edge(), V), first(c.next_edge(), V)); });

        for_each(coarse.faces(), [&](auto f) { assoc(f, F) = polygon(assoc(f, f.vertices(), V)); });
        for_each(coarse.vertices(), [&](auto v) { assoc(v, F) = polygon(assoc(v, v.faces(), V)); });
        for_each(coarse.edges(), [&](auto e) {
            assoc(e, F) = polygon(assoc(e.dst(), e.lface(), V),
                                  assoc(e.org(), e.lface(), V),
                                  assoc(e.org(), e.rface(), V),
                                  assoc(e.dst(), e.rface(), V));
        });
    }
};

/// Splitting, first half: makes temporary vertices (v,f) around each vertex v, which stays in the middle.
struct split_vertices {
    static constexpr auto columns()
    {
        return kith::columns(
            kith::new_vertices(kith::per_vertex, kith::per_corner),
            kith::new_faces(kith::per_face.of_degree(corners_of), quads(kith::per_edge), triangles(kith::per_end)));
    }
    template <class R>
    void operator()(const R& r) const
    {
        const auto& [coarse, assoc, generation] = r;
        for_each(coarse.vertices(), [&](auto v) { assoc(v, V) = v; });
        for_each(coarse.corners(), [&](auto c) { assoc(c, V) = corner_point(c); });

        for_each(coarse.faces(), [&](auto f) { assoc(f, F) = polygon(assoc(f, f.vertices(), V)); });
        for_each(coarse.edges(), [&](auto e) {
            const auto x = e.org(), y = e.dst();
            const auto l = e.lface(), r = e.rface();
            assoc(e, F) = polygon(assoc(y, l, V), assoc(x, l, V), assoc(x, r, V), assoc(y, r, V));
            assoc(x, e, F) = polygon(assoc(x, V), assoc(x, r, V), assoc(x, l, V));
            assoc(y, e, F) = polygon(assoc(y, V), assoc(y, l, V), assoc(y, r, V));
        });
    }
};

/// Splitting, second half: removes the first `count` vertices, and merges the faces around each into one face.
struct remove_vertices {
    std::size_t count;

    auto columns() const
    {
        const auto goes = [count = count](const auto& v) { return v.index() < count; };
        const auto stays = [goes](const auto& v) { return not goes(v); };
        const auto is_whole = [goes](const auto& f) {
            for (const auto v : f.vertices())
                if (goes(v))
                    return false;
            return true;
        };
        return kith::columns(kith::new_vertices(kith::per_vertex.only(stays)),
                             kith::new_faces(kith::per_face.only(is_whole).of_degree(corners_of),
                                             kith::per_vertex.only(goes).of_degree(faces_at)));
    }
    template <class R>
    void operator()(const R& r) const
    {
        const auto& [coarse, assoc, generation] = r;
        for_each(coarse.vertices(), [&](auto v) {
            if (v.index() >= count)
                assoc(v, V) = v;
        });
        for_each(coarse.vertices(), [&](auto v) {
            if (v.index() < count)
                assoc(v, F) = polygon(assoc(v.neighbors(), V));
        });
        for_each(coarse.faces(), [&](auto f) {
            for (const auto v : f.vertices())
                if (v.index() < count)
                    return;
            assoc(f, F) = polygon(assoc(f.vertices(), V));
        });
    }
};

/// Tilting: every edge x -> y gets two vertices, (x, e) in its left face and (y, e) in its right one.
/// The edge turns until it joins them. No element is temporary.
struct tilting {
    static constexpr auto columns()
    {
        return kith::columns(kith::new_vertices(kith::per_end),
                             kith::new_faces(kith::per_face.of_degree(corners_of),
                                             quads(kith::per_edge),
                                             kith::per_vertex.of_degree(faces_at)));
    }
    template <class R>
    void operator()(const R& r) const
    {
        const auto& [coarse, assoc, generation] = r;
        const auto& end = [&](const auto& c) { return assoc(c.v(), c.next_edge(), V); };
        for_each(coarse.corners(), [&](auto c) { end(c) = corner_point(c); });

        for_each(coarse.faces(), [&](auto f) { assoc(f, F) = polygon(f.corners(), end); });
        for_each(coarse.vertices(), [&](auto v) { assoc(v, F) = polygon(assoc(v, v.edges(), V)); });
        for_each(coarse.edges(), [&](auto e) {
            const auto x = e.lcorner(), y = e.rcorner();
            assoc(e, F) = polygon(end(x.next()), end(x), end(y.next()), end(y));
        });
    }
};

/// Returns the mesh with its vertices renumbered: vertex v becomes vertex number[v].
mesh renumbered(const mesh& m, const std::vector<std::size_t>& number)
{
    std::vector<mesh::point_type> points(m.vertex_count());
    kith::face_list faces;
    for (std::size_t v = 0; v < m.vertex_count(); ++v)
        points[number[v]] = m.point(v);
    for (auto face : faces_of(m)) {
        for (auto& v : face)
            v = number[v];
        faces.push_back(face);
    }
    return kith::make_mesh(points, faces);
}

bool same(const mesh& a, const mesh& b)
{
    return faces_of(a) == faces_of(b) and same_points(a, b);
}

int main()
{
    bool all = true;
    for (const auto& shape : {figures::cube(), figures::pentacube(), figures::hollow_cube()}) {
        const auto control = kith::make_mesh(shape.points, shape.faces);
        const auto dual = kith::refine(control, kith::doo_sabin{.weights = kith::doo_sabin_weights::averaging}, 1);

        const auto factored = kith::refine(control, factoring(), 1);
        all &= report("factoring, two mid-edge steps", same(factored, kith::refine(control, kith::mid_edge(), 2)));
        all &= report("factoring, dual split", faces_of(factored) == faces_of(dual));

        const auto split = kith::refine(control, split_vertices(), 1);
        all &= report("splitting, dual split",
                      same(kith::refine(split, remove_vertices{control.vertex_count()}, 1), dual));

        std::vector<std::size_t> corner_of_end; // the numbers of the dual split's vertices
        for (const auto corner : control.topology().halfedge_corner)
            corner_of_end.push_back(corner);
        all &= report("tilting, dual split",
                      same(renumbered(kith::refine(control, tilting(), 1), corner_of_end), dual));
    }
    return all ? 0 : 1;
}
