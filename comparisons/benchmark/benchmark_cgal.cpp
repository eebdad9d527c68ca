// SPDX-License-Identifier: BSD-3-Clause
#include "peers/cgal_peer.hpp"
#include "contests.hpp"

#include <kith/cgal_subdivision.hpp>
#include <kith/presets.hpp>

#include <CGAL/Polyhedron_3.h>

namespace kith::comparison {

namespace {

using polyhedron = CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>;

/// Adds contests between CGAL on Surface_mesh, kith, and CGAL on its other mesh type, Polyhedron_3.
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

/// Makes a contest between CGAL's function, which carries no property maps, and kith's function of the same name.
/// add_maps(mesh) adds the property maps that kith carries.
template <class AddMaps>
contest in_place(const course& course, const std::string& what, const AddMaps& add_maps)
{
    const auto make = [=] {
        auto mesh = std::make_shared<cgal_peer::mesh>(cgal_peer::make(*course.control).value());
        add_maps(*mesh);
        return mesh;
    };
    const auto theirs = [=]() -> work {
        return [=, mesh = make()] {
            cgal_peer::refine(*mesh, catmull_clark{}, course.levels);
            return mesh;
        };
    };
    const auto ours = [=]() -> work {
        return [=, mesh = make()] {
            kith::cgal::CatmullClark_subdivision(*mesh, CGAL::parameters::number_of_iterations(course.levels));
            return mesh;
        };
    };
    return {"catmull-clark",
            course.name + ", in place, " + what,
            course.levels,
            course.faces,
            {{cgal_peer::version(), theirs, {}}, {"kith::cgal", ours, {}}}};
}

} // namespace

std::vector<contest> cgal_doors(const course_settings& settings)
{
    using mesh = cgal_peer::mesh;
    std::vector<contest> result;
    for (const auto& course : courses(like<catmull_clark>(library::cgal), settings)) {
        result.push_back(in_place(course, "no maps", [](mesh&) {}));
        result.push_back(in_place(course, "a double at vertices, an int on faces, a UV on half-edges", [](mesh& m) {
            auto weights = m.add_property_map<mesh::Vertex_index, double>("v:weight").first;
            auto labels = m.add_property_map<mesh::Face_index, int>("f:label").first;
            auto uvs = m.add_property_map<mesh::Halfedge_index, CGAL::Simple_cartesian<double>::Point_2>("h:uv").first;
            for (const auto v : m.vertices())
                weights[v] = m.point(v).x();
            for (const auto f : m.faces())
                labels[f] = int(f) % 7;
            for (const auto h : m.halfedges())
                uvs[h] = {double(h % 5), double(h % 3)};
        }));
    }
    return result;
}

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
