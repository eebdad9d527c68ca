// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "peers/opensubdiv_peer.hpp"

#include <opensubdiv/bfr/refinerSurfaceFactory.h>
#include <opensubdiv/bfr/surface.h>
#include <opensubdiv/bfr/tessellation.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace kith::comparison {

/// The triangles of a limit surface by OpenSubdiv's Bfr, with normals. Faces share the vertices on their edges.
class bfr_tessellation {
public:
    std::vector<std::array<double, 3>> points, normals;
    std::vector<std::array<int, 3>> triangles;

    /// Tessellates with `segments` segments on each edge.
    bfr_tessellation(const opensubdiv_peer::mesh& mesh, std::span<const std::array<double, 3>> control, int segments)
        : segments_(segments)
    {
        const auto& level = mesh->GetLevel(0);
        at_vertex_.assign(std::size_t(level.GetNumVertices()), none);
        on_edge_.assign(std::size_t(level.GetNumEdges()), none);
        const OpenSubdiv::Bfr::RefinerSurfaceFactory<> factory(*mesh);
        OpenSubdiv::Bfr::Surface<double> surface;
        for (int f = 0; f < level.GetNumFaces(); ++f) {
            if (not factory.InitVertexSurface(f, &surface))
                continue;
            patch_.resize(std::size_t(surface.GetNumPatchPoints()) * 3);
            surface.PreparePatchPoints(control.data()->data(), 3, patch_.data(), 3);
            add_face(level, f, surface);
        }
    }

private:
    static constexpr int none = -1;

    using surface = OpenSubdiv::Bfr::Surface<double>;

    void add_face(const OpenSubdiv::Far::TopologyLevel& level, int f, const surface& of_face)
    {
        OpenSubdiv::Bfr::Tessellation cut(of_face.GetParameterization(), segments_);
        const std::size_t on_boundary = std::size_t(cut.GetNumBoundaryCoords());
        parameters_.resize(std::size_t(cut.GetNumCoords()));
        cut.GetCoords(parameters_.data()->data());
        const auto vertices = level.GetFaceVertices(f), edges = level.GetFaceEdges(f);
        boundary_.clear();
        for (int k = 0; k < vertices.size(); ++k) {
            int& vertex = at_vertex_[std::size_t(vertices[k])];
            if (vertex == none)
                vertex = add(of_face, parameters_[boundary_.size()]);
            boundary_.push_back(vertex);
            int& first = on_edge_[std::size_t(edges[k])];
            const bool is_reversed = level.GetEdgeVertices(edges[k])[0] != vertices[k];
            if (first == none) {
                first = int(points.size());
                for (int i = 1; i < segments_; ++i)
                    add(of_face, parameters_[boundary_.size() - 1 + std::size_t(is_reversed ? segments_ - i : i)]);
            }
            for (int i = 1; i < segments_; ++i)
                boundary_.push_back(first + (is_reversed ? segments_ - i : i) - 1);
        }
        const int first_inside = int(points.size());
        for (std::size_t i = on_boundary; i < parameters_.size(); ++i)
            add(of_face, parameters_[i]);
        const std::size_t before = triangles.size();
        triangles.resize(before + std::size_t(cut.GetNumFacets()));
        int* const facets = triangles[before].data();
        cut.GetFacets(facets);
        cut.TransformFacetCoordIndices(facets, boundary_.data(), first_inside - int(on_boundary));
    }
    /// Adds a vertex and returns its number.
    int add(const surface& of_face, const std::array<double, 2>& at)
    {
        std::array<double, 3> point, du, dv;
        of_face.Evaluate(at.data(), patch_.data(), 3, point.data(), du.data(), dv.data());
        std::array<double, 3> normal{
            du[1] * dv[2] - du[2] * dv[1], du[2] * dv[0] - du[0] * dv[2], du[0] * dv[1] - du[1] * dv[0]};
        const double length = std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
        for (double& x : normal)
            x /= length;
        points.push_back(point);
        normals.push_back(normal);
        return int(points.size()) - 1;
    }

    int segments_;
    std::vector<int> at_vertex_, on_edge_, boundary_; // the first number at each, or none; of the current face
    std::vector<double> patch_;
    std::vector<std::array<double, 2>> parameters_;
};

} // namespace kith::comparison
