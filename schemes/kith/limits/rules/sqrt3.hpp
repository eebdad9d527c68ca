// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/schemes/kernel/limit_rules.hpp>

#include <kith/sqrt3.hpp>

#include <cstdint>

namespace kith {

/// The limit rules of sqrt(3): Kobbelt 2000, section 4; on the boundary the ternary cubic B-spline. Inner vertices of a
/// face at the boundary have no mask, since the odd steps cut their rings.
template <>
struct limit_rules<sqrt3> : limit_defaults {
    template <level Level, class Use>
    static void position(const sqrt3& s, const vertex<Level>& v, const Use& use)
    {
        if (v.is_boundary())
            return use((v.first_rim() + 4. * v + v.last_rim()) / 6);
        if (touches_boundary_face(v))
            return;
        const double b = 3 * s.alpha(v.valence()) / (1 + 3 * s.alpha(v.valence()));
        use((1 - b) * v + b * average(v.neighbors()));
    }
    /// Calls use(first, second) with the tangents at an inner vertex without a face at the boundary.
    template <level Level, class Use>
    static void tangents(const sqrt3&, const vertex<Level>& v, const Use& use)
    {
        const auto n = std::int64_t(v.valence());
        if (not v.is_boundary() and not touches_boundary_face(v))
            use_first_wave(v.neighbors(), n, use);
    }
    static constexpr bool are_alike_where_regular = true;
    /// Returns 1: the masks read the faces across the sides of the vertex's own faces.
    static constexpr int rings(const sqrt3&) { return 1; }

private:
    template <vertex_element Vertex>
    static bool touches_boundary_face(const Vertex& v)
    {
        for (const auto f : v.faces())
            if (f.is_boundary())
                return true;
        return false;
    }
};

} // namespace kith
