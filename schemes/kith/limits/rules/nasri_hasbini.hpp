// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/schemes/kernel/limit_rules.hpp>

#include <kith/nasri_hasbini.hpp>
#include <kith/schemes/split/require_faces.hpp>

#include <cstddef>
#include <cstdint>

namespace kith {

/// The limit rules of Nasri-Hasbini. At inner vertices among quads they are the left eigenvectors of the masks, on the
/// boundary that of the curve, whose corners stay. docs/schemes.md.
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
        const auto tangent = [&v, y](auto wave) { // j counts halves of 1/n of a turn
            return sum(v.neighbors(), [wave](std::size_t j) { return wave(2 * j); }) +
                   sum(v.opposites(), [wave, y](std::size_t j) { return y * wave(2 * j + 1); });
        };
        use(tangent(cosine_wave(2 * n)), tangent(sine_wave(2 * n)));
    }
    static constexpr bool are_alike_where_regular = true;
    /// Returns 0: the masks read the vertex's own faces only.
    static constexpr int rings(const nasri_hasbini&) { return 0; }
};

} // namespace kith
