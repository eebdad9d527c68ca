// SPDX-License-Identifier: BSD-3-Clause
#include <kith/hierarchy.hpp>
#include <kith/linear.hpp>

#include <vector>

struct material {
    int id;
};

int main()
{
    const kith::hierarchy levels(kith::basic_mesh<>{}, kith::linear{});
    static_cast<void>(levels.carry(0, 1, std::vector<material>(8)));
}
