// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>

namespace kith::tool {

/// The program was called in a way it does not know; exit code 2.
struct usage_error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A file that cannot be read, understood or written; exit code 1. The text begins with the path.
struct file_error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

} // namespace kith::tool
