// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "interpolating.hpp"

#include <kith/butterfly.hpp>

#include <cstddef>
#include <cstdint>

namespace kith {

/// The limit rules of Butterfly: tangents at inner vertices, if the masks around v reach no other irregular vertex.
/// After one step this holds everywhere. Around an irregular vertex they are the cosines of the ring, around a regular
/// one those of two rings. docs/schemes.md.
template <>
struct limit_rules<butterfly> : interpolating_limits {
    template <level Level, class Use>
    static void tangents(const butterfly&, const vertex<Level>& v, const Use& use)
    {
        if (v.is_boundary())
            return;
        const auto n = std::int64_t(v.valence());
        for (const auto u : v.neighbors())
            if (u.is_boundary() ? n == 6 : not u.has_valence(6))
                return;
        if (n != 6)
            return use_first_wave(v.neighbors(), n, use);
        const auto across = v.corners().map([](auto c) { return c.next().across().prev().v(); });
        const auto behind = v.corners().map([](auto c) { return c.next().across().next().across().prev().v(); });
        const auto two_rings = [&](auto wave, auto between) { // of the ring, and of vertices between its points
            constexpr double sqrt3 = 1.7320508075688772935;
            return 16. * sum(v.neighbors(), wave) +
                   -8 / sqrt3 * sum(across, [between](std::size_t j) { return between(2 * j + 1); }) +
                   sum(behind, wave);
        };
        use(two_rings(cosine_wave(6), cosine_wave(12)), two_rings(sine_wave(6), sine_wave(12)));
    }
    /// Returns 1: the masks read the faces of the neighbours.
    static constexpr int rings(const butterfly&) { return 1; }
};

} // namespace kith
