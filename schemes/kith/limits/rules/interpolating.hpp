// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/schemes/kernel/limit_rules.hpp>

#include <kith/interpolatory_sqrt3.hpp>
#include <kith/linear.hpp>

namespace kith {

/// The limit rules of schemes that move no vertex.
struct interpolating_limits : limit_defaults {
    template <scheme Scheme, level Level, class Use>
    static void position(const Scheme&, const vertex<Level>& v, const Use& use)
    {
        use(sum(v));
    }
    template <scheme Scheme>
    static constexpr int rings(const Scheme&)
    {
        return 0;
    }
};

template <>
struct limit_rules<linear> : interpolating_limits {};

template <>
struct limit_rules<linear_triangles> : interpolating_limits {};

template <>
struct limit_rules<interpolatory_sqrt3> : interpolating_limits {
    /// Returns the reach of sqrt3.
    static constexpr int reach(const interpolatory_sqrt3&, int rings) { return rings / 2 + 2; }
};

} // namespace kith
