// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/in_library.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace kith {

/// A type of numbers in a PLY file, with functions that read one number of a binary file. Precondition of all functions
/// that read: `bytes` bytes exist at `stored`.
struct ply_number {
    std::size_t bytes = 0;
    bool floating = false;
    bool is_signed = false;

    /// Returns a whole number. Precondition: the type is one of whole numbers.
    template <std::endian Order = std::endian::little>
    [[nodiscard]] std::int64_t whole(const char* stored) const
    {
        const std::uint64_t bits = bits_of<Order>(stored);
        const int unused = int(64 - 8 * bytes);
        return is_signed ? std::int64_t(bits << unused) >> unused : std::int64_t(bits);
    }
    /// Returns a number, finite or not, as a double, which holds every number that a file can have.
    template <std::endian Order = std::endian::little>
    [[nodiscard]] double value(const char* stored) const
    {
        if (not floating)
            return double(whole<Order>(stored));
        const std::uint64_t bits = bits_of<Order>(stored);
        return bytes == 4 ? double(std::bit_cast<float>(std::uint32_t(bits))) : std::bit_cast<double>(bits);
    }

private:
    template <std::endian Order>
    [[nodiscard]] std::uint64_t bits_of(const char* stored) const
    {
        switch (bytes) {
        case 1: return load<Order, std::uint8_t>(stored);
        case 2: return load<Order, std::uint16_t>(stored);
        case 4: return load<Order, std::uint32_t>(stored);
        default: return load<Order, std::uint64_t>(stored);
        }
    }
    template <std::endian Order, class Unsigned>
    static std::uint64_t load(const char* stored)
    {
        std::array<char, sizeof(Unsigned)> result;
        std::memcpy(result.data(), stored, result.size());
        if constexpr (Order != std::endian::native)
            std::ranges::reverse(result);
        return std::bit_cast<Unsigned>(result);
    }
};

} // namespace kith
