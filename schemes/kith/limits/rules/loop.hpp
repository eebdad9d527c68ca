// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/schemes/crease/crease_limits.hpp>

#include <kith/loop.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace kith {

/// The limit rules of Loop: the left eigenvectors of the subdivision matrix of the vertex.
template <>
struct limit_rules<loop> : crease_limits {
    template <level Level, class Use>
    static void position(const creased_scheme<loop, Level>& s, const vertex<Level>& v, const Use& use)
    {
        if (not s.sharp.is_smooth(v)) {
            position_on_curve(s, v, use);
            return position_of_dart<limit_rules>(s, v, use);
        }
        const double n = double(v.valence());
        const double g = 1 / (n + 3 / (8 * s.scheme.beta(v.valence())));
        use((1 - n * g) * v + g * sum(v.neighbors()));
    }
    /// Calls use(first, second) with the tangent masks. Hoppe et al. 1994; at boundary vertices that do not have three
    /// faces the left eigenvector of the plain rule, docs/schemes.md.
    template <level Level, class Use>
    static void tangents(const creased_scheme<loop, Level>& s, const vertex<Level>& v, const Use& use)
    {
        if (s.sharp.is_smooth(v))
            use_first_wave(v.neighbors(), std::int64_t(v.face_count()), use);
        else
            tangents_beside_creases<limit_rules>(s, v, use);
    }
    /// Calls use with the tangent masks of each side of a crease, docs/schemes.md.
    template <level Level, class Use>
    static void sides(const creased_scheme<loop, Level>& s, const vertex<Level>& v, const Use& use)
    {
        sides_beside_creases<limit_rules>(s, v, use);
    }

    // The members that crease_limits requires.
    static constexpr bool has_opposites = false;
    static constexpr std::size_t most_faces_of_planes = 2;
    template <corner_element Corner, class Use>
    static void use_ring(const Corner& first, std::int64_t n, const Use& use)
    {
        use_first_wave(first.neighbors_from_here(), n, use);
    }
    template <level Level>
    static mask_row<Level> across(const vertex_sector<Level>& part, double r)
    {
        const auto turns = std::int64_t(2 * part.faces);
        const auto sine = sine_wave(turns);
        const double cotangent = cosine_wave(2 * turns)(1) / sine_wave(2 * turns)(1), c = cosine_wave(turns)(1);
        // The row's image is lambda times the row, with lambda = 3/8 + c/4, in its entry at the first end of the
        // sector.
        const double x = (sine(1) / 8 - r * cotangent) / (2 * r - 1. / 8 + c / 4);
        return row_of(part, -(2 * x + cotangent), x);
    }
    template <level Level>
    static mask_row<Level> between(const vertex_sector<Level>& part)
    {
        const auto turns = std::int64_t(2 * part.faces);
        return row_of(part, -cosine_wave(2 * turns)(1) / sine_wave(2 * turns)(1), 0);
    }
    template <level Level>
    static mask_row<Level> across_one(const vertex_sector<Level>& part, double)
    {
        return {{part.first.v(), -2.}, {part.first_end(), 1.}, {part.last_end(), 1.}};
    }
    static const double* darts(const loop& s, std::size_t n)
    {
        using enum loop_weights;
        return n > longest_row ? nullptr : s.weights == loop ? kept_darts<loop>(n) : kept_darts<warren>(n);
    }

private:
    /// Returns a row with the sines of the edges. The sines of the two end edges are zero; these edges have the weight
    /// x.
    template <level Level>
    static mask_row<Level> row_of(const vertex_sector<Level>& part, double of_vertex, double x)
    {
        const auto sine = sine_wave(std::int64_t(2 * part.faces));
        const auto of_edge = [&](std::size_t j) { return j == 0 or j == part.faces ? x : sine(j); };
        return row_over<has_opposites>(part, of_vertex, of_edge, [](std::size_t) { return 0.; });
    }
    template <loop_weights Weights>
    static const double* kept_darts(std::size_t valence)
    {
        static const rows_by_valence<double> rows([](std::size_t n) {
            const double beta = kith::loop{.weights = Weights}.beta(n);
            std::vector<dart_matrix::row> matrix(1 + n);
            matrix[0].emplace_back(0, 1 - double(n) * beta);
            for (std::size_t j = 0; j < n; ++j) {
                matrix[0].emplace_back(1 + j, beta);
                if (j == 0)
                    matrix[1] = {{0, 1. / 2}, {1, 1. / 2}};
                else
                    matrix[1 + j] = {{0, 3. / 8}, {1 + j, 3. / 8}, {j, 1. / 8}, {1 + (j + 1) % n, 1. / 8}};
            }
            return dart_matrix(n, std::move(matrix)).weights();
        });
        return rows(valence);
    }
};

} // namespace kith
