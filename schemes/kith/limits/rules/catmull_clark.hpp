// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/schemes/crease/crease_limits.hpp>

#include <kith/catmull_clark.hpp>
#include <kith/schemes/split/require_faces.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace kith {

/// The limit rules of Catmull-Clark. Halstead, Kass & DeRose 1993, if all faces at a vertex are quads.
template <>
struct limit_rules<catmull_clark> : crease_limits {
    template <level Level, class Use>
    static void position(const creased_scheme<catmull_clark, Level>& s, const vertex<Level>& v, const Use& use)
    {
        if (not s.sharp.is_smooth(v))
            position_on_curve(s, v, use);
        if (not has_quads_only(v))
            return;
        if (not s.sharp.is_smooth(v))
            return position_of_dart<limit_rules>(s, v, use);
        const double n = double(v.valence());
        use((n * n * v + 4. * sum(v.neighbors()) + sum(v.opposites())) / (n * (n + 5)));
    }
    /// Calls use(first, second) with the tangent masks. Inside they are those of Halstead et al., along a boundary the
    /// left eigenvectors of the plain rule, docs/schemes.md.
    template <level Level, class Use>
    static void tangents(const creased_scheme<catmull_clark, Level>& s, const vertex<Level>& v, const Use& use)
    {
        if (not has_quads_only(v))
            return;
        if (s.sharp.is_smooth(v))
            use_waves(v.neighbors(), v.opposites(), std::int64_t(v.face_count()), use);
        else
            tangents_beside_creases<limit_rules>(s, v, use);
    }
    /// Calls use with the tangent masks of each side of a crease, docs/schemes.md.
    template <level Level, class Use>
    static void sides(const creased_scheme<catmull_clark, Level>& s, const vertex<Level>& v, const Use& use)
    {
        if (has_quads_only(v))
            sides_beside_creases<limit_rules>(s, v, use);
    }
    /// Returns true if crease_limits does and all faces at v are quads, since only then the sides are known.
    template <level Level>
    static bool never_has_tangents(const creased_scheme<catmull_clark, Level>& s, const vertex<Level>& v)
    {
        return crease_limits::never_has_tangents(s, v) and has_quads_only(v);
    }

    // The members that crease_limits requires.
    static constexpr bool has_opposites = true;
    static constexpr std::size_t most_faces_of_planes = 1;
    template <corner_element Corner, class Use>
    static void use_ring(const Corner& first, std::int64_t n, const Use& use)
    {
        use_waves(first.neighbors_from_here(), first.opposites_from_here(), n, use);
    }
    template <level Level>
    static mask_row<Level> across(const vertex_sector<Level>& part, double r)
    {
        const auto [sine, cotangent, lambda, mu] = waves_of(part);
        // The row's image is lambda times the row, in its entry at the first end of the sector.
        const double x = (sine * (1 + mu) / 4 - r * (4 + 2 * mu) * cotangent) / (lambda - 1. / 2 + 2 * r);
        return row_of(part, -(2 * x + (4 + 2 * mu) * cotangent), x);
    }
    template <level Level>
    static mask_row<Level> between(const vertex_sector<Level>& part)
    {
        const auto [sine, cotangent, lambda, mu] = waves_of(part);
        return row_of(part, -(4 + 2 * mu) * cotangent, 0);
    }
    /// Returns, across the curve of thirds, the left eigenvector of the eigenvalue 1/4; otherwise a direction, which is
    /// read only if the edges do not bend.
    template <level Level>
    static mask_row<Level> across_one(const vertex_sector<Level>& part, double r)
    {
        const auto v = part.first.v(), opposite = part.first.next().next().v();
        if (r == 1. / 6)
            return {{v, -3.}, {part.first_end(), 1.}, {opposite, 1.}, {part.last_end(), 1.}};
        return {{v, -1.}, {opposite, 1.}};
    }
    static const double* darts(const catmull_clark&, std::size_t valence)
    {
        static const rows_by_valence<double> rows([](std::size_t n) {
            const auto edge = [n](std::size_t j) { return 1 + j % n; };
            const auto opposite = [n](std::size_t j) { return 1 + n + j % n; };
            const double m = double(n);
            std::vector<dart_matrix::row> matrix(1 + 2 * n);
            matrix[0].emplace_back(0, (m - 2) / m + 1 / (4 * m));
            for (std::size_t j = 0; j < n; ++j) {
                matrix[0].emplace_back(edge(j), 1.5 / (m * m));
                matrix[0].emplace_back(opposite(j), 1 / (4 * m * m));
                if (j == 0)
                    matrix[1] = {{0, 1. / 2}, {1, 1. / 2}};
                else
                    matrix[edge(j)] = {{0, 3. / 8},
                                       {edge(j), 3. / 8},
                                       {edge(j + n - 1), 1. / 16},
                                       {edge(j + 1), 1. / 16},
                                       {opposite(j + n - 1), 1. / 16},
                                       {opposite(j), 1. / 16}};
                matrix[opposite(j)] = {{0, 1. / 4}, {edge(j), 1. / 4}, {edge(j + 1), 1. / 4}, {opposite(j), 1. / 4}};
            }
            return dart_matrix(n, std::move(matrix)).weights();
        });
        return valence > longest_row ? nullptr : rows(valence);
    }

private:
    /// Returns the subdominant eigenvalue of a ring whose faces each span one of n parts of a turn. The arguments are
    /// the cosines of such a part and of its half.
    static double subdominant(double c, double half) { return 5. / 16 + (c + half * std::sqrt(2 * (9 + c))) / 16; }
    template <mask_range Edges, mask_range Opposites, class Use>
    static void use_waves(const Edges& edges, const Opposites& opposites, std::int64_t n, const Use& use)
    {
        const auto cosine = cosine_wave(n);
        const auto sine = sine_wave(n);
        const double mu = 1 / (4 * subdominant(cosine(1), cosine_wave(2 * n)(1)) - 1);
        const auto along_edges = [](auto f) { return [f](std::size_t j) { return 4 * f(j); }; };
        const auto along_faces = [mu](auto f) { return [f, mu](std::size_t j) { return mu * (f(j) + f(j + 1)); }; };
        use(sum(edges, along_edges(cosine)) + sum(opposites, along_faces(cosine)),
            sum(edges, along_edges(sine)) + sum(opposites, along_faces(sine)));
    }
    struct half_turn {
        double sine, cotangent, lambda, mu; ///< of the angle of a face, and of half of it
    };
    /// Returns the waves of a sector that spans half a turn.
    template <level Level>
    static half_turn waves_of(const vertex_sector<Level>& part)
    {
        const auto turns = std::int64_t(2 * part.faces);
        const double half = cosine_wave(2 * turns)(1), lambda = subdominant(cosine_wave(turns)(1), half);
        return {sine_wave(turns)(1), half / sine_wave(2 * turns)(1), lambda, 1 / (4 * lambda - 1)};
    }
    /// Returns a row with the sines of the edges. The sines of the two end edges are zero; these edges have the weight
    /// x.
    template <level Level>
    static mask_row<Level> row_of(const vertex_sector<Level>& part, double of_vertex, double x)
    {
        const auto sine = sine_wave(std::int64_t(2 * part.faces));
        const double mu = waves_of(part).mu;
        return row_over<has_opposites>(
            part,
            of_vertex,
            [&](std::size_t j) { return j == 0 or j == part.faces ? x : 4 * sine(j); },
            [&](std::size_t j) { return mu * (sine(j) + sine(j + 1)); });
    }
};

} // namespace kith
