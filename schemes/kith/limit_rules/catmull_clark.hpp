// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rules.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/split/require_faces.hpp>

#include <cmath>
#include <cstddef>

namespace kith {

/// Halstead, Kass & DeRose 1993, where all faces at a vertex are quads.
template <>
struct limit_rules<catmull_clark> : crease_limits {
    template <level Level, class Use>
    static void position(const creased_scheme<catmull_clark, Level>& s, const vertex<Level>& v, const Use& use)
    {
        if (not s.sharp.is_smooth(v))
            return position_on_curve(s, v, use);
        if (not has_quads_only(v))
            return;
        const double n = double(v.valence());
        use((n * n * v + 4. * sum(v.neighbors()) + sum(v.opposites())) / (n * (n + 5)));
    }
    /// Inside Halstead et al.; along a boundary the left eigenvectors of the plain rule, docs/schemes.md.
    template <level Level, class Use>
    static void tangents(const creased_scheme<catmull_clark, Level>& s, const vertex<Level>& v, const Use& use)
    {
        if (not has_quads_only(v))
            return;
        const auto ring = turns_of_ring(s, v);
        if (not ring)
            return tangents_at_corner(s, v, use);
        const auto [inside, turns] = *ring;
        const auto cosine = cosine_wave(turns);
        const auto sine = sine_wave(turns);
        const double c = cosine(1), half = cosine_wave(2 * turns)(1);
        const double lambda = 5. / 16 + (c + half * std::sqrt(2 * (9 + c))) / 16;
        const double mu = 1 / (4 * lambda - 1);
        const auto along_edges = [](auto f) { return [f](std::size_t j) { return 4 * f(j); }; };
        const auto along_faces = [mu](auto f) { return [f, mu](std::size_t j) { return mu * (f(j) + f(j + 1)); }; };
        if (inside) {
            use(sum(v.neighbors(), along_edges(cosine)) + sum(v.opposites(), along_faces(cosine)),
                sum(v.neighbors(), along_edges(sine)) + sum(v.opposites(), along_faces(sine)));
        } else {
            const double cotangent = half / sine_wave(2 * turns)(1);
            const double x = mu * ((1 + mu) * sine(1) - (2 + mu) * cotangent);
            use(v.first_rim() - v.last_rim(), // the sines of the two boundary edges are zero
                -(2 * x + (4 + 2 * mu) * cotangent) * v + x * (v.first_rim() + v.last_rim()) +
                    sum(v.neighbors(), along_edges(sine)) + sum(v.opposites(), along_faces(sine)));
        }
    }
};

} // namespace kith
