// SPDX-License-Identifier: BSD-3-Clause
// A program that knows kith by pkg-config.

#include <kith/kith.hpp>
#include <kith/linear.hpp>

#include <array>
#include <vector>

int main()
{
    const std::vector<std::array<double, 3>> points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const auto square = kith::make_mesh(points, std::vector{std::array{0, 1, 2, 3}});
    const auto fine = kith::refine(square, kith::linear{}, 2);
    return fine.face_count() == 16 and fine.point(0) == points[0] ? 0 : 1;
}
