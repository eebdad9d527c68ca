// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/mask/choose.hpp>
#include <kith/loop.hpp>
#include <kith/numbering/step/rules.hpp>
#include <kith/numbering/step/scheme_traits.hpp>
#include <kith/schemes/crease/sharp_rules.hpp>
#include <kith/schemes/split/quad_triangle_split.hpp>
#include <kith/schemes/split/require_faces.hpp>

#include <cstddef>

namespace kith {

/// Quad-triangle: Catmull-Clark where all faces are quads, Loop where all are triangles, and one surface over both.
/// Stam & Loop 2003: the linear split, then an average of each vertex with its neighbours. Triangles stay triangles;
/// all other polygons become quads. Boundary: uniform cubic B-spline. C2, at extraordinary vertices and between quads
/// and triangles C1. It takes no tiles. Cost: O(corners).
struct quad_tri {
    boundary_corner corners = boundary_corner::kept;
    creases sharpness{}; ///< of this level's edges and vertices; each step computes those of the next level
    friend bool operator==(const quad_tri&, const quad_tri&) = default;

    /// Returns the weight of each neighbour and of each new face point in the point of a vertex of valence n. `others`
    /// is the number of its faces that are no triangles. The average weighs a vertex by a, its neighbours by a/2 and
    /// the opposite vertices of its quads by a/4, with 1/a = 1 + n/2 + others/4. Among quads, and among triangles
    /// alone, the weights are those of Catmull-Clark and Loop.
    static constexpr double weight(std::size_t n, std::size_t others)
    {
        if (others == 0)
            return loop().beta(n);
        const double k = double(n);
        return others == n ? 1 / (k * k) : 1 / (4 + 2 * k + double(others));
    }

    static constexpr auto traits()
    {
        return scheme_traits{
            .name = "quad-tri",
            .trusted = true,
            .require = [](const auto& level, int) { require_three_faces<quad_tri>(level, face_shape::triangles); },
            .state = &quad_tri::sharpness,
            .ignores_numbers = [](const quad_tri& s) { return s.sharpness.empty(); }};
    }
    static constexpr auto columns() { return quad_triangle_split::columns(); }

    template <step_context R>
    void operator()(const R& r) const
    {
        using namespace targets;
        using real = scalar_type<R>;
        const auto& [coarse, assoc, generation] = r;
        const sharp_rules sharp(coarse, sharpness, corners);
        const auto among_triangles = by_valence(r, [](std::size_t n) { return weight(n, 0); });
        const auto among_others = by_valence(r, [](std::size_t n) { return weight(n, n); });

        for_each(coarse.faces(), [&](auto f) {
            if (not is_in_triangle(f))
                assoc(f, V) = average(f.vertices());
        });

        const auto edge_point = [&](auto e) {
            // The face on the side of corner c: the weights of its vertices at e and beside them, and of its centre.
            const auto side = [&assoc](auto c) {
                const auto ends = c.v() + c.next().v(), beside = c.next().next().v() + c.prev().v();
                return choose(
                    is_in_triangle(c),
                    [=] { return 1. / 16 * (ends + beside); },
                    [=, &assoc] { return 1. / 32 * (ends + beside) + 1. / 8 * assoc(c.f(), V); });
            };
            return 1. / 4 * (e.org() + e.dst()) + side(e.lcorner()) + side(e.rcorner());
        };
        const auto vertex_point = [&](auto v) {
            std::size_t n = 0, others = 0;
            for (const auto c : v.corners())
                ++n, others += not is_in_triangle(c);
            const real w = others == 0 ? among_triangles(n) : others == n ? among_others(n) : real(weight(n, others));
            const auto ring = v.corners().map([&assoc](auto c) {
                return choose(
                    is_in_triangle(c),
                    [c] { return c.next().v(); },
                    [c, &assoc] { return c.next().v() + assoc(c.f(), V); });
            });
            const real operands(double(n + others));
            return (1 - w * operands) * v + w * sum(ring);
        };
        subdivide(quad_triangle_split(), r, sharp.at_edges(edge_point), sharp.at_vertices(vertex_point));
    }
};

} // namespace kith
#define KITH_SCHEME quad_tri
#include <kith/schemes/compiled/in_library.hpp>
