// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/schemes/kernel/limit_rules.hpp>

#include <kith/core/mask/ring_waves.hpp>
#include <kith/doo_sabin.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace kith {

/// The limit rules of Doo-Sabin. The centre of every face is on the limit surface, unless a boundary rule moves its
/// corners. Doo & Sabin 1978. A vertex becomes a face, so its limit is the centre of that face. On the boundary it
/// becomes two points of the quadratic B-spline, whose midpoint is on the curve; corners stay. Without a boundary rule
/// the limit of a boundary vertex is that of its middle face, or of the face that its middle edge becomes.
template <>
struct limit_rules<doo_sabin> : limit_defaults {
    template <level Level, class Use>
    static void position(const doo_sabin& s, const face<Level>& f, const Use& use)
    {
        if (not has_boundary_rule(s, f))
            use(average(f.vertices()));
    }
    template <level Level, class Use>
    static void tangents(const doo_sabin& s, const face<Level>& f, const Use& use)
    {
        if (not has_boundary_rule(s, f))
            use_first_wave(f.vertices(), std::int64_t(f.degree()), use);
    }
    template <level Level, class Use>
    static void position(const doo_sabin& s, const vertex<Level>& v, const Use& use)
    {
        if (not v.is_boundary())
            with_points(s, v, [&](const auto& points) { use(average(points)); });
        else if (s.boundary == doo_sabin_boundary::drop)
            position_without_rule(s, v, use);
        else if (v.face_count() == 1)
            use(sum(v));
        else if (s.boundary == doo_sabin_boundary::thesis)
            use((v.first_rim() + 6. * v + v.last_rim()) / 8);
        else
            position_on_clamped_curve(v, use);
    }
    template <level Level, class Use>
    static void tangents(const doo_sabin& s, const vertex<Level>& v, const Use& use)
    {
        if (not v.is_boundary())
            with_points(s, v, [&](const auto& points) { use_first_wave(points, std::int64_t(v.face_count()), use); });
    }
    static constexpr bool are_alike_where_regular = true;
    /// Returns 1: the masks read the faces across the sides of the vertex's own faces.
    static constexpr int rings(const doo_sabin&) { return 1; }

private:
    template <level Level>
    static bool has_boundary_rule(const doo_sabin& s, const face<Level>& f)
    {
        return s.boundary != doo_sabin_boundary::drop and f.is_boundary();
    }
    /// Returns the weights in a face of this degree, computed once for each degree that occurs; null for long rows.
    template <doo_sabin_weights Weights>
    static const double* kept_weights(std::size_t degree)
    {
        static const rows_by_valence<double> rows([](std::size_t n) {
            std::vector<double> row;
            for (std::size_t j = 0; j < n; ++j)
                row.push_back(doo_sabin{.weights = Weights}.weight(j, n));
            return row;
        });
        return degree <= longest_row ? rows(degree) : nullptr;
    }
    /// Returns the point that a step makes of a corner, if no boundary rule applies to it.
    template <corner_element Corner>
    static auto point_of(const doo_sabin& s, const Corner& c)
    {
        using enum doo_sabin_weights;
        const std::size_t degree = c.f().degree();
        const double* const row = s.weights == cosine ? kept_weights<cosine>(degree) : kept_weights<averaging>(degree);
        return sum(c.vertices_from_here(),
                   [&s, row, degree](std::size_t j) { return row != nullptr ? row[j] : s.weight(j, degree); });
    }
    template <level Level, class Use>
    static void position_without_rule(const doo_sabin& s, const vertex<Level>& v, const Use& use)
    {
        auto c = v.first_corner(); // in the middle face, or in the face before the middle edge
        for (std::size_t i = 1; i < (v.face_count() + 1) / 2; ++i)
            c = c.prev().across();
        if (v.face_count() % 2 != 0)
            use(average(c.f().vertices()));
        else
            use((point_of(s, c.prev()) + point_of(s, c) +
                 (point_of(s, c.prev().across()) + point_of(s, c.prev().across().next()))) /
                4);
    }
    template <level Level, class Use>
    static void position_on_clamped_curve(const vertex<Level>& v, const Use& use)
    {
        const auto a = v.first_corner(), z = v.last_corner();
        const auto share = [](const auto& c, bool is_beside_end) { // of the neighbour along the boundary
            return c.f().degree() == 4 and is_beside_end ? 1. / 2 : 1. / 4;
        };
        const double of_first = share(a, a.next().is_boundary()) / 2;
        const double of_last = share(z, z.next().next().is_boundary()) / 2;
        use((1 - of_first - of_last) * v + of_first * v.first_rim() + of_last * v.last_rim());
    }
    /// Calls use(points) with the points that the next step makes around an inner vertex. Calls nothing if a boundary
    /// rule applies to one of them, or if one has a long mask. For all vertices of a large face long masks would take
    /// the square of its degree.
    template <level Level, class Use>
    static void with_points(const doo_sabin& s, const vertex<Level>& v, const Use& use)
    {
        for (const auto f : v.faces())
            if ((s.boundary == doo_sabin_boundary::clamped and has_boundary_rule(s, f)) or f.degree() > longest_row)
                return;
        use(v.corners().map([&s](const auto& c) { return point_of(s, c); }));
    }
};

} // namespace kith
