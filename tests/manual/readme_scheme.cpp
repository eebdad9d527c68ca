// SPDX-License-Identifier: BSD-3-Clause
// README.md, Write your own scheme: a tetrahedron becomes an octahedron, then a cuboctahedron.
#include <kith/core/mesh/make_mesh.hpp>
#include <kith/hierarchy.hpp>

#include <array>
#include <vector>

// @block@

int main()
{
    const std::vector<std::array<double, 3>> points{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    const std::vector<std::array<int, 3>> faces{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
    kith::hierarchy levels(kith::make_mesh(points, faces), midpoints{});
    levels.refine(2);
    return levels[1].face_count() == 8 and levels[2].vertex_count() == 12 ? 0 : 1;
}
