// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace kith::detail {

/// The flag of the address sanitizer: true if the program is compiled for it. g++ defines a macro for this, clang a
/// feature.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool is_sanitized = true;
#elif defined(__has_feature)
inline constexpr bool is_sanitized = __has_feature(address_sanitizer);
#else
inline constexpr bool is_sanitized = false;
#endif

} // namespace kith::detail
