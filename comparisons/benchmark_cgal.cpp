// SPDX-License-Identifier: BSD-3-Clause
#include "cgal_peer.hpp"
#include "contests.hpp"

#include <kith/presets.hpp>

#include <CGAL/Polyhedron_3.h>

namespace kith::comparison {

namespace {

using polyhedron = CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>;

/// Surface_mesh, kith, and CGAL's other mesh.
template <class Scheme>
void add_cgal_contests(std::vector<contest>& list, const course_settings& settings)
{
    std::size_t next = list.size();
    add_contests<cgal_peer, Scheme>(list, settings);
    const auto scheme = like<Scheme>(library::cgal);
    for (const auto& course : courses(scheme, settings))
        list[next++].contestants.push_back(
            {"CGAL, Polyhedron_3",
             [=]() -> work {
                 return
                     [=, input = std::make_shared<polyhedron>(cgal_peer::make<polyhedron>(*course.control).value())] {
                         cgal_peer::refine(*input, scheme, course.levels);
                         return input;
                     };
             },
             {}});
}

} // namespace

std::string cgal_version()
{
    return cgal_peer::version();
}

std::vector<contest> cgal_contests(const course_settings& settings)
{
    std::vector<contest> result;
    add_cgal_contests<catmull_clark>(result, settings);
    add_cgal_contests<loop>(result, settings);
    add_cgal_contests<doo_sabin>(result, settings);
    add_cgal_contests<sqrt3>(result, settings);
    return result;
}

} // namespace kith::comparison
