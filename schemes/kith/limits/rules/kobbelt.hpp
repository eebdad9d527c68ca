// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "interpolating.hpp"

#include <kith/kobbelt.hpp>

namespace kith {

/// The limit rules of Kobbelt's scheme: the tangents of the two four-point curves through v, if v and its neighbours
/// are regular and inside. docs/schemes.md. Errors: mesh_error for a tension outside its range.
template <>
struct limit_rules<kobbelt> : interpolating_limits {
    template <level Level, class Use>
    static void tangents(const kobbelt& s, const vertex<Level>& v, const Use& use)
    {
        s.require_weights();
        const auto is_regular = [](const vertex<Level>& x) { return not x.is_boundary() and x.has_valence(4); };
        if (not is_regular(v))
            return;
        for (const auto u : v.neighbors())
            if (not is_regular(u))
                return;
        const auto back = [](auto c) { return c.prev().across().prev().across(); }; // the line of c, reversed
        const auto end = [](auto c) { return c.next().v(); };
        const auto curve = [&](auto c) {
            const auto far = [&](auto d) { return end(back(d.across())); };
            return end(c) - end(back(c)) - s.tension / 8 * (far(c) - far(back(c)));
        };
        use(curve(v.first_corner()), curve(v.first_corner().prev().across()));
    }
    /// Returns 1: the masks read the faces of the neighbours.
    static constexpr int rings(const kobbelt&) { return 1; }
};

} // namespace kith
