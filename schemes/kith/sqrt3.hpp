// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/exact_cos.hpp>
#include <kith/numbering/step/rules.hpp>
#include <kith/schemes/split/require_faces.hpp>
#include <kith/schemes/split/sqrt3_split.hpp>

#include <cstddef>
#include <cstdint>
#include <string>

namespace kith {

/// sqrt(3): for triangles, three times as many per step. Kobbelt 2000. C2, at vertices of valence other than 6 C1. The
/// boundary is refined in every second step, by the generation of the mesh: two calls that refine once are the same as
/// one that refines twice. Two steps make the ternary cubic B-spline of the boundary. Cost: O(corners).
struct sqrt3 {
    /// Returns the traits. Reach: the children of a triangle end at the centres of the triangles beside it. Odd steps
    /// also ask whether a triangle lies at the boundary, for which the triangles around it are needed. Together this is
    /// one ring more than for the masks alone.
    static constexpr auto traits()
    {
        return scheme_traits{
            .name = "sqrt3",
            .faces = face_shape::triangles,
            .trusted = true,
            .require =
                [](const auto& control, int generation) {
                    require_three_faces<sqrt3>(control);
                    if (not sqrt3_split::is_odd(generation))
                        return;
                    for (const auto f : control.faces())
                        if (const auto edges = sqrt3_split::boundary_edges(f); edges > 1)
                            throw mesh_error("sqrt3: face " + std::to_string(number_in_mesh(control, f)) + " has " +
                                             std::to_string(edges) +
                                             " boundary edges in a step that trisects them; start with generation 0");
                },
            .reach = [](int rings) { return rings / 2 + 2; },
            .ignores_numbers = [] { return true; }};
    }
    static constexpr auto columns(int generation) { return sqrt3_split::columns(generation); }

    /// Returns the total weight of the neighbours of a vertex of valence n; Kobbelt 2000, eq. 5.
    static constexpr double alpha(std::size_t n) { return (4 - 2 * exact_cos(1, std::int64_t(n))) / 9; }

    template <step_context R>
    void operator()(const R& r) const
    {
        using namespace targets;
        const auto& [coarse, assoc, generation] = r;
        const auto alphas = by_valence(r, alpha);
        const bool odd = sqrt3_split::is_odd(generation) and not coarse.is_closed();

        const auto centers = at_faces([&](auto f) {
            if (not odd or not sqrt3_split::has_one_boundary_edge(f))
                assoc(f, V) = average(f.vertices());
        });
        const auto vertices = at_vertices([&](auto v) {
            if (not v.is_boundary()) {
                const auto ring = v.corners().map([](auto c) { return c.next().v(); });
                assoc(v, V) = around(
                    v, ring, alphas, [](auto n, auto a, auto v, auto sum) { return (1 - a) * v + a / n * sum; });
            } else if (odd) {
                assoc(v, V) = (4. * v.first_rim() + 19. * v + 4. * v.last_rim()) / 27;
            } else {
                assoc(v, V) = v;
            }
        });
        const auto thirds = at_edges([&](auto e) {
            if (not e.is_boundary() or not sqrt3_split::has_one_boundary_edge(e.lface()))
                return;
            const auto x = e.org();
            const auto y = e.dst();
            assoc(x, e, V) = (x.last_rim() + 16. * x + 10. * y) / 27;
            assoc(y, e, V) = (10. * x + 16. * y + y.first_rim()) / 27;
        });
        subdivide(sqrt3_split(), r, centers, vertices, thirds.when(odd));
    }
};

} // namespace kith
#define KITH_SCHEME sqrt3
#include <kith/schemes/compiled/in_library.hpp>
