// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "verdicts.hpp"

#include <functional>
#include <string>

namespace kith::comparison {

/// Implements main() of the comparison programs: compares the shapes of the tests, and each valid mesh of the files
/// that the arguments name. Returns the exit code: 0 if all results agree, 1 if a result differs, 2 for wrong
/// arguments, 77 if all agree but there were no files.
int compare_files(int count, char** words, const std::string& what_it_does,
                  const std::function<void(const control_mesh& control, int levels, verdicts&)>& compare);

} // namespace kith::comparison
