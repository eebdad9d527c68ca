// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/schemes/kernel/limit_rules.hpp>

#include <kith/mid_edge.hpp>

#include <cstdint>

namespace kith {

/// The midpoints of a face's edges have its centroid and shrink to it. A vertex goes with the face that is made of it,
/// at the boundary too; one with a single face goes with that.
template <>
struct limit_rules<mid_edge> : limit_defaults {
    template <level Level, class Use>
    static void position(const mid_edge&, const vertex<Level>& v, const Use& use)
    {
        if (v.is_boundary() and v.face_count() == 1)
            use(average(v.first_corner().f().vertices()));
        else
            use(1. / 2 * v + 1. / 2 * average(v.neighbors()));
    }
    template <level Level, class Use>
    static void position(const mid_edge&, const face<Level>& f, const Use& use)
    {
        use(average(f.vertices()));
    }
    /// Inside and but for three faces, whose triangle shrinks as fast as all around it.
    template <level Level, class Use>
    static void tangents(const mid_edge&, const vertex<Level>& v, const Use& use)
    {
        const auto n = std::int64_t(v.valence());
        if (not v.is_boundary() and n > 3)
            use_first_wave(v.neighbors(), n, use);
    }
    static constexpr bool are_alike_where_regular = true;
    /// The masks ask about the vertex's own faces alone.
    static constexpr int rings(const mid_edge&) { return 0; }
    static constexpr int tangent_steps = 0; ///< those of three faces stay without
};

} // namespace kith
