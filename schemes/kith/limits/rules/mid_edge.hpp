// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/schemes/kernel/limit_rules.hpp>

#include <kith/mid_edge.hpp>

#include <cstdint>

namespace kith {

/// The limit rules of mid-edge. The midpoints of a face's edges have its centroid and shrink to it. The limit of a
/// vertex is that of the face made of it, at the boundary too; a vertex with a single face has the limit of that face.
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
    /// Calls use(first, second) with the tangents at an inner vertex with more than three faces. The triangle made of a
    /// vertex with three faces shrinks as fast as everything around it.
    template <level Level, class Use>
    static void tangents(const mid_edge&, const vertex<Level>& v, const Use& use)
    {
        const auto n = std::int64_t(v.valence());
        if (not v.is_boundary() and n > 3)
            use_first_wave(v.neighbors(), n, use);
    }
    static constexpr bool are_alike_where_regular = true;
    /// Returns 0: the masks read the vertex's own faces only.
    static constexpr int rings(const mid_edge&) { return 0; }
    static constexpr int tangent_steps = 0; ///< vertices with three faces never have tangents
};

} // namespace kith
