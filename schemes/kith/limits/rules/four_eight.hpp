// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/schemes/kernel/limit_rules.hpp>

#include <kith/core/base/exact_cos.hpp>
#include <kith/four_eight.hpp>

#include <cstddef>
#include <cstdint>
#include <ranges>
#include <vector>

namespace kith {

/// The limit rules of 4-8: positions and tangents over two rings of pairs of triangles.
template <>
struct limit_rules<four_eight> : limit_defaults {
    /// Calls use(mask) with the mask of the position. The pairs of triangles are seen as quads, which both kinds of
    /// steps treat alike. The mask covers two rings of them, if v's first ring is regular and inside; docs/schemes.md.
    /// On the boundary it is the mask of the cubic B-spline curve.
    template <level Level, class Use>
    static void position(const four_eight&, const vertex<Level>& v, const Use& use)
    {
        if (v.is_boundary()) {
            if (bisection_split::is_marked(v.first_corner().next_edge()) ==
                bisection_split::is_marked(v.last_corner().prev_edge()))
                use((v.first_rim() + 4. * v + v.last_rim()) / 6);
            else
                use(sum(v)); // its two boundary edges are never bisected in the same step
        } else {
            with_two_rings(v, [&](const auto& e, const auto& d, const auto& h, const auto& p, const auto& q) {
                use((70. * v + 118. * average(e) + 44. * average(d) + 6. * average(h) + (average(p) + average(q))) /
                    240);
            });
        }
    }
    /// Calls use(first, second) with the tangents at an inner vertex, counter-clockwise, over the same two rings;
    /// docs/schemes.md.
    template <level Level, class Use>
    static void tangents(const four_eight&, const vertex<Level>& v, const Use& use)
    {
        const auto n = std::int64_t(pair_count(v));
        if (v.is_boundary() or n < 3)
            return;
        with_two_rings(v, [&](const auto& e, const auto& d, const auto& h, const auto& p, const auto& q) {
            static const weights_by_valence<double> moduli([](std::size_t m) { return subdominant(std::int64_t(m)); });
            const double c = cosine_wave(2 * n)(1), rho = moduli(std::size_t(n)), k = 1 / (2 * (16 * rho * rho - 1));
            const double of_d = 8 * rho - 4 * k * (4 * rho + c);
            const double of_e = 4 * (of_d * (rho - c / 4) - 1. / 2 - k / 2 * (4 * rho * c + 1));
            const auto cosine = cosine_wave(4 * n);
            const auto sine = sine_wave(4 * n);
            const auto wave = [=](double weight, double turned, std::size_t start, std::size_t quarters) {
                return [=](std::size_t j) { // weight cos t - turned sin t, with t less `quarters` quarter turns
                    const std::size_t at = 2 * (2 * j + start), back = quarters * std::size_t(n);
                    const std::size_t turn = at >= back ? at - back : at + 4 * std::size_t(n) - back;
                    return weight * cosine(turn) - turned * sine(turn);
                };
            };
            const auto tangent = [&](std::size_t quarters) {
                const double of_p = k * (4 * rho + c), turned = -k * sine_wave(2 * n)(1);
                return sum(e, wave(of_e, 0, 0, quarters)) + sum(d, wave(of_d, 0, 1, quarters)) +
                       sum(h, wave(1, 0, 0, quarters)) +
                       (sum(p, wave(of_p, turned, 1, quarters)) + sum(q, wave(of_p, -turned, 1, quarters)));
            };
            use(tangent(0), tangent(1));
        });
    }

    /// Returns 3: the rings of triangles that two rings of pairs reach.
    static constexpr int rings(const four_eight&) { return 3; }

    /// Returns the modulus of the subdominant eigenvalues of one step at a vertex with n quads. It is a quarter of the
    /// largest root of a polynomial, docs/schemes.md, with c = cos(pi/n):
    /// x^5 - 3c x^4 + (2c^2 - 5) x^3 + 6c x^2 + 4x + c - 2c^3.
    static constexpr double subdominant(std::int64_t n)
    {
        const double c = exact_cos(1, 2 * n);
        double x = 4; // above the root, so that Newton's steps decrease to it
        for (int i = 0; i < 50; ++i) {
            const double value = ((((x - 3 * c) * x + 2 * c * c - 5) * x + 6 * c) * x + 4) * x + c - 2 * c * c * c;
            const double slope = (((5 * x - 12 * c) * x + 3 * (2 * c * c - 5)) * x + 12 * c) * x + 4;
            x -= value / slope;
        }
        return x / 4;
    }

private:
    template <vertex_element Vertex>
    static std::size_t pair_count(const Vertex& v)
    {
        std::size_t result = 0;
        for ([[maybe_unused]] const auto& c : four_eight::sides(v))
            ++result;
        return result;
    }
    /// Returns true if the edge after a corner is inside and the edge after the next corner is not both marked and at
    /// the boundary.
    template <corner_element Corner>
    static bool is_inside(const Corner& c)
    {
        return not c.is_boundary() and not(c.next().is_boundary() and bisection_split::is_marked(c.next().next_edge()));
    }

    /// Calls use(e, d, h, p, q) with the vertices around v. Pair j lies between the neighbours e_j and e_j+1; d_j is
    /// opposite v in it, and h_j lies behind e_j. p_j and q_j lie beside d_j in the second ring, p_j nearer to e_j.
    /// Calls nothing unless all e and d lie inside and have four pairs.
    template <vertex_element Vertex, class Use>
    static void with_two_rings(const Vertex& v, const Use& use)
    {
        const auto next = [](const auto& c) { return bisection_split::next_in_pair(c); };
        const auto end = [](const auto& c) { return c.next().v(); };
        const auto is_regular = [](const Vertex& u) {
            std::size_t corners = 0, pairs = 0;
            for (const auto c : u.corners()) {
                if (++corners > 8 or not is_inside(c)) // so that a large fan is not walked for each of its neighbours
                    return false;
                pairs += not bisection_split::is_first(c);
            }
            return pairs == 4;
        };
        for (const auto c : v.corners())
            if (not is_inside(c))
                return;
        for (const auto c : four_eight::sides(v))
            if (not is_regular(end(c)) or not is_regular(end(next(c))))
                return;
        const auto behind = [=](const auto& c) { return next(next(c).across()); };       // from e_j to h_j
        const auto beside = [=](const auto& c) { return next(next(next(c)).across()); }; // from d_j to q_j
        struct pair {
            Vertex e, d, h, p, q;
        };
        std::vector<pair> pairs; // stored, since tangents read each pair several times
        pairs.reserve(v.valence());
        for (const auto c : four_eight::sides(v)) {
            const auto h = behind(c);
            pairs.push_back({end(c), end(next(c)), end(h), end(next(h)), end(beside(c))});
        }
        const auto all = [&](Vertex pair::* which) { return std::views::transform(pairs, which); };
        use(all(&pair::e), all(&pair::d), all(&pair::h), all(&pair::p), all(&pair::q));
    }
};

} // namespace kith
