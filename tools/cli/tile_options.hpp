// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "command_line.hpp"
#include "job/tile_request.hpp"

#include <initializer_list>
#include <string>

namespace kith::tool {

inline constexpr const char* journal_help =
    "keep finished tiles in DIR and resume from them; without IN, DIR provides the mesh and the options";

/// --journal DIR, or nothing. Errors: usage_error.
std::string journal_from(const boost::program_options::variables_map& values);

/// Whether there is an IN; else the journal says what is refined. Errors: usage_error when there is neither, and when
/// options other than those `beside_journal` would say once more what is refined.
bool names_input(const boost::program_options::variables_map& values,
                 std::initializer_list<std::string_view> beside_journal);

/// What the command line says of a request, whose control mesh is not read yet. Errors: usage_error.
tile_request tile_request_from(const boost::program_options::variables_map& values);

} // namespace kith::tool
