// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "library.hpp"

#include <kith/base/cos_turn.hpp>
#include <kith/crease/sharp_rules.hpp>
#include <kith/limit/limit.hpp>
#include <kith/split/quad_split.hpp>
#include <kith/step/blocks.hpp>

#include <cmath>
#include <cstdint>

namespace kith {

/// Catmull-Clark: uniform bicubic B-splines for polygon meshes of any kind. After one step all faces are quads.
/// Catmull & Clark 1978; v-mask as DeRose, Kass & Truong 1998 write it, with e the old neighbours (the thesis, 2.1.1, adds
/// the new e-points instead, which is not Catmull-Clark; docs/schemes.md). Boundary: uniform cubic B-spline.
/// C2, at extraordinary vertices C1. Cost: O(corners).
struct catmull_clark {
    boundary_corner corners = boundary_corner::kept;
    creases sharpness{}; ///< of this level's edges and vertices; handed on to the next level

    static constexpr auto traits()
    {
        return scheme_traits{.name = "catmull-clark",
                             .trusted = true,
                             .reach = [](const catmull_clark& s, int rings) { return s.sharpness.reach(rings); },
                             .state = &catmull_clark::sharpness,
                             .ignores_numbers = [](const catmull_clark& s) { return s.sharpness.empty(); }};
    }
    static constexpr auto columns() { return quad_split::columns(); }

    /// CGAL and OpenMesh smooth boundary corners. OpenMesh's boundary curve itself, 1/6 4/6 1/6, is not the B-spline and
    /// is not followed: on meshes with a boundary the result differs from OpenMesh's.
    static catmull_clark like(library other)
    {
        if (other == library::libigl)
            refuse_preset<catmull_clark>("kith, CGAL, OpenMesh and OpenSubdiv");
        const bool smooth = other == library::cgal or other == library::openmesh;
        return {.corners = smooth ? boundary_corner::smoothed : boundary_corner::kept};
    }

    /// Halstead, Kass & DeRose 1993; `use(mask)` is called unless no closed mask is known for v.
    template <class Level, class Use>
    void limit_position(const sharp_rules<Level>& sharp, const vertex<Level>& v, const Use& use) const
    {
        if (not sharp.is_smooth(v))
            return limit_on_curve(sharp, v, use);
        for (const auto c : v.corners())
            if (c.f().degree() != 4)
                return;
        const double n = double(v.valence());
        use((n * n * v + 4. * sum(v.neighbors()) + sum(v.opposites())) / (n * (n + 5)));
    }
    /// Two tangents, counter-clockwise. Inside: Halstead et al.; along a boundary the left eigenvectors of the plain rule,
    /// docs/schemes.md.
    template <class Level, class Use>
    void limit_tangents(const sharp_rules<Level>& sharp, const vertex<Level>& v, const Use& use) const
    {
        for (const auto c : v.corners())
            if (c.f().degree() != 4)
                return;
        const std::size_t k = v.face_count();
        const bool inside = sharp.is_smooth(v);
        if (not inside and not sharp.is_on_boundary_curve(v))
            return limit_at_corner(sharp, v, use);
        const auto turns = std::int64_t(inside ? k : 2 * k); // the ring spans a full turn, or half of one
        const double c = cos_turn(1, turns), half = cos_turn(1, 2 * turns);
        const double lambda = 5. / 16 + (c + half * std::sqrt(2 * (9 + c))) / 16;
        const double mu = 1 / (4 * lambda - 1);
        const auto sine = [turns](std::size_t j) { return sin_turn(std::int64_t(j), turns); };
        const auto cosine = [turns](std::size_t j) { return cos_turn(std::int64_t(j), turns); };
        const auto along_edges = [](auto f) { return [f](std::size_t j) { return 4 * f(j); }; };
        const auto along_faces = [mu](auto f) { return [f, mu](std::size_t j) { return mu * (f(j) + f(j + 1)); }; };
        if (inside) {
            use(sum(v.neighbors(), along_edges(cosine)) + sum(v.opposites(), along_faces(cosine)),
                sum(v.neighbors(), along_edges(sine)) + sum(v.opposites(), along_faces(sine)));
        } else {
            const double cotangent = half / sin_turn(1, 2 * turns);
            const double x = mu * ((1 + mu) * sine(1) - (2 + mu) * cotangent);
            use(v.first_rim() - v.last_rim(), // the sines of the two boundary edges are zero
                -(2 * x + (4 + 2 * mu) * cotangent) * v + x * (v.first_rim() + v.last_rim()) +
                    sum(v.neighbors(), along_edges(sine)) + sum(v.opposites(), along_faces(sine)));
        }
    }

    template <class R>
    void operator()(const R& r) const
    {
        using namespace targets;
        using real = scalar_type<R>;
        const auto& [coarse, assoc, generation] = r;
        const sharp_rules sharp(coarse, sharpness, corners);

        for_each(coarse.faces(), [&](auto f) { assoc(f, V) = average(f.vertices()); });

        in_blocks(r, [&](const auto& block) {
            sharp.make_edges(
                block, [&](auto e) { return average(e.org(), e.dst(), assoc(e.lface(), V), assoc(e.rface(), V)); });

            sharp.make_vertices(block, [&](auto v) {
                const auto ring = v.corners().map([&](auto c) { return c.next().v() + assoc(c.f(), V); });
                return around(v, ring, [](std::size_t valence) {
                    const auto n = real(double(valence));
                    return ring_weights<real>{(n - 2) / n, 1 / (n * n)};
                });
            });

            quad_split::connect(block);
        });
    }
};

} // namespace kith
