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

/// How the faces of a file may be changed so that they form a manifold.
struct input_repair {
    repair_options options{};
    bool welds_rounded = false; ///< within the rounding distance of the points

    [[nodiscard]] bool empty() const;
};

/// Adds --repair and --weld.
void add_repair_options(boost::program_options::options_description& options);

/// Reads --repair and --weld. Errors: usage_error.
input_repair input_repair_from(const boost::program_options::variables_map& values);

/// A repair by its words, such as "drop,weld=0.001", and the words of one. Errors: usage_error.
input_repair repair_named(std::string_view words);
std::string words_of(const input_repair& repair);

/// The content of a file after a repair, with all that belongs to its elements: attributes, creases, sharp vertices and
/// holes. `report` is told what was done; `notes` what it does to attributes and tags. Errors: mesh_error for tags of
/// elements that do not exist, and as `repair`.
io::polygon_soup repaired_soup(const io::polygon_soup& soup, const input_repair& repair, repair_report& report,
                               std::vector<std::string>& notes);

/// Vertices at the boundary that lie where others do.
struct cracks {
    std::vector<std::pair<std::size_t, std::size_t>> equal; ///< the vertex and the one it lies on
    std::vector<std::pair<std::size_t, std::size_t>>
        rounded;         ///< those within the rounding distance, the equal ones, too
    double distance = 0; ///< the rounding distance
};
cracks cracks_of(const io::polygon_soup& soup);

/// The options that would mend what a report tells, in sentences; none if there are no such.
std::vector<std::string> remedies(const io::polygon_soup& soup, const mesh_report& report);

} // namespace kith::tool
