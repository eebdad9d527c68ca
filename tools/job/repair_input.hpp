// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/mesh/mesh_report.hpp>
#include <kith/core/repair/repair_options.hpp>
#include <kith/core/repair/repair_report.hpp>
#include <kith/polygon_soup.hpp>

#include <boost/program_options/options_description.hpp>
#include <boost/program_options/variables_map.hpp>

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kith::tool {

/// The changes that are allowed to make the faces of a file a manifold.
struct input_repair {
    repair_options options{};
    bool welds_rounded = false; ///< weld within the rounding distance of the points

    [[nodiscard]] bool empty() const;
};

/// Adds --repair and --weld.
void add_repair_options(boost::program_options::options_description& options);

/// Returns the repair that --repair and --weld ask for. Errors: usage_error.
input_repair input_repair_from(const boost::program_options::variables_map& values);

/// Returns the repair that words such as "drop,weld=0.001" name (repair_named), or the words of a repair (words_of).
/// Errors: usage_error.
input_repair repair_named(std::string_view words);
std::string words_of(const input_repair& repair);

/// Returns the content of a file after a repair, with everything that belongs to its elements: attributes, creases,
/// sharp vertices and holes. `report` receives what was done, and `notes` the effects on attributes and tags. Errors:
/// mesh_error for tags of elements that do not exist, and the errors of `repair`.
io::polygon_soup repaired_soup(const io::polygon_soup& soup, const input_repair& repair, repair_report& report,
                               std::vector<std::string>& notes);

/// Vertices at the boundary that lie at the same place as other vertices.
struct cracks {
    std::vector<std::pair<std::size_t, std::size_t>> equal; ///< each with the vertex at exactly its place
    std::vector<std::pair<std::size_t, std::size_t>>
        rounded;         ///< pairs within the rounding distance, including those in `equal`
    double distance = 0; ///< the rounding distance
};
cracks cracks_of(const io::polygon_soup& soup);

/// Returns sentences on the options that would solve the problems of a report; none if there are no such options.
std::vector<std::string> remedies(const io::polygon_soup& soup, const mesh_report& report);

} // namespace kith::tool
