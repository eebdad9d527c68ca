// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/error.hpp>
#include <kith/numbering/step/rules.hpp>
#include <kith/numbering/step/scheme_traits.hpp>
#include <kith/schemes/kernel/virtual_points.hpp>
#include <kith/schemes/split/quad_split.hpp>

#include <cmath>
#include <string>

namespace kith {

/// Kobbelt's interpolating scheme for quads: the four-point scheme in both directions. Kobbelt 1996. C1. Every new
/// point follows the four-point rule along a line of the mesh. If no line goes on beyond a vertex, a virtual point
/// replaces the missing one. `gamma` weighs the vertices opposite an extraordinary vertex in its virtual points. With
/// the default the two directions of a face at such a vertex agree (docs/schemes.md). Boundary: four-point curve,
/// corners kept. Errors: mesh_error for a tension outside its range. Cost: O(corners); the n corners of large fans cost
/// O(n log n).
struct kobbelt {
    double tension = 1; ///< w, 0 < w < max_tension
    double gamma = tension / (8 + tension);
    static constexpr double max_tension = 2.472135954999579; ///< 2 (sqrt 5 - 1), up to which curves are smooth
    friend bool operator==(const kobbelt&, const kobbelt&) = default;

    static constexpr auto traits()
    {
        return scheme_traits{.name = "kobbelt",
                             .faces = face_shape::quads,
                             .trusted = true,
                             .require = [](const kobbelt& s, const auto&, int) { s.require_weights(); },
                             .reach = [](int rings) { return (rings + 1) / 2 + 2; },
                             .ignores_numbers = [] { return true; }};
    }
    static constexpr auto columns() { return quad_split::columns(); }

    /// Throws mesh_error for weights with which no step can be made.
    void require_weights() const
    {
        if (not(tension > 0 and tension < max_tension)) // NaN is neither
            throw mesh_error("kobbelt: a tension of " + std::to_string(tension) +
                             " was asked for; ask for one between 0 and 2.472");
        if (not std::isfinite(gamma))
            throw mesh_error("kobbelt: gamma is " + std::to_string(gamma) + "; give it a finite number");
    }

    template <step_context R>
    void operator()(const R& r) const
    {
        using namespace targets;
        using real = scalar_type<R>;
        require_weights();
        const auto& [coarse, assoc, generation] = r;
        const auto outer = real(-tension / 16);
        const auto inner = real((8 + tension) / 16);
        const virtual_points points(r, gamma);

        for_each(coarse.edges(), [&](auto e) {
            points.beyond_ends(e, [&](const auto& before, const auto& after) {
                assoc(e, V) = inner * (e.org() + e.dst()) + outer * (before + after);
            });
        });

        const auto centers = at_faces([&](auto f) {
            const auto far = [&](auto c) { // the next edge point across the next edge of c
                const auto opposite = c.next().next().next_edge();
                return choose(
                    c.is_boundary(),
                    [=, &assoc] { return 2. * assoc(c.next_edge(), V) - assoc(opposite, V); },
                    [c, &assoc] { return sum(assoc(c.across().next().next().next_edge(), V)); });
            };
            const auto across = [&](auto a) {
                const auto b = a.next().next();
                return inner * (assoc(a.next_edge(), V) + assoc(b.next_edge(), V)) + outer * (far(a) + far(b));
            };
            const auto c = f.first_corner();
            return (across(c) + across(c.next())) / 2;
        });
        subdivide(quad_split(), r, kept_vertices(), centers);
    }
};

} // namespace kith
#define KITH_SCHEME kobbelt
#include <kith/schemes/compiled/in_library.hpp>
