// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rules.hpp"

#include <kith/loop.hpp>

namespace kith {

/// The left eigenvectors of the vertex's own matrix.
template <>
struct limit_rules<loop> : crease_limits {
    template <level Level, class Use>
    static void position(const creased_scheme<loop, Level>& s, const vertex<Level>& v, const Use& use)
    {
        if (not s.sharp.is_smooth(v))
            return position_on_curve(s, v, use);
        const double n = double(v.valence());
        const double g = 1 / (n + 3 / (8 * s.scheme.beta(v.valence())));
        use((1 - n * g) * v + g * sum(v.neighbors()));
    }
    /// Hoppe et al. 1994; at boundary vertices with other than three faces the left eigenvector of the plain rule,
    /// docs/schemes.md.
    template <level Level, class Use>
    static void tangents(const creased_scheme<loop, Level>& s, const vertex<Level>& v, const Use& use)
    {
        const auto ring = turns_of_ring(s, v);
        if (not ring)
            return tangents_at_corner(s, v, use);
        const auto [inside, turns] = *ring;
        if (inside) {
            use_first_wave(v.neighbors(), turns, use);
        } else {
            const auto sine = sine_wave(turns);
            const double cotangent = cosine_wave(2 * turns)(1) / sine_wave(2 * turns)(1);
            const double x = (sine(1) - cotangent) / (1 + 2 * cosine_wave(turns)(1));
            use(v.first_rim() - v.last_rim(), // the sines of the two boundary edges are zero
                -(2 * x + cotangent) * v + x * (v.first_rim() + v.last_rim()) + sum(v.neighbors(), sine));
        }
    }
};

} // namespace kith
