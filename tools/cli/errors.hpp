// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/io/text/file_error.hpp>

#include <stdexcept>

namespace kith::tool {

using namespace io; // NOLINT(google-build-using-namespace): what files hold has the same names in the programs

/// An error in the command line of the program; exit code 2.
struct usage_error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

} // namespace kith::tool
