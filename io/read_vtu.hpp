// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/polygon_soup.hpp>

#include <string>
#include <string_view>

namespace kith::io {

/// Reads a file of VTK like read_vtu(bytes). An index (.pvtu, .pvtp) names the files of its pieces relative to
/// `directory`. Errors: file_error.
polygon_soup read_vtu(std::string_view bytes, const std::string& directory);

} // namespace kith::io
