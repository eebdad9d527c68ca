// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "job/schemes.hpp"

#include <boost/program_options/options_description.hpp>
#include <boost/program_options/variables_map.hpp>

namespace kith::tool {

/// Adds --scheme and what chooses between the forms of a scheme, and --levels unless it is left out.
void add_scheme_options(boost::program_options::options_description& options, bool with_levels = true);

scheme_words scheme_words_of(const boost::program_options::variables_map& values);

/// --uv
void add_uv_option(boost::program_options::options_description& options);

/// --uv, or all. Errors: usage_error for a word that is none, and for seams that the scheme has no rules for.
face_varying_linear linear_from(const boost::program_options::variables_map& values, const any_scheme& scheme);

} // namespace kith::tool
