// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "interpolating.hpp"

#include <kith/base/cos_turn.hpp>
#include <kith/butterfly.hpp>

#include <cstddef>
#include <cstdint>

namespace kith {

/// Tangents inside, where the masks around v do not reach another irregular vertex: after one step, everywhere. Around
/// an irregular vertex the cosines of the ring, around a regular one those of two rings. docs/schemes.md.
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
        const auto wave = [&v, n](auto f) {
            return sum(v.neighbors(), [f, n](std::size_t j) { return f(std::int64_t(j), n); });
        };
        const auto cosine = [](std::int64_t k, std::int64_t turn) { return cos_turn(k, turn); };
        const auto sine = [](std::int64_t k, std::int64_t turn) { return sin_turn(k, turn); };
        if (n != 6)
            return use(wave(cosine), wave(sine));
        const auto across = v.corners().map([](auto c) { return c.next().across().prev().v(); });
        const auto behind = v.corners().map([](auto c) { return c.next().across().next().across().prev().v(); });
        const auto two_rings = [&](auto f) {
            constexpr double sqrt3 = 1.7320508075688772935;
            return 16. * wave(f) +
                   -8 / sqrt3 * sum(across, [f](std::size_t j) { return f(2 * std::int64_t(j) + 1, 12); }) +
                   sum(behind, [f](std::size_t j) { return f(std::int64_t(j), 6); });
        };
        use(two_rings(cosine), two_rings(sine));
    }
};

} // namespace kith
