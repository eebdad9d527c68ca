// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "user_mesh.hpp"

#include <kith/openmesh.hpp>

#include <OpenMesh/Tools/Utils/MeshCheckerT.hh>

#include <concepts>
#include <sstream>
#include <stdexcept>
#include <string>

/// The traits that most users of OpenMesh write: coordinates of type double, and marks for deleted elements.
struct double_traits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
    VertexAttributes(OpenMesh::Attributes::Status);
    EdgeAttributes(OpenMesh::Attributes::Status);
    FaceAttributes(OpenMesh::Attributes::Status);
};
using poly_mesh = OpenMesh::PolyMesh_ArrayKernelT<double_traits>;
using tri_mesh = OpenMesh::TriMesh_ArrayKernelT<double_traits>;
using poly_mesh_float = OpenMesh::PolyMesh_ArrayKernelT<>;

template <std::derived_from<OpenMesh::PolyConnectivity> M>
struct user_mesh<M> {
    using scalar = typename M::Scalar;
    static constexpr bool triangles_only = std::derived_from<M, OpenMesh::TriConnectivity>;
    static constexpr double tolerance = std::same_as<scalar, float> ? 1e-6 : 1e-13;

    static M make(const std::vector<std::array<double, 3>>& points, const std::vector<std::vector<std::size_t>>& faces)
    {
        M result;
        for (const auto& [x, y, z] : points)
            result.add_vertex(typename M::Point(scalar(x), scalar(y), scalar(z)));
        for (const auto& face : faces) {
            std::vector<OpenMesh::VertexHandle> corners;
            for (const std::size_t v : face)
                corners.emplace_back(int(v));
            if (not result.add_face(corners).is_valid())
                throw std::logic_error("OpenMesh does not take this face");
        }
        return result;
    }
    static std::string complaints(const M& m)
    {
        std::ostringstream out;
        auto copy = m; // the checker of OpenMesh takes no const mesh
        OpenMesh::Utils::MeshCheckerT<M>(copy).check(OpenMesh::Utils::MeshCheckerT<M>::CHECK_ALL, out);
        return out.str();
    }
};
