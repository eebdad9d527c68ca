// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/affine.hpp>
#include <kith/core/mesh/basic_mesh.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace kith {

using normal_vector = std::array<double, 3>;

namespace detail {

/// Returns the result of std::ilogb; times_power_of_two that of std::scalbn. In usual cases both only shift the bits of
/// the exponent, since the calls take many times as long.
inline int exponent_of(double x)
{
    const int biased = int(std::bit_cast<std::uint64_t>(x) >> 52 & 0x7ff);
    return biased != 0 and biased != 0x7ff ? biased - 1023 : std::ilogb(x);
}
inline double times_power_of_two(double x, int exponent)
{
    if (-1022 <= exponent and exponent <= 1023) [[likely]]
        return x * std::bit_cast<double>(std::uint64_t(exponent + 1023) << 52);
    return std::scalbn(x, exponent);
}

/// The exponent of the largest coordinate of some vectors; that of the smallest number if all are zero.
class common_exponent {
public:
    template <class Vector>
    void add(const Vector& v)
    {
        for (std::size_t i = 0; i < 3; ++i)
            if (const double x = std::abs(double(v[i])); x <= std::numeric_limits<double>::max())
                largest_ = std::max(largest_, x);
    }
    [[nodiscard]] int value() const
    {
        return largest_ != 0 ? exponent_of(largest_)
                             : std::numeric_limits<double>::min_exponent - std::numeric_limits<double>::digits;
    }

private:
    double largest_ = 0;
};

template <class Vector>
normal_vector scaled(const Vector& v, int exponent)
{
    normal_vector result;
    for (std::size_t i = 0; i < 3; ++i)
        result[i] = times_power_of_two(double(v[i]), exponent);
    return result;
}

inline bool is_finite(const normal_vector& v)
{
    return std::isfinite(v[0]) and std::isfinite(v[1]) and std::isfinite(v[2]);
}

/// Returns the bits of the exponent of the largest coordinate. It does not branch, since signs and sizes are in no
/// order.
inline std::uint64_t exponent_bits(const normal_vector& v)
{
    std::uint64_t largest = 0;
    for (const double x : v)
        largest = std::max(largest, std::bit_cast<std::uint64_t>(x) << 1);
    return largest >> 53;
}
/// Returns true if one multiplication can bring an exponent with these bits to zero.
inline bool is_usual(std::uint64_t exponent_bits)
{
    return 0 < exponent_bits and exponent_bits < 0x7fe;
}

/// Returns the vector times a power of two that brings its largest coordinate near to one. No other bit changes.
inline normal_vector brought_near_one(const normal_vector& v)
{
    if (const std::uint64_t bits = exponent_bits(v); is_usual(bits)) [[likely]] {
        const double factor = std::bit_cast<double>((0x7fe - bits) << 52);
        return {v[0] * factor, v[1] * factor, v[2] * factor};
    }
    common_exponent exponent;
    exponent.add(v);
    return scaled(v, -exponent.value());
}

inline double length_of(const normal_vector& n)
{
    return std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
}

} // namespace detail

/// Returns the vector of length one in the direction of v, whatever the size of v; nothing if v is zero or not finite.
template <class Vector>
inline std::optional<normal_vector> unit_vector(const Vector& v)
{
    auto n = detail::brought_near_one(detail::scaled(v, 0));
    const double length = detail::length_of(n);
    if (not(length > 0) or not std::isfinite(length))
        return std::nullopt;
    for (double& x : n)
        x /= length;
    return n;
}

namespace detail {

template <class Number>
[[gnu::always_inline]] inline std::array<Number, 3> cross(const std::array<Number, 3>& a,
                                                          const std::array<Number, 3>& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// Returns false if a sum of squares may have overflowed or lost digits.
inline bool is_usual_square(double square)
{
    constexpr double small = 0x1p-600, large = 0x1p600;
    return small < square and square < large;
}
/// Returns the unit normal of two vectors whose products may overflow or vanish.
[[gnu::noinline]] inline std::optional<normal_vector> unit_normal_of_any(const normal_vector& first,
                                                                         const normal_vector& second)
{
    return unit_vector(cross(brought_near_one(first), brought_near_one(second)));
}

} // namespace detail

/// Returns the unit normal of the plane of two vectors, counter-clockwise; nothing if they are parallel or not finite.
template <class Vector>
inline std::optional<normal_vector> unit_normal(const Vector& first, const Vector& second)
{
    const normal_vector a{double(first[0]), double(first[1]), double(first[2])},
        b{double(second[0]), double(second[1]), double(second[2])};
    normal_vector n = detail::cross(a, b);
    const double square = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
    if (not detail::is_usual_square(square)) [[unlikely]]
        return detail::unit_normal_of_any(a, b);
    const double length = std::sqrt(square);
    for (double& x : n)
        x /= length;
    return n;
}

/// Returns for each wanted vertex the unit vector of the mean of its faces' normals, each weighed by its area (Newell's
/// formula). The result is zero if no face has an area, or if the normals cancel out, as those of two faces back to
/// back do. Sums are formed with an exponent per vertex, so that they neither overflow nor vanish. Precondition:
/// `wanted` is empty, which means all, or has a mark per vertex. Cost: O(corners).
template <class Point, std::unsigned_integral Index>
std::vector<normal_vector> mean_face_normals(const basic_mesh<Point, Index>& mesh, std::span<const Point> positions,
                                             std::span<const unsigned char> wanted = {})
{
    const auto is_wanted = [&](Index v) { return wanted.empty() or wanted[v] != 0; };
    const auto exponent_of = [&](std::size_t f) {
        detail::common_exponent result;
        for (const Index v : mesh.face(f))
            result.add(affine<Point>::load(positions[v]));
        return result.value();
    };
    std::vector<int> exponents(mesh.vertex_count(), std::numeric_limits<int>::min());
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        if (const auto face = mesh.face(f); std::ranges::any_of(face, is_wanted))
            for (const int exponent = exponent_of(f); const Index v : face)
                exponents[v] = std::max(exponents[v], exponent);
    std::vector<normal_vector> result(mesh.vertex_count(), normal_vector{});
    std::vector<double> total(mesh.vertex_count(), 0); // sum of the lengths of the added normals
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const auto face = mesh.face(f);
        if (std::ranges::none_of(face, is_wanted))
            continue;
        const int exponent = exponent_of(f);
        normal_vector normal{};
        auto p = detail::scaled(affine<Point>::load(positions[face[0]]), -exponent);
        for (std::size_t i = 0; i < face.size(); ++i) {
            const auto q = detail::scaled(affine<Point>::load(positions[face[(i + 1) % face.size()]]), -exponent);
            for (std::size_t k = 0; k < 3; ++k)
                normal[k] += (p[(k + 1) % 3] - q[(k + 1) % 3]) * (p[(k + 2) % 3] + q[(k + 2) % 3]);
            p = q;
        }
        if (not detail::is_finite(normal))
            continue;
        const double length = detail::length_of(normal);
        for (const Index v : face) {
            const int shift = 2 * (exponent - exponents[v]);
            for (std::size_t k = 0; k < 3; ++k)
                result[v][k] += detail::times_power_of_two(normal[k], shift);
            total[v] += detail::times_power_of_two(length, shift);
        }
    }
    constexpr double rounding = 0x1p-45;
    for (std::size_t v = 0; v < result.size(); ++v) {
        const bool cancels_out = detail::length_of(result[v]) < rounding * total[v];
        result[v] = cancels_out ? normal_vector{} : unit_vector(result[v]).value_or(normal_vector{});
    }
    return result;
}

} // namespace kith
