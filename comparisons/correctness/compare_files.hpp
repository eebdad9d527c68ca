// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "verdicts.hpp"

#include <functional>
#include <string>

namespace kith::comparison {

/// The common main(): has the shapes of the tests compared, and each good mesh of the files that the arguments name.
/// The exit code: 0 all the same, 1 something differs, 2 wrong arguments, 77 all the same but there were no files.
int compare_files(int count, char** words, const std::string& what_it_does,
                  const std::function<void(const control_mesh& control, int levels, verdicts&)>& compare);

} // namespace kith::comparison
