// SPDX-License-Identifier: BSD-3-Clause
#include "peers/cgal_peer.hpp"
#include "compare_peer.hpp"

int main(int count, char** words)
{
    using namespace kith::comparison;
    return compare_files(count,
                         words,
                         "Refines meshes with CGAL and with kith and compares the results.",
                         [](const control_mesh& control, int levels, verdicts& verdicts) {
                             compare_scheme<cgal_peer, kith::catmull_clark>(control, levels, verdicts);
                             compare_scheme<cgal_peer, kith::doo_sabin>(control, levels, verdicts);
                             compare_scheme<cgal_peer, kith::loop>(control, levels, verdicts);
                             compare_scheme<cgal_peer, kith::sqrt3>(control, levels, verdicts);
                         });
}
