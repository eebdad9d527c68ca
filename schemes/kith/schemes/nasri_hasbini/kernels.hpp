// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/exact_cos.hpp>
#include <kith/core/mask/by_valence.hpp>
#include <kith/core/mask/ring_waves.hpp>

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace kith {

// The weights of Nasri-Hasbini's scheme, in units of 1/729; docs/schemes.md says how they are used.

/// The kinds of new points of a vertex that weights are for: (v), (v, e_0) or (v, f_0).
enum class ternary_point : unsigned char { vertex, edge, face };

/// Returns the weight of the vertex itself.
constexpr double center_weight(ternary_point point)
{
    return point == ternary_point::vertex ? 361 : point == ternary_point::edge ? 304 : 256;
}

namespace detail {

/// The weights (x0 + 2 x1 cos t + h x2 cos 2t) / n, with h = 1 for n = 4, else 2. The angle t is `half_steps` halves of
/// 1/n of a turn.
struct ring_kernel {
    double x0, x1, x2;

    [[nodiscard]] constexpr double at(std::int64_t half_steps, std::size_t n) const
    {
        return wave_kernel{x0, x1, n == 4 ? x2 / 2 : x2}.at(half_steps, n);
    }
    /// Returns the same weights for n >= 5.
    operator wave_kernel() const { return {x0, x1, x2}; }
};

inline constexpr double sqrt2 = 1.4142135623730950488;
inline constexpr double sqrt5 = 2.2360679774997896964;

/// Returns the kernel of the neighbours in (v,e), kernel_c that of the opposite vertices. kernel_q and kernel_g are the
/// same in (v,f).
constexpr ring_kernel kernel_b(std::size_t n)
{
    return n <= 3 ? ring_kernel{337, 199, 0} : n == 4 ? ring_kernel{337, 171, 81} : ring_kernel{337, 189, 72};
}
constexpr ring_kernel kernel_c(std::size_t n)
{
    return n <= 3 ? ring_kernel{88, 44, 0} : n == 4 ? ring_kernel{88, 36 * sqrt2, 0} : ring_kernel{88, 27 * sqrt2, 4.5};
}
constexpr ring_kernel kernel_q(std::size_t n)
{
    return n <= 3   ? ring_kernel{352, 172, 0}
           : n == 4 ? ring_kernel{352, 144 * sqrt2, 0}
                    : ring_kernel{352, 162 * sqrt2, 90};
}
constexpr ring_kernel kernel_g(std::size_t n)
{
    return n <= 3 ? ring_kernel{121, 71, 0} : n == 4 ? ring_kernel{121, 99, 81} : ring_kernel{121, 81, 36};
}

} // namespace detail

/// Returns the weight of neighbour e_j at valence n. opposite_weight returns that of the vertex d_j opposite in the
/// face between e_j and e_j+1.
constexpr double neighbor_weight(ternary_point point, std::size_t j, std::size_t n)
{
    if (point == ternary_point::vertex)
        return 304. / double(n);
    return point == ternary_point::edge ? detail::kernel_b(n).at(2 * std::int64_t(j), n)
                                        : detail::kernel_q(n).at(2 * std::int64_t(j) - 1, n);
}
constexpr double opposite_weight(ternary_point point, std::size_t j, std::size_t n)
{
    if (point == ternary_point::vertex)
        return 64. / double(n);
    return point == ternary_point::edge ? detail::kernel_c(n).at(2 * std::int64_t(j) + 1, n)
                                        : detail::kernel_g(n).at(2 * std::int64_t(j), n);
}

/// The kernel of the point that stands for the opposite vertex in a face of m >= 5 corners.
inline constexpr wave_kernel diagonal_kernel{1, -1, 1};

/// Returns the weight of the k-th corner in the point that stands for the opposite vertex in a face of m != 4 corners.
constexpr double diagonal_weight(std::size_t k, std::size_t m)
{
    return (m >= 5 ? diagonal_kernel : wave_kernel{1, -1, 0}).at(2 * std::int64_t(k), m);
}

/// Returns the waves of the weights that a new point gives to the corners of a face of m != 4 corners. Corners are
/// counted from the vertex of the new point (and along its edge), and the weights sum to x0. The last wave is for m >=
/// 5.
inline wave_kernel polygon_kernel(ternary_point point, std::size_t m)
{
    using complex = std::complex<double>;
    constexpr double arc = 0.46364760900080611621; // atan(1/2)
    const double x = 4 * arc / double(m);
    double cosine = 1, sine = 1; // by their series, for the same reason as in exact_cos
    for (int i = 20; i > 0; i -= 2) {
        cosine = 1 - x * x / (i * (i - 1)) * cosine;
        sine = 1 - x * x / (i * (i + 1)) * sine;
    }
    const complex al(cosine, x * sine), turn(exact_cos(1, std::int64_t(m)), sin_turn(1, std::int64_t(m)));
    const complex phi_al = turn * std::conj(al); // angles al and phi - al
    const complex al2 = al * al, phi_al2 = phi_al * phi_al;
    using detail::sqrt5;
    switch (point) {
    case ternary_point::face:
        return {676,
                240 - 2 * sqrt5 * (16 * al.real() + 10 * phi_al.real()),
                72 - 10 * (16 * al2.real() + 10 * phi_al2.real())};
    case ternary_point::edge:
        return {598,
                sqrt5 * (179. * al - 19. * std::conj(al) - 40. * phi_al - 4. * std::conj(phi_al)) - 12.,
                5. * (17. * al2 - 19. * std::conj(al2) - 40. * phi_al2 - 4. * std::conj(phi_al2)) - 36.};
    default:
        return {529,
                681 - 2 * sqrt5 * (76 * al.real() + 16 * phi_al.real()),
                585 - 10 * (76 * al2.real() + 16 * phi_al2.real())};
    }
}

/// Returns the weight of the k-th corner by polygon_kernel, divided by x0: the weights of all corners sum to one.
inline double polygon_weight(ternary_point point, std::size_t k, std::size_t m)
{
    const auto [k0, k1, k2] = polygon_kernel(point, m);
    const auto wave = [&](const std::complex<double>& amplitude, std::int64_t turns) {
        const auto turn = -turns * std::int64_t(k), full = std::int64_t(m);
        return 2 * (amplitude * std::complex(exact_cos(turn, full), sin_turn(turn, full))).real();
    };
    return (k0 + wave(k1, 1) + (m >= 5 ? wave(k2, 2) : 0)) / (double(m) * k0);
}

/// The ring weights of (v,e) and (v,f) by valence, up to longest_row.
template <weight_number Scalar>
class ternary_weights {
public:
    struct of_valence {
        const Scalar *b, *c, *q, *g;
    };

    of_valence operator()(std::size_t n) const { return {b_(n), c_(n), q_(n), g_(n)}; }

private:
    template <ternary_point Point, bool Opposite>
    static std::vector<double> make(std::size_t n)
    {
        std::vector<double> result;
        for (std::size_t j = 0; j < n; ++j)
            result.push_back(Opposite ? opposite_weight(Point, j, n) : neighbor_weight(Point, j, n));
        return result;
    }

    rows_by_valence<Scalar> b_{make<ternary_point::edge, false>}, c_{make<ternary_point::edge, true>},
        q_{make<ternary_point::face, false>}, g_{make<ternary_point::face, true>};
};

/// The weights around a vertex beside faces that are not quads. They are doubles, since they are combined before they
/// become scalars.
class polygon_weights {
public:
    static const polygon_weights& shared()
    {
        static const auto& weights = *new polygon_weights; // never destroyed: static objects may refine until the end
        return weights;
    }

    /// Returns `neighbor_weight`, and `opposite` returns `opposite_weight`. Precondition: n <= longest_row, except for
    /// ternary_point::vertex.
    [[nodiscard]] double neighbor(ternary_point point, std::size_t j, std::size_t n) const
    {
        return point == ternary_point::vertex ? neighbor_weight(point, j, n) : neighbors_[index(point)](n)[j];
    }
    [[nodiscard]] double opposite(ternary_point point, std::size_t j, std::size_t n) const
    {
        return point == ternary_point::vertex ? opposite_weight(point, j, n) : opposites_[index(point)](n)[j];
    }
    /// Returns `polygon_weight` for each k. Precondition: m <= longest_row.
    [[nodiscard]] const double* special(ternary_point point, std::size_t m) const { return special_[index(point)](m); }
    /// Returns `diagonal_weight` for each k. Precondition: m <= longest_row.
    [[nodiscard]] const double* diagonal(std::size_t m) const { return diagonal_(m); }

private:
    static constexpr std::size_t index(ternary_point point) { return std::size_t(point); }

    template <class WeightOf>
    static rows_by_valence<double> rows(WeightOf weight_of)
    {
        return rows_by_valence<double>([weight_of](std::size_t n) {
            std::vector<double> result;
            for (std::size_t k = 0; k < n; ++k)
                result.push_back(weight_of(k, n));
            return result;
        });
    }
    template <class WeightOf>
    static std::array<rows_by_valence<double>, 3> by_point(WeightOf weight_of)
    {
        const auto of = [&](ternary_point point) {
            return rows([=](std::size_t k, std::size_t n) { return weight_of(point, k, n); });
        };
        return {of(ternary_point::vertex), of(ternary_point::edge), of(ternary_point::face)};
    }

    std::array<rows_by_valence<double>, 3> neighbors_ = by_point(neighbor_weight),
                                           opposites_ = by_point(opposite_weight), special_ = by_point(polygon_weight);
    rows_by_valence<double> diagonal_ = rows(diagonal_weight);
};

} // namespace kith
