// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "in_library.hpp"

#include <cassert>
#include <stdexcept>
#include <string>

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__)
#error "kith promises the same bits on any number of threads and tiles; compile it without -ffast-math and its parts"
#endif

/// The assertion of an invariant of kith itself, checked in debug builds only.
#define KITH_ASSERT(condition) assert(condition)

namespace kith {

/// The error for invalid input of a user. The text names the elements and says what to do; the input is unchanged.
struct mesh_error : std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

/// The error for a fault in a scheme: an association was read before it was set, was set twice, or was never set. The
/// text names the tuple.
struct association_error : std::logic_error {
    using std::logic_error::logic_error;
};

} // namespace kith
