// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/sanitized.hpp>

/// Whether the program is compiled for the sanitizers, which make it many times slower: who tests on many meshes takes
/// the small ones there, which lead through the same lines.
inline constexpr bool under_sanitizers = kith::detail::is_sanitized;
