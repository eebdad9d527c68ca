// SPDX-License-Identifier: BSD-3-Clause
#include "contests.hpp"
#include "peers/openmesh_peer.hpp"

#include <kith/openmesh_subdivision.hpp>

#include <OpenMesh/Core/Utils/PropertyManager.hh>

namespace kith::comparison {

namespace {

using polygons = openmesh_peer<OpenMesh::PolyMesh_ArrayKernelT<openmesh_doubles>>;
using triangles = openmesh_peer<OpenMesh::TriMesh_ArrayKernelT<openmesh_doubles>>;

/// Makes a contest between OpenMesh's subdivider, which carries no properties, and kith's subdivider of the same name.
/// add_properties(mesh) adds the properties that kith carries.
template <class AddProperties>
contest in_place(const course& course, const std::string& what, const AddProperties& add_properties)
{
    using mesh = polygons::mesh;
    const auto make = [=] {
        auto result = std::make_shared<mesh>(polygons::make(*course.control).value());
        add_properties(*result);
        return result;
    };
    const auto theirs = [=]() -> work {
        return [=, mesh = make()] {
            polygons::refine(*mesh, catmull_clark{}, course.levels);
            return mesh;
        };
    };
    const auto ours = [=]() -> work {
        return [=, refined = make()] {
            kith::openmesh::CatmullClarkT<mesh>()(*refined, std::size_t(course.levels));
            return refined;
        };
    };
    return {"catmull-clark",
            course.name + ", in place, " + what,
            course.levels,
            course.faces,
            {{polygons::version(), theirs, {}}, {"kith::openmesh", ours, {}}}};
}

} // namespace

std::vector<contest> openmesh_doors(const course_settings& settings)
{
    std::vector<contest> result;
    for (const auto& course : courses(like<catmull_clark>(library::openmesh), settings)) {
        result.push_back(in_place(course, "no properties", [](polygons::mesh&) {}));
        result.push_back(
            in_place(course, "a double at vertices, an int on faces, a UV on half-edges", [](polygons::mesh& m) {
                auto weights = OpenMesh::getOrMakeProperty<OpenMesh::VertexHandle, double>(m, "weight");
                auto labels = OpenMesh::getOrMakeProperty<OpenMesh::FaceHandle, int>(m, "label");
                auto uvs = OpenMesh::getOrMakeProperty<OpenMesh::HalfedgeHandle, OpenMesh::Vec2d>(m, "uv");
                for (const auto v : m.vertices())
                    weights[v] = m.point(v)[0];
                for (const auto f : m.faces())
                    labels[f] = f.idx() % 7;
                for (const auto h : m.halfedges())
                    uvs[h] = {double(h.idx() % 5), double(h.idx() % 3)};
            }));
    }
    return result;
}

std::string openmesh_version()
{
    return polygons::version();
}

std::vector<contest> openmesh_contests(const course_settings& settings)
{
    std::vector<contest> result;
    add_contests<polygons, catmull_clark>(result, settings);
    add_contests<triangles, loop>(result, settings);
    add_contests<triangles, butterfly>(result, settings);
    add_contests<triangles, sqrt3>(result, settings);
    return result;
}

} // namespace kith::comparison
