// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "command_line.hpp"
#include "job/tile_request.hpp"

#include <initializer_list>
#include <string>

namespace kith::tool {

inline constexpr const char* journal_help =
    "keep finished tiles in DIR and resume from them; without IN, DIR provides the mesh and the options";

/// Returns the directory of --journal, or an empty string if it is not given. Errors: usage_error.
std::string journal_from(const boost::program_options::variables_map& values);

/// Returns true if IN is given; otherwise the journal determines what is refined. Errors: usage_error if neither is
/// given, and for options outside `beside_journal` if the journal determines what is refined.
bool names_input(const boost::program_options::variables_map& values,
                 std::initializer_list<std::string_view> beside_journal);

/// Returns the request of a command line; its control mesh is not read yet. Errors: usage_error, and file_error for an
/// output without a name.
tile_request tile_request_from(const boost::program_options::variables_map& values);

} // namespace kith::tool
