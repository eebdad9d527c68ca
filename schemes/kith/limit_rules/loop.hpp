// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rules.hpp"

#include <kith/base/cos_turn.hpp>
#include <kith/loop.hpp>

#include <cstddef>
#include <cstdint>

namespace kith {

/// The left eigenvectors of the vertex's own matrix.
template <>
struct limit_rules<loop> : crease_limits {
    template <level Level, class Use>
    static void position(const creased_scheme<loop, Level>& s, const vertex<Level>& v, const Use& use)
    {
        if (not s.sharp.is_smooth(v))
            return position_on_curve(s.sharp, v, use);
        const double n = double(v.valence());
        const double g = 1 / (n + 3 / (8 * s.scheme.beta(v.valence())));
        use((1 - n * g) * v + g * sum(v.neighbors()));
    }
    /// Hoppe et al. 1994; at boundary vertices with other than three faces the left eigenvector of the plain rule,
    /// docs/schemes.md.
    template <level Level, class Use>
    static void tangents(const creased_scheme<loop, Level>& s, const vertex<Level>& v, const Use& use)
    {
        const std::size_t k = v.face_count();
        const bool inside = s.sharp.is_smooth(v);
        if (not inside and not s.sharp.is_on_boundary_curve(v))
            return tangents_at_corner(s.sharp, v, use);
        const auto turns = std::int64_t(inside ? k : 2 * k); // the ring spans a full turn, or half of one
        const auto sine = [turns](std::size_t j) { return sin_turn(std::int64_t(j), turns); };
        if (inside) {
            use(sum(v.neighbors(), [turns](std::size_t j) { return cos_turn(std::int64_t(j), turns); }),
                sum(v.neighbors(), sine));
        } else {
            const double cotangent = cos_turn(1, 2 * turns) / sin_turn(1, 2 * turns);
            const double x = (sine(1) - cotangent) / (1 + 2 * cos_turn(1, turns));
            use(v.first_rim() - v.last_rim(), // the sines of the two boundary edges are zero
                -(2 * x + cotangent) * v + x * (v.first_rim() + v.last_rim()) + sum(v.neighbors(), sine));
        }
    }
};

} // namespace kith
