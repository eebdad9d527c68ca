// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace kith::comparison {

/// Writes a picture: a white page of this size in pixels with the elements of `body`. Errors: io::file_error.
void write_svg_file(const std::string& path, double width, double height, const std::string& style,
                    const std::string& body);

} // namespace kith::comparison
