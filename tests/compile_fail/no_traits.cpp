// SPDX-License-Identifier: BSD-3-Clause
#include <kith/catmull_clark.hpp>
#include <kith/refine.hpp>

struct not_a_mesh {};

int main()
{
    kith::refine(not_a_mesh{}, kith::catmull_clark{}, 1);
}
