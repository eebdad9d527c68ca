// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "library.hpp"

#include <kith/base/cos_turn.hpp>
#include <kith/split/mid_edge_split.hpp>
#include <kith/split/require_faces.hpp>

#include <cstdint>

namespace kith {

/// The mid-edge scheme, the simplest there is: the midpoints of all edges. Peters & Reif 1997. C1 (quadratic box spline in
/// the regular part; triangles that stay are the weak spot). Meant for closed meshes: a boundary loop keeps its number of
/// edges and contracts. Cost: O(corners).
struct mid_edge {
    static constexpr auto traits()
    {
        return scheme_traits{.name = "mid-edge",
                             .trusted = true,
                             .require = [](const auto& level, int) { require_three_faces<mid_edge>(level); },
                             .reach = [](int rings) { return rings + 1; }};
    }
    static constexpr auto columns() { return mid_edge_split::columns(); }

    static mid_edge like(library other)
    {
        if (other != library::kith and other != library::openmesh)
            refuse_preset<mid_edge>("kith and, for closed meshes, OpenMesh");
        return {};
    }

    /// The midpoints of a face's edges have its centroid and shrink to it. A vertex goes with the face that is made of it, at the
    /// boundary too; one with a single face goes with that.
    template <class Level, class Use>
    void limit_position(const vertex<Level>& v, const Use& use) const
    {
        if (v.is_boundary() and v.face_count() == 1)
            use(average(v.first_corner().f().vertices()));
        else
            use(1. / 2 * v + 1. / 2 * average(v.neighbors()));
    }
    template <class Level, class Use>
    void limit_position(const face<Level>& f, const Use& use) const
    {
        use(average(f.vertices()));
    }
    /// Two tangents, counter-clockwise, inside and but for three faces, whose triangle shrinks as fast as all around it.
    template <class Level, class Use>
    void limit_tangents(const vertex<Level>& v, const Use& use) const
    {
        const auto n = std::int64_t(v.valence());
        if (not v.is_boundary() and n > 3)
            use(sum(v.neighbors(), [n](std::size_t j) { return cos_turn(std::int64_t(j), n); }),
                sum(v.neighbors(), [n](std::size_t j) { return sin_turn(std::int64_t(j), n); }));
    }
    static constexpr int tangent_steps = 0; ///< those of three faces stay without

    template <class R>
    void operator()(const R& r) const
    {
        using namespace targets;
        const auto& [coarse, assoc, generation] = r;
        for_each(coarse.edges(), [&](auto e) { assoc(e, V) = average(e.org(), e.dst()); });
        mid_edge_split::connect(r);
    }
};

} // namespace kith
