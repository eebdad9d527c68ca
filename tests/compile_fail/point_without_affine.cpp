// SPDX-License-Identifier: BSD-3-Clause
#include <kith/linear.hpp>
#include <kith/refine.hpp>

#include <array>
#include <vector>

struct my_point {
    double x, y, z;
};

const std::vector<my_point> points;
const std::vector<std::array<int, 4>> faces;

int main()
{
#ifdef LISTS
    kith::refine(points, faces, kith::linear(), 1);
#else
    const auto mesh = kith::make_mesh(points, faces);
    kith::refine(mesh, kith::linear(), 1);
#endif
}
