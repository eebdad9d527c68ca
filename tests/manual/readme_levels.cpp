// SPDX-License-Identifier: BSD-3-Clause
// README.md, Keep all levels: on a cube, whose vertices have a number each.
#include <kith/catmull_clark.hpp>
#include <kith/core/mesh/make_mesh.hpp>
#include <kith/hierarchy.hpp>

#include <array>
#include <vector>

int main()
{
    std::vector<std::array<double, 3>> points;
    for (int i = 0; i < 8; ++i)
        points.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2)});
    const std::vector<std::array<int, 4>> faces{
        {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    using traits = kith::mesh_traits<kith::basic_mesh<>>;
    const auto mesh = kith::make_mesh(points, faces);
    const traits::edge edge{0};
    const traits::face cell{2}, face{2 * 64 + 5};
    const std::vector<double> colors(8, 1.);

    // @block@

    const bool is_right = levels.origin(1, vertex).e == edge and parents.v and parents.f and root.f == cell and
                          parts.size() == 64 and fine.size() == 386 and P.rows() == 386;
    return is_right ? 0 : 1;
}
