// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/refine.hpp>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

namespace kith {

namespace detail {

/// Each quad in two triangles that mark the diagonal.
struct diagonal_split {
    static constexpr auto traits() { return scheme_traits{.faces = face_shape::quads}; }
    static constexpr auto columns()
    {
        const auto apex = [](const auto& c) { // the second and the fourth corner
            return c.prev() == c.f().first_corner() or c.next() == c.f().first_corner();
        };
        return kith::columns(
            new_vertices(per_vertex), new_edges(per_edge, per_face), new_faces(triangles(per_corner).only(apex)));
    }
    template <class R>
    void operator()(const R& r) const
    {
        using namespace targets;
        const auto& [coarse, assoc, generation] = r;
        for_each(coarse.vertices(), [&](auto v) { assoc(v, V) = v; });
        for_each(coarse.faces(), [&](auto f) {
            const auto c = f.first_corner();
            for (const auto apex : {c.next(), c.prev()}) {
                const auto in = apex.prev_edge();
                const auto out = apex.next_edge();
                const auto diagonal = apex == c.next() ? assoc(f, E).left() : assoc(f, E).right();
                assoc(apex, F) = polygon(assoc(apex.next().v(), V) >> diagonal,
                                         assoc(apex.prev().v(), V) >> assoc(in, E).along(in),
                                         assoc(apex.v(), V) >> assoc(out, E).along(out));
            }
        });
    }
};

/// Each face in triangles around its centroid that mark the edges of the face.
struct centroid_split {
    static constexpr auto columns()
    {
        return kith::columns(
            new_vertices(per_vertex, per_face), new_edges(per_edge, per_corner), new_faces(triangles(per_side)));
    }
    template <class R>
    void operator()(const R& r) const
    {
        using namespace targets;
        const auto& [coarse, assoc, generation] = r;
        for_each(coarse.vertices(), [&](auto v) { assoc(v, V) = v; });
        for_each(coarse.faces(), [&](auto f) { assoc(f, V) = average(f.vertices()); });
        for_each(coarse.corners(), [&](auto c) {
            const auto e = c.next_edge();
            assoc(e, c.f(), F) = polygon(assoc(c.v(), V) >> assoc(e, E).along(e),
                                         assoc(c.next().v(), V) >> assoc(c.next(), E).left(),
                                         assoc(c.f(), V) >> assoc(c, E).right());
        });
    }
};

} // namespace detail

/// The tri-quad mesh that 4-8 subdivision starts from: quads are cut along a diagonal (which one makes no difference to
/// the next levels), meshes with other faces get a vertex in the middle of every face. Quads cut along a diagonal are
/// generation 0; one step marks all their edges, which is how the other meshes start, so these are generation 1.
/// Errors: as `refine`.
template <class Point, class Index>
basic_mesh<Point, Index> tri_quad(const basic_mesh<Point, Index>& mesh)
{
    const bool quads = mesh.topology().degree == 4;
    const auto made = quads ? refine(mesh, detail::diagonal_split{}, 1) : refine(mesh, detail::centroid_split{}, 1);
    return {storage<Point>(made.points()), made.topology(), quads ? 0 : 1};
}

template <refinable_mesh M>
M tri_quad(const M& mesh)
{
    return mesh_traits<M>::build(tri_quad(lift_valid(mesh)));
}

/// The same triangle mesh with these edges, given by their vertices, as the marked ones.
/// Errors: mesh_error for other faces than triangles, for a mesh without edges, and for a face with no or several marked
/// edges, which it names. Cost: O(corners log edges).
template <class Point, class Index>
basic_mesh<Point, Index> mark_edges(const basic_mesh<Point, Index>& mesh, std::vector<std::pair<Index, Index>> marked)
{
    for (auto& [a, b] : marked)
        if (b < a)
            std::swap(a, b);
    std::ranges::sort(marked);
    require_edges(mesh);
    auto t = mesh.topology();
    if (t.degree != 3)
        throw mesh_error("4-8: only triangles have a marked edge each; triangulate the mesh first");
    std::vector<Index> new_corner(t.corners());
    for (std::size_t f = 0; f < t.faces; ++f) {
        int first = -1, count = 0;
        for (int k = 0; k < 3; ++k) {
            const auto ends = std::minmax(t.corner_vertex[3 * f + k], t.corner_vertex[3 * f + (k + 1) % 3]);
            if (std::ranges::binary_search(marked, std::pair<Index, Index>(ends)))
                first = k, ++count;
        }
        if (count != 1)
            throw mesh_error("4-8: face " + std::to_string(f) + " has " + std::to_string(count) +
                             " marked edges; mark exactly one");
        for (int k = 0; k < 3; ++k)
            new_corner[3 * f + (first + k) % 3] = Index(3 * f + k);
    }
    const auto& old = mesh.topology();
    for (std::size_t c = 0; c < old.corners(); ++c) {
        t.corner_vertex[new_corner[c]] = old.corner_vertex[c];
        t.corner_halfedge[new_corner[c]] = old.corner_halfedge[c];
    }
    for (auto* list : {&t.halfedge_corner, &t.vertex_corner})
        for (Index& c : *list)
            c = c == t.none ? t.none : new_corner[c];
    return {storage<Point>(mesh.points()), std::move(t), mesh.generation()};
}

} // namespace kith
