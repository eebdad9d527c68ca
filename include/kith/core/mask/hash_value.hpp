// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/affine.hpp>

#include <bit>
#include <compare>
#include <cstdint>

namespace kith {

/// The 64-bit hash of operands and weights in their order; masks over such values form the hash algebra. Evaluating a
/// scheme over hashes proves more than evaluating it over points. Equal hashes mean the same operands with the same
/// weights in the same order. Equal coordinates may be luck (symmetric input, a + b = b + a).
struct hash_value {
    std::uint64_t bits = 0;

    friend constexpr auto operator<=>(const hash_value&, const hash_value&) = default;
};

/// Maps 64-bit words one to one, so that every bit of the input changes every bit of the output. It uses two rounds of
/// multiplying and folding, as in Steele, Lea & Flood 2014, "Fast splittable pseudorandom number generators",
/// section 4.
constexpr std::uint64_t mix_bits(std::uint64_t x)
{
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31);
}

template <>
struct affine<hash_value> {
    using scalar = double;
    using sum = hash_value;

    static constexpr hash_value load(hash_value value) { return value; }
    static constexpr hash_value store(hash_value total) { return total; }
    static constexpr void add(hash_value& total, hash_value more)
    {
        total.bits = mix_bits(mix_bits(total.bits + 0x9e3779b97f4a7c15U) + more.bits);
    }
    static constexpr void scale(hash_value& total, double weight)
    {
        total.bits = mix_bits(total.bits ^ mix_bits(std::bit_cast<std::uint64_t>(weight)));
    }
};

} // namespace kith
