// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <numeric>
#include <ostream>

/// A rational number, for results that must be exact. Numerators and denominators must be small: nothing checks for
/// overflow.
class rational {
public:
    constexpr rational(std::int64_t n = 0, std::int64_t d = 1) : n_(n), d_(d) { reduce(); }
    constexpr rational(int n) : rational(std::int64_t(n)) {}
    explicit constexpr rational(double x) : rational(0)
    {
        std::int64_t d = 1;
        while (x != double(std::int64_t(x)))
            x *= 2, d *= 2;
        *this = rational(std::int64_t(x), d);
    }

    rational& operator+=(rational b) { return *this = *this + b; }
    rational& operator*=(rational b) { return *this = *this * b; }
    friend constexpr rational operator+(rational a, rational b) { return {a.n_ * b.d_ + b.n_ * a.d_, a.d_ * b.d_}; }
    friend constexpr rational operator-(rational a, rational b) { return {a.n_ * b.d_ - b.n_ * a.d_, a.d_ * b.d_}; }
    friend constexpr rational operator*(rational a, rational b) { return {a.n_ * b.n_, a.d_ * b.d_}; }
    friend constexpr rational operator/(rational a, rational b) { return {a.n_ * b.d_, a.d_ * b.n_}; }
    friend constexpr bool operator==(rational, rational) = default;
    friend std::ostream& operator<<(std::ostream& out, rational a) { return out << a.n_ << '/' << a.d_; }

private:
    constexpr void reduce()
    {
        const std::int64_t g = std::gcd(n_, d_) * (d_ < 0 ? -1 : 1);
        n_ /= g;
        d_ /= g;
    }

    std::int64_t n_;
    std::int64_t d_;
};
