// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/schemes/kernel/face_masks.hpp>
#include <kith/schemes/split/dual_split.hpp>
#include <kith/schemes/split/require_faces.hpp>

#include <cstddef>

namespace kith {

/// The rule for the corners of faces at the boundary.
enum class doo_sabin_boundary : unsigned char {
    thesis,  ///< 3/4, 1/4 along the boundary (thesis 2.1.2); corners stay
    clamped, ///< tensor product of the clamped quadratic B-spline; `thesis` in faces that are not quads
    drop     ///< no rule: the surface recedes, as in CGAL
};

/// The weights of the corners of a face in the new point of one of these corners.
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

    /// Returns the traits. Reach: a point reads its own face only; its boundary rule also asks whether two of the
    /// face's edges, or all of them, are boundary edges.
    static constexpr auto traits()
    {
        return scheme_traits{.name = "doo-sabin",
                             .trusted = true,
                             .valence = 4,
                             .require = three_faces_at_vertices,
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

    /// Returns the weights of the corners of a face. Cosine weights are (3 + 2 cos t)/4n by the angle, and 1/4 more for
    /// the corner itself. Averaging weights are 1/4n, and 1/2 more for the corner itself and 1/8 more for the two next
    /// to it.
    [[nodiscard]] constexpr face_kernel kernel() const
    {
        return weights == doo_sabin_weights::cosine ? face_kernel{{3. / 4, 1. / 4, 0}, 1. / 4, 0}
                                                    : face_kernel{{1. / 4, 0, 0}, 1. / 2, 1. / 8};
    }
    /// Returns the weight of the j-th corner of a face of degree n, counted from the corner that the point belongs to.
    [[nodiscard]] constexpr double weight(std::size_t j, std::size_t n) const
    {
        if (j == 0 and weights == doo_sabin_weights::cosine)
            return (double(n) + 5) / (4 * double(n)); // as in the paper: the value of the kernel, rounded only once
        return kernel().at(j, n);
    }

    template <step_context R>
    void operator()(const R& r) const
    {
        using namespace targets;
        using real = scalar_type<R>;
        const auto& [coarse, assoc, generation] = r;
        const face_masks masks(r, kernel());
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
                masks.of_corner(c, n, [&](const auto& mask) { assoc(c, V) = mask; });
        });

        split().connect(r);
    }
};

} // namespace kith
#define KITH_SCHEME doo_sabin
#include <kith/schemes/compiled/in_library.hpp>
