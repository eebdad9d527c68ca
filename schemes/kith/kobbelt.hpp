// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/mask/large_rings.hpp>
#include <kith/mask/weight_rows.hpp>
#include <kith/split/quad_split.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith {

/// Kobbelt's interpolating scheme for quads: the four-point scheme in both directions. Kobbelt 1996. C1.
/// Every new point is the four-point rule along a line of the mesh; where no line goes on beyond a vertex, a virtual point
/// does. `gamma` weighs the vertices opposite an extraordinary vertex in its virtual points: the default makes the two
/// directions of a face agree (docs/schemes.md). Boundary: four-point curve, corners kept. Cost: O(corners), those of large
/// fans times their logarithm.
struct kobbelt {
    double tension = 1; ///< w, 0 < w < 2 (sqrt 5 - 1)
    double gamma = tension / (8 + tension);

    static constexpr auto traits()
    {
        return scheme_traits{.name = "kobbelt",
                             .faces = face_shape::quads,
                             .trusted = true,
                             .reach = [](int rings) { return (rings + 1) / 2 + 2; },
                             .ignores_numbers = [] { return true; }};
    }
    static constexpr auto columns() { return quad_split::columns(); }

    template <class R>
    void operator()(const R& r) const
    {
        using namespace targets;
        using real = scalar_type<R>;
        const auto& [coarse, assoc, generation] = r;
        const auto outer = real(-tension / 16);
        const auto inner = real((8 + tension) / 16);
        const ring_rows<real> rows{weight_rows<real>(neighbor_weights),
                                   weight_rows<real>([this](std::size_t n) { return opposite_weights(n); })};

        std::vector<fan_kind> kinds(coarse.vertex_count());
        for_each(coarse.vertices(), [&](auto v) {
            const std::size_t n = v.is_boundary() ? 0 : v.valence();
            kinds[v.index()] = n == 4 ? fan_kind::regular : irregular_fan(n);
            assoc(v, V) = v;
        });
        const auto is_regular = [&](const auto& v) { return kinds[v.index()] == fan_kind::regular; };
        const large_fans large(coarse, kinds, [&assoc = assoc](const auto& v, std::size_t n) {
            using total = ring_waves<std::remove_cvref_t<decltype(assoc)>, 0>;
            return std::pair(total(assoc, v.neighbors(), n), total(assoc, v.opposites(), n));
        });

        for_each(coarse.edges(), [&](auto e) {
            const auto x = e.org();
            const auto y = e.dst();
            const auto mask = [&](const auto& l, const auto& r) { return inner * (x + y) + outer * (l + r); };
            if (is_regular(x) and is_regular(y))
                assoc(e, V) = mask(straight_on(e.lcorner()), straight_on(e.rcorner()));
            else
                with_irregular_ends<real>(
                    e, kinds, rows, large, [&](const auto& l, const auto& r) { assoc(e, V) = mask(l, r); });
        });

        for_each(coarse.faces(), [&](auto f) {
            const auto c = f.first_corner();
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
            assoc(f, V) = (across(c) + across(c.next())) / 2;
        });

        quad_split::connect(r);
    }

private:
    template <class Real>
    struct ring_rows {
        weight_rows<Real> neighbors, opposites;
    };

    /// The vertex that continues the edge of c beyond c's own vertex, which is inside and has valence 4.
    template <class Corner>
    static auto straight_on(const Corner& c)
    {
        return c.prev().across().prev().across().next().v();
    }
    /// Calls use(l, r) with the points that continue an edge beyond its ends. What is rare stays out of the loops.
    template <class Real, class Edge, class Large, class Use>
    [[gnu::noinline, gnu::flatten]] void with_irregular_ends(Edge e, const std::vector<fan_kind>& kinds,
                                                             const ring_rows<Real>& rows, const Large& large,
                                                             const Use& use) const
    {
        const auto x = e.org();
        const auto y = e.dst();
        if (e.is_boundary()) {
            const auto along = [](auto v, auto w, auto rim) { // corners end the curve: reflect
                return choose(v.face_count() == 1, [v, w] { return 2. * v - w; }, [rim] { return sum(rim); });
            };
            use(along(x, y, x.last_rim()), along(y, x, y.first_rim()));
            return;
        }
        std::vector<Real> spare[4];
        const auto beyond = [&](auto c, auto& spare_l, auto& spare_k) { // the vertex of c
            const auto v = c.v();
            const fan_kind kind = kinds[v.index()];
            const bool has_row = kind == fan_kind::irregular and not v.is_boundary();
            const std::size_t n = has_row ? v.valence() : 0;
            const Real* l = has_row ? rows.neighbors(n, spare_l) : nullptr;
            const Real* k = has_row ? rows.opposites(n, spare_k) : nullptr;
            return choose(
                v.is_boundary(),
                [c, v] { return 2. * v - c.next().v(); },
                [=, &large, this] {
                    return choose(
                        kind == fan_kind::large,
                        [=, &large, this] { return beyond_large_fan<Real>(c, large); },
                        [=] {
                            return choose(
                                kind == fan_kind::regular,
                                [c] { return sum(straight_on(c)); },
                                [=] { return sum(c.neighbors_from_here(), l) + sum(c.opposites_from_here(), k); });
                        });
                });
        };
        use(beyond(e.lcorner(), spare[0], spare[1]), beyond(e.rcorner(), spare[2], spare[3]));
    }

    /// 4/n sum l_j - (l_-1 + l_0 + l_1) + gamma (k_-2 + k_-1 + k_0 + k_1 - 4/n sum k_j), the sums being there.
    template <class Real, class Corner, class Large>
    auto beyond_large_fan(const Corner& c, const Large& large) const
    {
        const auto& [neighbors, opposites] = large.at(c).sums;
        const auto clockwise = [](const Corner& d) { return d.across().next(); };
        const auto l = [](const Corner& d) { return d.next().v(); };
        const auto k = [](const Corner& d) { return d.next().next().v(); };
        const Corner after = c.prev().across(), before = clockwise(c), twice_before = clockwise(before);
        return neighbors.mask({4, 0, 0}, 0) - (l(before) + l(c) + l(after)) +
               Real(gamma) * (k(twice_before) + k(before) + k(c) + k(after) + opposites.mask({-4, 0, 0}, 0));
    }

    /// Of the neighbours l_j of a vertex of valence n, l_0 being the other end of the edge: 4/n - [j = -1, 0, 1].
    static std::vector<double> neighbor_weights(std::size_t n)
    {
        std::vector<double> row(n, 4. / double(n));
        for (const std::size_t j : {n - 1, n, n + 1})
            row[j % n] -= 1;
        return row;
    }
    /// Of the vertices k_j opposite it in its faces, k_j between l_j and l_j+1: gamma ([j = -2, -1, 0, 1] - 4/n).
    [[nodiscard]] std::vector<double> opposite_weights(std::size_t n) const
    {
        std::vector<double> row(n, -4 * gamma / double(n));
        for (const std::size_t j : {2 * n - 2, 2 * n - 1, 2 * n, 2 * n + 1})
            row[j % n] += gamma;
        return row;
    }
};

} // namespace kith
