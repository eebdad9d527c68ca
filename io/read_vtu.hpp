// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/polygon_soup.hpp>

#include <string>
#include <string_view>

namespace kith::io {

/// Same as read_vtu, but of a file in `directory`, from where an index (.pvtu, .pvtp) names the files of its pieces.
/// Errors: file_error.
polygon_soup read_vtu(std::string_view bytes, const std::string& directory);

} // namespace kith::io
