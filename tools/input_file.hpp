// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace kith::tool {

/// All bytes of a file, or of standard input for "-". Errors: file_error.
std::string read_bytes(const std::string& path);

} // namespace kith::tool
