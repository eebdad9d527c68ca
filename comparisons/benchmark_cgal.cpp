// SPDX-License-Identifier: BSD-3-Clause
#include "cgal_peer.hpp"
#include "contests.hpp"

namespace kith::comparison {

std::string cgal_version()
{
    return cgal_peer::version();
}

std::vector<contest> cgal_contests(const course_settings& settings)
{
    std::vector<contest> result;
    add_contests<cgal_peer, catmull_clark>(result, settings);
    add_contests<cgal_peer, loop>(result, settings);
    add_contests<cgal_peer, doo_sabin>(result, settings);
    add_contests<cgal_peer, sqrt3>(result, settings);
    return result;
}

} // namespace kith::comparison
