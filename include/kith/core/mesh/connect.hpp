// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/in_library.hpp>

namespace kith {

/// The connectivity that is wanted of a new level: none (only values are computed), face-vertex lists, or everything.
enum class connect : unsigned char { nothing, faces, everything };

} // namespace kith
