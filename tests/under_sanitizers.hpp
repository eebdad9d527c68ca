// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Whether the program is compiled for the sanitizers, which make it many times slower: who tests on many meshes takes the small
/// ones there, which lead through the same lines.
#ifdef __SANITIZE_ADDRESS__
inline constexpr bool under_sanitizers = true;
#else
inline constexpr bool under_sanitizers = false;
#endif
