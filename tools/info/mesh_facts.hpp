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

/// The facts that can be counted on any polygons, whether or not they form a valid mesh.
struct mesh_facts {
    std::size_t vertices = 0;
    std::size_t edges = 0; ///< pairs of vertices that are neighbours in a face
    std::size_t faces = 0;
    std::size_t isolated = 0;                    ///< vertices without a face
    std::size_t components = 0;                  ///< connected components; isolated vertices do not count
    std::optional<std::size_t> boundary_loops{}; ///< only for a valid mesh
    std::ptrdiff_t euler_characteristic = 0;
    std::map<std::size_t, std::size_t> valences{}; ///< number of vertices by number of edges
    std::size_t between_two_faces = 0;             ///< inner vertices with two faces, which some schemes refuse
    std::map<std::size_t, std::size_t> degrees{};  ///< number of faces by number of corners
    std::optional<std::pair<std::array<double, 3>, std::array<double, 3>>> box{};
};

/// Returns the facts about polygons; `report` says whether they form a valid mesh. Cost: O(corners log corners).
mesh_facts facts_of(const io::polygon_soup& soup, const mesh_report& report);

} // namespace kith::tool
