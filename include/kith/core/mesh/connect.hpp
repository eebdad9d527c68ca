// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/in_library.hpp>

namespace kith {

/// How much of a new level's connectivity is wanted: none (only values are computed), face-vertex lists, or all.
enum class connect : unsigned char { nothing, faces, everything };

} // namespace kith
