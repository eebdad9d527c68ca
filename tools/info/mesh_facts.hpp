// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/mesh/mesh_report.hpp>
#include <kith/polygon_soup.hpp>

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

namespace kith::tool {

/// What can be counted on any polygons, good mesh or not.
struct mesh_facts {
    std::size_t vertices = 0;
    std::size_t edges = 0; ///< pairs of vertices that some face joins
    std::size_t faces = 0;
    std::size_t isolated = 0;                    ///< vertices that no face has
    std::size_t components = 0;                  ///< of vertices that faces join; loose vertices are none
    std::optional<std::size_t> boundary_loops{}; ///< only a good mesh has such
    std::ptrdiff_t euler_characteristic = 0;
    std::map<std::size_t, std::size_t> valences{}; ///< how many vertices have so many edges
    std::size_t between_two_faces = 0;             ///< inner vertices, which some schemes refuse
    std::map<std::size_t, std::size_t> degrees{};  ///< how many faces have so many corners
    std::optional<std::pair<std::array<double, 3>, std::array<double, 3>>> box{};
};

/// Cost: O(corners log corners).
mesh_facts facts_of(const io::polygon_soup& soup, const mesh_report& report);

} // namespace kith::tool
