// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/base/in_library.hpp>

#include <stdexcept>

namespace kith::io {

/// A file that cannot be read, understood or written. What works on files puts the path in front, what works on bytes
/// begins with the line or the element.
struct file_error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

} // namespace kith::io
