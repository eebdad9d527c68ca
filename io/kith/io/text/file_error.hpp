// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "printable.hpp"

#include <kith/core/base/in_library.hpp>

#include <stdexcept>
#include <string>

namespace kith::io {

/// An error of a file that cannot be read, understood or written. Functions on files begin the text with the path,
/// functions on bytes with the line or the element. The text is printable: names and paths in it cannot upset a
/// terminal.
struct file_error : std::runtime_error {
    explicit file_error(const std::string& text) : std::runtime_error(printable(text)) {}
};

} // namespace kith::io
