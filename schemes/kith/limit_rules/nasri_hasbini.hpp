// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rules.hpp"

#include <kith/base/cos_turn.hpp>
#include <kith/nasri_hasbini.hpp>
#include <kith/split/require_faces.hpp>

#include <cstddef>
#include <cstdint>

namespace kith {

/// Inside, among quads, the left eigenvectors of the masks; on the boundary that of the curve, whose corners stay.
/// docs/schemes.md.
template <>
struct limit_rules<nasri_hasbini> : limit_defaults {
    template <level Level, class Use>
    static void position(const nasri_hasbini&, const vertex<Level>& v, const Use& use)
    {
        if (v.is_boundary() and v.face_count() == 1)
            use(sum(v));
        else if (v.is_boundary())
            use((v.first_rim() + 4. * v + v.last_rim()) / 6);
        else if (has_quads_only(v))
            use((4. * v + 4. * average(v.neighbors()) + average(v.opposites())) / 9);
    }
    template <level Level, class Use>
    static void tangents(const nasri_hasbini&, const vertex<Level>& v, const Use& use)
    {
        const auto n = std::int64_t(v.valence());
        if (v.is_boundary() or n < 3 or not has_quads_only(v))
            return;
        const double y = n == 3 ? 11. / 43 : n == 4 ? 1 / (2 * detail::sqrt2) : 1 / (3 * detail::sqrt2);
        const auto cosine = [n](std::int64_t half_steps) { return cos_turn(half_steps, 2 * n); };
        const auto sine = [n](std::int64_t half_steps) { return sin_turn(half_steps, 2 * n); };
        const auto wave = [&v, y](auto f) {
            return sum(v.neighbors(), [f](std::size_t j) { return f(2 * std::int64_t(j)); }) +
                   sum(v.opposites(), [f, y](std::size_t j) { return y * f(2 * std::int64_t(j) + 1); });
        };
        use(wave(cosine), wave(sine));
    }
};

} // namespace kith
