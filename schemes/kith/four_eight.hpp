// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bisection_split.hpp"
#include "library.hpp"
#include "tri_quad.hpp"

#include <cstddef>
#include <string_view>

namespace kith {

/// 4-8: the four-directional box spline by bisection, twice the triangles per step. Velho & Zorin 2001; the masks are those
/// of the box spline of degree six (docs/schemes.md). C4, at extraordinary vertices C1. Takes a tri-quad mesh, which
/// `tri_quad` makes of any mesh. Cost: O(corners).
struct four_eight {
    static constexpr std::string_view name = "4-8";
    static constexpr bool triangles_only = true;
    static constexpr bool trusted = true;
    static constexpr auto columns() { return bisection_split::columns(); }
    static constexpr counts next(const counts& c, int generation) { return bisection_split::next(c, generation); }

    static four_eight like(library other)
    {
        if (other != library::kith)
            refuse_preset(name, "kith alone");
        return {};
    }

    template <class R>
    void operator()(const R& r) const
    {
        using namespace targets;
        const auto& [coarse, assoc, generation] = r;
        if (generation <= 1)
            bisection_split::require_marks(coarse);

        for_each(coarse.edges(), [&](auto e) {
            if (not bisection_split::is_marked(e))
                return;
            if (e.is_boundary())
                assoc(e, V) = average(e.org(), e.dst());
            else
                assoc(e, V) = average(e.org(), e.dst(), e.lcorner().prev().v(), e.rcorner().prev().v());
        });

        for_each(coarse.vertices(), [&](auto v) {
            if (not v.is_boundary()) {
                const auto unmarked = v.edges().only([](const auto& e) { return not bisection_split::is_marked(e); });
                const auto other_end = [v](const auto& e) { return e.org() == v ? e.dst() : e.org(); };
                assoc(v, V) = 1. / 2 * v + 1. / 2 * average(unmarked.map(other_end));
            } else if (bisection_split::is_marked(v.first_corner().next_edge()) and
                       bisection_split::is_marked(v.last_corner().prev_edge())) {
                assoc(v, V) = 3. / 4 * v + 1. / 8 * (v.first_rim() + v.last_rim());
            } else {
                assoc(v, V) = v;
            }
        });

        bisection_split::connect(r);
    }
};

} // namespace kith
