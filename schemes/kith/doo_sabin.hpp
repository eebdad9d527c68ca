// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/base/cos_turn.hpp>
#include <kith/kernel/face_masks.hpp>
#include <kith/split/dual_split.hpp>
#include <kith/split/require_faces.hpp>

#include <cstddef>
#include <cstdint>

namespace kith {

/// What becomes of the corners of faces at the boundary.
enum class doo_sabin_boundary : unsigned char {
    thesis,  ///< 3/4, 1/4 along the boundary (thesis 2.1.2); corners stay
    clamped, ///< tensor product of the clamped quadratic B-spline; the thesis's in faces that are no quads
    drop     ///< no rule: the surface recedes, as in CGAL
};

/// The weights of the corners of a face in the point of one of them.
enum class doo_sabin_weights : unsigned char {
    cosine,   ///< Doo & Sabin 1978
    averaging ///< Catmull & Clark 1978, their biquadratic variant; differs on faces that are not quads
};

/// Doo-Sabin: uniform biquadratic B-splines for polygon meshes of any kind. Doo & Sabin 1978. C1.
/// After one step every inner vertex has valence 4. Cost: O(corners).
struct doo_sabin {
    doo_sabin_boundary boundary = doo_sabin_boundary::thesis;
    doo_sabin_weights weights = doo_sabin_weights::cosine;

    friend bool operator==(const doo_sabin&, const doo_sabin&) = default;

    /// Reach: a point needs its face only; its boundary rule asks what lies across two of the face's edges, or all of
    /// them.
    static constexpr auto traits()
    {
        return scheme_traits{.name = "doo-sabin",
                             .trusted = true,
                             .valence = 4,
                             .require = [](const auto& level, int) { require_three_faces<doo_sabin>(level); },
                             .reach =
                                 [](const doo_sabin& s, int rings) {
                                     switch (s.boundary) {
                                     case doo_sabin_boundary::drop: return rings / 2 + 1;
                                     case doo_sabin_boundary::clamped: return rings / 2 + 2;
                                     default: return (rings + 1) / 2 + 1;
                                     }
                                 },
                             .ignores_numbers = [] { return true; }};
    }
    [[nodiscard]] constexpr dual_split split() const { return {.cap_boundary = boundary != doo_sabin_boundary::drop}; }
    [[nodiscard]] constexpr auto columns() const { return split().columns(); }

    /// The weight of the j-th corner of a face of degree n, counted from the corner that the point belongs to.
    [[nodiscard]] constexpr double weight(std::size_t j, std::size_t n) const
    {
        const double l = double(n);
        if (weights == doo_sabin_weights::averaging)
            return j == 0 ? 1. / 2 + 1 / (4 * l) : j == 1 or j == n - 1 ? 1. / 8 + 1 / (4 * l) : 1 / (4 * l);
        return j == 0 ? (l + 5) / (4 * l) : (3 + 2 * cos_turn(std::int64_t(j), std::int64_t(n))) / (4 * l);
    }

    template <running_step R>
    void operator()(const R& r) const
    {
        using namespace targets;
        using real = scalar_type<R>;
        const auto& [coarse, assoc, generation] = r;
        const face_masks masks(r, [this](std::size_t j, std::size_t n) { return weight(j, n); });
        const bool open = not coarse.is_closed();
        for_each(coarse.corners(), [&](auto c) {
            const auto v = c.v();
            const std::size_t n = c.f().degree();
            const bool is_clamped = boundary == doo_sabin_boundary::clamped and n == 4;
            const bool keeps_curve = open and not is_clamped and boundary != doo_sabin_boundary::drop;
            const bool after = keeps_curve and c.is_boundary(); // the edge to the next corner
            const bool before = keeps_curve and c.prev().is_boundary();
            if (after != before)
                assoc(c, V) = 3. / 4 * v + 1. / 4 * (after ? c.next().v() : c.prev().v());
            else if (after and before)
                assoc(c, V) = v;
            else if (open and is_clamped and c.f().is_boundary())
                assoc(c, V) = sum(c.vertices_from_here(), clamped_quad_weights<real>(c).data());
            else
                masks.of_corner(
                    c,
                    n,
                    [&](const auto& sum_by, const auto& use) { in_large_face(c, sum_by, use); },
                    [&](const auto& mask) { assoc(c, V) = mask; });
        });

        split().connect(r);
    }

private:
    /// Calls use(mask) with the same weights by what they have in common.
    template <corner_element Corner, class SumBy, class Use>
    void in_large_face(const Corner& c, const SumBy& sum_by, const Use& use) const
    {
        if (weights == doo_sabin_weights::cosine)
            use(1. / 4 * c.v() + sum_by({3. / 4, 1. / 4, 0}));
        else
            use(1. / 2 * c.v() + 1. / 8 * (c.prev().v() + c.next().v()) + sum_by({1. / 4, 0, 0}));
    }
};

} // namespace kith
#include <kith/compiled/doo_sabin.hpp>
