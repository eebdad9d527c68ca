// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/platform.hpp>

/// A constant that is true if the program is compiled with sanitizers, which make it many times slower. Tests on many
/// meshes then use the small ones, which execute the same lines.
inline constexpr bool under_sanitizers = kith::detail::is_sanitized;
