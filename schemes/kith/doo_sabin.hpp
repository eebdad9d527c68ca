// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/base/cos_turn.hpp>
#include <kith/mask/large_rings.hpp>
#include <kith/split/dual_split.hpp>
#include <kith/split/require_faces.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace kith {

enum class doo_sabin_boundary : unsigned char {
    thesis,  ///< 3/4, 1/4 along the boundary (thesis 2.1.2); corners stay
    clamped, ///< tensor product of the clamped quadratic B-spline; the thesis's rule in boundary faces that are no quads
    drop     ///< no rule: the surface recedes, as in CGAL
};

enum class doo_sabin_weights : unsigned char {
    cosine,   ///< Doo & Sabin 1978
    averaging ///< Catmull & Clark 1978, their biquadratic variant; differs on faces that are not quads
};

/// Doo-Sabin: uniform biquadratic B-splines for polygon meshes of any kind. Doo & Sabin 1978. C1.
/// After one step every inner vertex has valence 4. Cost: O(corners).
struct doo_sabin {
    doo_sabin_boundary boundary = doo_sabin_boundary::thesis;
    doo_sabin_weights weights = doo_sabin_weights::cosine;

    /// Reach: a point needs its face only; its boundary rule asks what lies across two of the face's edges, or all of them.
    static constexpr auto traits()
    {
        return scheme_traits{.name = "doo-sabin",
                             .trusted = true,
                             .require = [](const auto& level, int) { require_three_faces<doo_sabin>(level); },
                             .reach =
                                 [](const doo_sabin& s, int rings) {
                                     switch (s.boundary) {
                                     case doo_sabin_boundary::drop: return rings / 2 + 1;
                                     case doo_sabin_boundary::clamped: return rings / 2 + 2;
                                     default: return (rings + 1) / 2 + 1;
                                     }
                                 }};
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

    template <class R>
    void operator()(const R& r) const
    {
        using namespace targets;
        using real = scalar_type<R>;
        const auto& [coarse, assoc, generation] = r;
        const auto masks = masks_by_degree<real>(coarse);
        const large_faces large(coarse, [&assoc = assoc](const auto& f, std::size_t n) {
            return ring_waves<std::remove_cvref_t<decltype(assoc)>, 1>(assoc, f.vertices(), n);
        });

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
                assoc(c, V) = sum(c.vertices_from_here(), clamped_mask<real>(c).data());
            else if (n <= longest_row)
                assoc(c, V) = sum(c.vertices_from_here(), masks[n].data());
            else
                make_in_large_face(assoc(c, V), c, large.of(c.f()));
        });

        split().connect(r);
    }

private:
    /// The same weights by what they have in common.
    template <class Association, class Corner, class Sums>
    void make_in_large_face(const Association& target, const Corner& c, const Sums& sums) const
    {
        const auto face = [&](const wave_kernel& kernel) { return sums.mask(kernel, 2 * step_in_face(c)); };
        if (weights == doo_sabin_weights::cosine)
            target = 1. / 4 * c.v() + face({3. / 4, 1. / 4, 0});
        else
            target = 1. / 2 * c.v() + 1. / 8 * (c.prev().v() + c.next().v()) + face({1. / 4, 0, 0});
    }

    /// For each degree that occurs, but for large ones, the weights of a face's corners, counted from the one that the point
    /// belongs to.
    template <class Real, class Level>
    auto masks_by_degree(const Level& coarse) const
    {
        std::vector<std::vector<Real>> masks;
        for (const auto f : coarse.faces()) {
            const std::size_t n = f.degree();
            if (n > longest_row or (n < masks.size() and not masks[n].empty()))
                continue;
            if (n >= masks.size())
                masks.resize(n + 1);
            Real others(0);
            masks[n].push_back(others);
            for (std::size_t j = 1; j < n; ++j) {
                masks[n].push_back(Real(weight(j, n)));
                others = others + masks[n].back();
            }
            masks[n][0] = 1 - others; // so that they sum to one exactly
        }
        return masks;
    }

    /// docs/schemes.md, Doo-Sabin, clamped: in each direction all of the weight for a point on the boundary, half of it
    /// beside a boundary, else 3/4.
    template <class Real, class Corner>
    static std::array<Real, 4> clamped_mask(const Corner& c)
    {
        const auto d = c.next().next();
        const auto towards = [](bool on, bool beside) { return on ? Real(1) : beside ? Real(1) / 2 : Real(3) / 4; };
        const Real a = towards(c.prev().is_boundary(), c.next().is_boundary());
        const Real b = towards(c.is_boundary(), d.is_boundary());
        return {a * b, (1 - a) * b, (1 - a) * (1 - b), a * (1 - b)};
    }
};

} // namespace kith
