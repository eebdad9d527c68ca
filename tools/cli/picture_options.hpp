// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "job/picture_colors.hpp"
#include "job/repair_input.hpp"
#include "job/schemes.hpp"

#include <kith/picture/scene.hpp>

#include <boost/program_options/options_description.hpp>
#include <boost/program_options/variables_map.hpp>

#include <optional>
#include <string>
#include <vector>

namespace kith::tool {

/// The command line of `kith picture`.
struct picture_request {
    std::string input{}, output{};
    bool is_svg = false;
    std::vector<std::string> schemes{}; ///< a row of pictures for each
    std::vector<int> levels{};          ///< a column for each; if empty, the limit surface is shown
    std::optional<int> wire{};          ///< the level whose edges are shown
    bool has_cage = false;
    color_request color{};
    std::string partitioner{};
    picture::view view{};
    int width = 0, height = 0; ///< 0 leaves them to the number of pictures
    bool is_transparent = false;
};

/// Adds --view and --up, which `view_from` reads.
void add_view_options(boost::program_options::options_description& options);
/// Returns the direction of the viewer. Errors: usage_error.
picture::view view_from(const boost::program_options::variables_map& values);

boost::program_options::options_description options_of_picture();

/// Returns the request of a command line. Errors: usage_error, whose text names the option and what it takes;
/// file_error for an output without a name.
picture_request picture_request_from(const boost::program_options::variables_map& values);

} // namespace kith::tool
