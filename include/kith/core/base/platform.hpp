// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>
#include <version>

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

/// A std::mutex. Standard libraries without threads, as that of WebAssembly, have none: there locking does nothing.
#ifdef _LIBCPP_HAS_NO_THREADS
struct mutex {
    void lock() {}
    void unlock() {}
};
#else
using std::mutex;
#endif

} // namespace kith::detail
