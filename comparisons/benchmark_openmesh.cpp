// SPDX-License-Identifier: BSD-3-Clause
#include "contests.hpp"
#include "openmesh_peer.hpp"

namespace kith::comparison {

namespace {

using polygons = openmesh_peer<OpenMesh::PolyMesh_ArrayKernelT<openmesh_doubles>>;
using triangles = openmesh_peer<OpenMesh::TriMesh_ArrayKernelT<openmesh_doubles>>;

} // namespace

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
