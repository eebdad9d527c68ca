// SPDX-License-Identifier: BSD-3-Clause
// Writes the stellar operators (thesis 4.3.3; Velho 2001) as associations: split a face, split an edge, flip an edge.
// Each step makes a new level. So weld and collapse, which undo a split elsewhere, are a return to the level before.
// Sample run: stellar

#include "../tests/support/figures.hpp"
#include "same_faces.hpp"

#include <kith/linear.hpp>
#include <kith/mesh.hpp>
#include <kith/refine.hpp>
#include <kith/sqrt3.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

using namespace kith::targets;

/// Face split, 1 to n: cuts every polygon into the quads at its corners. Thesis, figure 4.16.
struct split_polygons {
    static constexpr auto columns()
    {
        return kith::columns(kith::new_vertices(kith::per_vertex, kith::per_edge, kith::per_face),
                             kith::new_faces(quads(kith::per_corner)));
    }
    template <class R>
    void operator()(const R& r) const
    {
        const auto& [coarse, assoc, generation] = r;
        for_each(coarse.vertices(), [&](auto v) { assoc(v, V) = v; });
        for_each(coarse.edges(), [&](auto e) { assoc(e, V) = average(e.org(), e.dst()); });
        for_each(coarse.faces(), [&](auto f) { assoc(f, V) = average(f.vertices()); });
        for_each(coarse.corners(), [&](auto c) {
            assoc(c, F) = polygon(assoc(c.v(), V), assoc(c.next_edge(), V), assoc(c.f(), V), assoc(c.prev_edge(), V));
        });
    }
};

/// Face split of triangles, 1 to 3: makes a vertex in every face.
struct split_triangles {
    static constexpr auto columns()
    {
        return kith::columns(kith::new_vertices(kith::per_vertex, kith::per_face),
                             kith::new_faces(triangles(kith::per_side)));
    }
    template <class R>
    void operator()(const R& r) const
    {
        const auto& [coarse, assoc, generation] = r;
        for_each(coarse.vertices(), [&](auto v) { assoc(v, V) = v; });
        for_each(coarse.faces(), [&](auto f) { assoc(f, V) = average(f.vertices()); });
        for_each(coarse.corners(), [&](auto c) {
            assoc(c.next_edge(), c.f(), F) = polygon(assoc(c.v(), V), assoc(c.next().v(), V), assoc(c.f(), V));
        });
    }
};

/// Edge split: makes a vertex on one edge and halves the triangles of the edge. All other triangles stay.
struct split_edge {
    std::size_t edge;

    auto columns() const
    {
        const auto is_it = [edge = edge](const auto& e) { return e.index() == edge; };
        const auto is_half = [is_it](const auto& c) { return is_it(c.next_edge()) or is_it(c.prev_edge()); };
        const auto stays = [is_half](const auto& f) {
            const auto c = f.first_corner();
            return not is_half(c) and not is_half(c.next());
        };
        return kith::columns(
            kith::new_vertices(kith::per_vertex, kith::per_edge.only(is_it)),
            kith::new_faces(triangles(kith::per_face.only(stays)), triangles(kith::per_corner.only(is_half))));
    }
    template <class R>
    void operator()(const R& r) const
    {
        const auto& [coarse, assoc, generation] = r;
        const auto split = coarse.edges()[edge];
        for_each(coarse.vertices(), [&](auto v) { assoc(v, V) = v; });
        assoc(split, V) = average(split.org(), split.dst());
        for_each(coarse.faces(), [&](auto f) {
            for (const auto c : f.corners())
                if (c.next_edge() == split) { // half-edge a -> b with apex d
                    const auto a = c, b = c.next(), d = c.prev();
                    assoc(a, F) = polygon(assoc(a.v(), V), assoc(split, V), assoc(d.v(), V));
                    assoc(b, F) = polygon(assoc(split, V), assoc(b.v(), V), assoc(d.v(), V));
                    return;
                }
            assoc(f, F) = polygon(assoc(f.vertices(), V));
        });
    }
};

/// Edge flip: replaces each edge that `chosen` accepts by the other diagonal of its two triangles, which must not be an
/// edge already. At most one edge per triangle may be chosen, so that all can be flipped at once.
template <class Chosen>
struct flip_edges {
    Chosen chosen;

    explicit flip_edges(Chosen chosen) : chosen(chosen) {}

    auto columns() const
    {
        const auto stays = [chosen = chosen](const auto& f) {
            for (const auto e : f.edges())
                if (chosen(e))
                    return false;
            return true;
        };
        return kith::columns(
            kith::new_vertices(kith::per_vertex),
            kith::new_faces(triangles(kith::per_face.only(stays)), triangles(kith::per_end.only(chosen))));
    }
    template <class R>
    void operator()(const R& r) const
    {
        const auto& [coarse, assoc, generation] = r;
        for_each(coarse.vertices(), [&](auto v) { assoc(v, V) = v; });
        for_each(coarse.edges(), [&](auto e) {
            if (not chosen(e))
                return;
            const auto a = e.org(), b = e.dst(), p = e.lcorner().prev().v(), q = e.rcorner().prev().v();
            assoc(a, e, F) = polygon(assoc(a, V), assoc(q, V), assoc(p, V));
            assoc(b, e, F) = polygon(assoc(b, V), assoc(p, V), assoc(q, V));
        });
        for_each(coarse.faces(), [&](auto f) {
            for (const auto e : f.edges())
                if (chosen(e))
                    return;
            assoc(f, F) = polygon(assoc(f.vertices(), V));
        });
    }
};

/// Splits each face in three, then flips the old edges. Returns true if this is the sqrt(3) scheme's mesh.
bool sqrt3_by_splits_and_flips(const mesh& control)
{
    const std::size_t old = control.vertex_count();
    const auto split = kith::refine(control, split_triangles(), 1);
    const auto flipped = kith::refine(
        split, flip_edges([old](const auto& e) { return e.org().index() < old and e.dst().index() < old; }), 1);
    return faces_of(flipped) == faces_of(kith::refine(control, kith::sqrt3(), 1));
}

/// Splits every edge, one after the other. Then flips each edge that joins an old vertex to a new one and is no half of
/// an old edge.
bool triangle_split_by_splits_and_flips(const mesh& control)
{
    const std::size_t old = control.vertex_count();
    std::vector<std::pair<std::size_t, std::size_t>> ends;
    const kith::level_of<mesh> level(control);
    for (const auto e : level.edges())
        ends.emplace_back(e.org().index(), e.dst().index());
    mesh split = control;
    for (const auto& [a, b] : ends) {
        const kith::level_of<mesh> now(split);
        const auto between = edge_between(now.vertices()[a], now.vertices()[b]);
        split = kith::refine(split, split_edge{between->index()}, 1);
    }
    const auto is_extra = [&](const auto& e) {
        const std::size_t v = std::min(e.org().index(), e.dst().index());
        const std::size_t middle = std::max(e.org().index(), e.dst().index());
        return v < old and middle >= old and ends[middle - old].first != v and ends[middle - old].second != v;
    };
    const auto flipped = kith::refine(split, flip_edges(is_extra), 1);
    const auto direct = kith::refine(control, kith::linear_triangles(), 1);
    return faces_of(flipped) == faces_of(direct) and same_points(flipped, direct);
}

int main()
{
    const auto make = [](const figures::shape& shape) { return kith::make_mesh(shape.points, shape.faces); };
    const auto cube = make(figures::triangulated(figures::cube()));
    const auto hollow = make(figures::triangulated(figures::hollow_cube()));
    const auto pentacube = make(figures::pentacube());
    const auto split = kith::refine(pentacube, split_polygons(), 1),
               linear = kith::refine(pentacube, kith::linear(), 1);
    bool all = report("face splits 1 to n, linear split",
                      faces_of(split) == faces_of(linear) and same_points(split, linear));
    for (const mesh& control : {cube, hollow}) {
        all &= report("face splits 1 to 3 and flips, sqrt(3) split", sqrt3_by_splits_and_flips(control));
        all &= report("edge splits and flips, triangle split", triangle_split_by_splits_and_flips(control));
    }
    return all ? 0 : 1;
}
