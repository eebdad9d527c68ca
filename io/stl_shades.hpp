// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

/// The 32 shades of red, green and blue that binary STL has.
namespace kith::io {

/// Returns the shade nearest to a channel from 0 to 1.
inline std::uint16_t stl_shade(double channel)
{
    return std::uint16_t(std::lround(31 * std::clamp(channel, 0., 1.)));
}
/// Returns the byte of a shade. stl_shade of this byte is the same shade again.
inline double byte_of_stl_shade(std::uint16_t shade)
{
    return std::round(shade * 255. / 31);
}

} // namespace kith::io
