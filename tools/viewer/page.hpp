// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace kith::tool {

/// The page that `kith view` writes, with "@CONTENT@" in place of the meshes. It is made when kith is built. It is
/// empty if no compiler for WebAssembly was found.
extern const std::string_view viewer_page;

} // namespace kith::tool
