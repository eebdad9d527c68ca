// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "in_library.hpp"

#include <cassert>
#include <stdexcept>
#include <string>

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__)
#error "kith promises the same bits on any number of threads and tiles; compile it without -ffast-math and its parts"
#endif

/// Broken invariants of kith itself; checked in debug builds only.
#define KITH_ASSERT(condition) assert(condition)

namespace kith {

/// Input that a user can get wrong: the text names the elements and says what to do. The input is untouched.
struct mesh_error : std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

/// A fault in a scheme: an association that was read before it was set, set twice, or never set. The text names the
/// tuple.
struct association_error : std::logic_error {
    using std::logic_error::logic_error;
};

} // namespace kith
