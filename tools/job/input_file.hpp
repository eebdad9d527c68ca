// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/io/text/file_bytes.hpp>

#include <string>

namespace kith::tool {

/// Returns all bytes of a file, or of standard input for "-". Errors: file_error.
inline std::string read_bytes(const std::string& path)
{
    return std::string(io::file_bytes(path).view());
}

} // namespace kith::tool
