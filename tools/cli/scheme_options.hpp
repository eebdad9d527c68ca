// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "job/schemes.hpp"

#include <boost/program_options/options_description.hpp>
#include <boost/program_options/variables_map.hpp>

namespace kith::tool {

/// Adds --scheme and the options that choose between the forms of a scheme, and --levels if `with_levels` is true.
void add_scheme_options(boost::program_options::options_description& options, bool with_levels = true);

/// Adds the options that change the control mesh: its creases, and whether it is cut into triangles.
void add_control_mesh_options(boost::program_options::options_description& options);

scheme_words scheme_words_of(const boost::program_options::variables_map& values);

/// Adds --uv.
void add_uv_option(boost::program_options::options_description& options);

/// Returns the value of --uv, or `all` if it is not given. Errors: usage_error for an unknown word, and if the scheme
/// has no rules for seams.
face_varying_linear linear_from(const boost::program_options::variables_map& values, const any_scheme& scheme);

} // namespace kith::tool
