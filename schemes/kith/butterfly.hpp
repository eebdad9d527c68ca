// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/numbering/step/rules.hpp>
#include <kith/schemes/kernel/irregular_rings.hpp>
#include <kith/schemes/split/require_faces.hpp>
#include <kith/schemes/split/triangle_split.hpp>

#include <cstddef>
#include <vector>

namespace kith {

/// The modified Butterfly scheme: interpolating, for triangles. Dyn, Gregory & Levin 1990; Zorin, Schroeder & Sweldens
/// 1996, section 3. An end of an edge is irregular if it is an inner vertex whose valence is not 6. Boundary: the
/// four-point curve; wings beyond it are reflected. C1. Cost: O(corners); the n corners of large fans cost O(n log n).
struct butterfly {
    static constexpr auto traits()
    {
        return scheme_traits{.name = "butterfly",
                             .faces = face_shape::triangles,
                             .trusted = true,
                             .require = three_faces_at_vertices,
                             .reach = [](int rings) { return (rings + 1) / 2 + 1; },
                             .ignores_numbers = [] { return true; }};
    }
    static constexpr auto columns() { return triangle_split::columns(); }

    /// Returns the weights of the neighbours of an irregular vertex of valence n >= 5 by the angle from the other end
    /// of the edge: (1/4 + cos t + 1/2 cos 2t)/n. ZSS 1996.
    static constexpr wave_kernel ring_kernel(std::size_t) { return {1. / 4, 1. / 2, 1. / 4}; }
    /// Returns the weights of the n neighbours of an irregular vertex, beginning with the other end of the edge.
    static std::vector<double> ring_weights(std::size_t n)
    {
        if (n == 3)
            return {5. / 12, -1. / 12, -1. / 12};
        if (n == 4)
            return {3. / 8, 0, -1. / 8, 0};
        return ring_kernel(n).row(0, n);
    }

    template <step_context R>
    void operator()(const R& r) const
    {
        using namespace targets;
        const auto& assoc = r.assoc;
        const irregular_rings rings(r, 6, ring_weights, ring_kernel);

        const auto edges = at_edges([&](auto e) {
            const auto x = e.org();
            const auto y = e.dst();
            if (e.is_boundary()) {
                assoc(e, V) = 9. / 16 * (x + y) + -1. / 16 * (x.last_rim() + y.first_rim());
                return;
            }
            const auto l = e.lcorner(); // the corner of x
            const auto r = e.rcorner(); // the corner of y
            const auto around = [&](auto c) { return 3. / 4 * c.v() + rings.sum_from_edge(c); };
            if (rings.is_regular(x) and rings.is_regular(y))
                assoc(e, V) = 1. / 2 * (x + y) + 1. / 8 * (l.prev().v() + r.prev().v()) +
                              -1. / 16 * (wing(l.next()) + wing(l.prev()) + (wing(r.next()) + wing(r.prev())));
            else if (rings.is_regular(y))
                assoc(e, V) = around(l);
            else if (rings.is_regular(x))
                assoc(e, V) = around(r);
            else
                assoc(e, V) = (around(l) + around(r)) / 2;
        });
        subdivide(triangle_split(), r, kept_vertices(), edges);
    }

private:
    /// Returns the vertex across the next edge of c or, at the boundary, the reflection of the triangle's own third
    /// vertex.
    template <corner_element Corner>
    static auto wing(const Corner& c)
    {
        return choose(
            c.is_boundary(),
            [c] { return c.v() + c.next().v() - c.prev().v(); },
            [c] { return sum(c.across().prev().v()); });
    }
};

} // namespace kith
#define KITH_SCHEME butterfly
#include <kith/schemes/compiled/in_library.hpp>
