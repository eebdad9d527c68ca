// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/exact_cos.hpp>
#include <kith/numbering/step/rules.hpp>
#include <kith/numbering/step/scheme_traits.hpp>
#include <kith/schemes/kernel/irregular_rings.hpp>
#include <kith/schemes/split/require_faces.hpp>
#include <kith/schemes/split/sqrt3_split.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace kith {

/// Interpolatory sqrt(3): for closed meshes of triangles, three times as many per step, and no point moves. Labsik &
/// Greiner 2000. C1; cubics are reproduced where all vertices have six neighbours. Cost: O(corners); the n corners of
/// large fans cost O(n log n).
struct interpolatory_sqrt3 {
    static constexpr auto traits()
    {
        return scheme_traits{.name = "interpolatory-sqrt3",
                             .faces = face_shape::triangles,
                             .closed_only = true,
                             .trusted = true,
                             .require = three_faces_at_vertices,
                             .ignores_numbers = [] { return true; }};
    }
    static constexpr auto columns(int generation) { return sqrt3_split::columns(generation); }

    /// Returns the weights of the neighbours of a vertex of valence n >= 5. They depend on the angle from the middle of
    /// the face that contains the new point. The vertex itself has the rest. Labsik & Greiner 2000, section 3.
    static constexpr wave_kernel ring_kernel(std::size_t n)
    {
        const double a = 2. / 3 * exact_cos(1, 2 * std::int64_t(n));
        return {a * a, a, a * a};
    }
    /// Returns the weights of the n neighbours, counter-clockwise from the face.
    static std::vector<double> ring_weights(std::size_t n)
    {
        if (n == 3)
            return {4. / 27, -5. / 27, 4. / 27};
        if (n == 4)
            return {2. / 9, -1. / 9, -1. / 9, 2. / 9};
        return ring_kernel(n).row(1, n);
    }
    /// Returns the weight of the vertex itself: one minus those of its neighbours.
    static constexpr double center_weight(std::size_t n)
    {
        return n == 3 ? 8. / 9 : n == 4 ? 7. / 9 : 1 - ring_kernel(n).x0;
    }

    template <step_context R>
    void operator()(const R& r) const
    {
        using namespace targets;
        const auto& assoc = r.assoc;
        const irregular_rings rings(r, 6, ring_weights, ring_kernel);

        const auto centers = at_faces([&](auto f) {
            const auto corners = f.corners();
            const auto irregular = corners.only([&](auto c) { return not rings.is_regular(c.v()); });
            if (irregular.begin() == irregular.end()) {
                const auto tip = [](auto c) { return c.across().prev().v(); };
                const auto clockwise = [](auto c) { return c.across().next(); };
                const auto behind = [&](auto c) { // the two neighbours of its vertex that lie away from the face
                    const auto opposite = clockwise(clockwise(clockwise(c)));
                    return opposite.next().v() + opposite.prev().v();
                };
                assoc(f, V) = (32. * sum(f.vertices()) - sum(corners.map(tip)) - 2. * sum(corners.map(behind))) / 81;
            } else {
                assoc(f, V) = average(irregular.map(
                    [&](auto c) { return center_weight(rings.valence(c)) * c.v() + rings.sum_from_face(c); }));
            }
        });
        subdivide(sqrt3_split(), r, kept_vertices(), centers);
    }
};

} // namespace kith
#define KITH_SCHEME interpolatory_sqrt3
#include <kith/schemes/compiled/in_library.hpp>
