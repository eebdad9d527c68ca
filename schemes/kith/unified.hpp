// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/schemes/split/dual_split.hpp>
#include <kith/schemes/split/quad_split.hpp>
#include <kith/schemes/split/require_faces.hpp>

#include <string>

namespace kith {

/// The unified primal/dual family: tensor B-splines of bidegree 1 to 9 for closed meshes of any polygons. Zorin &
/// Schroeder 2001: one split, then repeated averaging over the dual mesh. Odd degrees are primal and make quads, even
/// degrees are dual and give every inner vertex valence 4. C(degree - 1), at extraordinary vertices and faces C1 from
/// degree 2 on. Degree 1 is the linear split, 2 Doo-Sabin with averaging weights, 3 Catmull-Clark with other vertex
/// weights. Errors: mesh_error for a degree that is not 1 to 9. Cost: O(degree corners).
struct unified {
    int degree = 3;

    static constexpr auto traits()
    {
        return scheme_traits{.name = "unified",
                             .closed_only = true,
                             .trusted = true,
                             .require = [](const unified& s, const auto& level, int) { s.require_input(level); }};
    }
    static constexpr int max_degree = 9; ///< the largest degree for which the authors have proved smoothness

    [[nodiscard]] constexpr bool is_primal() const { return degree % 2 != 0; }

    /// Returns the columns of the quad split or of the dual split; on closed meshes they have the same edges.
    [[nodiscard]] constexpr auto columns() const
    {
        const bool primal = is_primal();
        const auto corners = [](const auto& f) { return f.degree(); };
        const auto faces_around = [](const auto& v) { return v.face_count(); };
        return kith::columns(
            new_vertices(
                per_vertex.when(primal), per_edge.when(primal), per_face.when(primal), per_corner.when(not primal)),
            dual_split().columns().edges,
            new_faces(quads(per_corner.when(primal)),
                      per_face.when(not primal).of_degree(corners),
                      quads(per_edge.when(not primal)),
                      per_vertex.when(not primal).of_degree(faces_around)));
    }
    template <step_context R>
    void operator()(const R& r) const
    {
        using namespace targets;
        const auto& [coarse, assoc, generation] = r;

        // The split copies each vertex into its corners, so the first averaging gives centroids, midpoints and the
        // vertices themselves: the mesh of the quad split. The vertices of its dual are the corners, and so on.
        const auto first = [&](const auto& to) {
            for_each(coarse.faces(), [&](auto f) { to(f, V) = average(f.vertices()); });
            for_each(coarse.edges(), [&](auto e) { to(e, V) = average(e.org(), e.dst()); });
            for_each(coarse.vertices(), [&](auto v) { to(v, V) = v; });
        };
        const auto to_dual = [&](const auto& from, const auto& to) {
            for_each(coarse.corners(), [&](auto c) {
                to(c, V) = average(from(c.v(), V), from(c.next_edge(), V), from(c.f(), V), from(c.prev_edge(), V));
            });
        };
        const auto to_primal = [&](const auto& from, const auto& to) {
            for_each(coarse.faces(), [&](auto f) { to(f, V) = average(from(f.corners(), V)); });
            for_each(coarse.edges(), [&](auto e) {
                const auto x = e.lcorner(), y = e.rcorner();
                to(e, V) = average(from(x, V), from(x.next(), V), from(y, V), from(y.next(), V));
            });
            for_each(coarse.vertices(), [&](auto v) { to(v, V) = average(from(v.corners(), V)); });
        };

        if (degree == 1) {
            first(assoc);
        } else {
            const auto primal = assoc.pass(new_vertices(per_vertex, per_edge, per_face));
            const auto dual = assoc.pass(new_vertices(per_corner));
            first(primal);
            for (int times = 2; times < degree; ++times)
                times % 2 == 0 ? to_dual(primal, dual.again()) : to_primal(dual, primal.again());
            is_primal() ? to_primal(dual, assoc) : to_dual(primal, assoc);
        }
        is_primal() ? quad_split::connect(r) : dual_split().connect(r);
    }

private:
    template <level Level>
    void require_input(const Level& control) const
    {
        if (degree < 1 or degree > max_degree)
            throw mesh_error("unified: degree " + std::to_string(degree) + " was asked for; ask for 1 to " +
                             std::to_string(max_degree));
        if (not is_primal())
            require_three_faces<unified>(control);
    }
};

} // namespace kith
#define KITH_SCHEME unified
#define KITH_SCHEME_OF_DOUBLES
#include <kith/schemes/compiled/in_library.hpp>
