// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/compiled_schemes.hpp>
#include <kith/polygon_soup.hpp>

#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/stencilTableFactory.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefiner.h>
#include <opensubdiv/far/topologyRefinerFactory.h>
#include <opensubdiv/sdc/crease.h>
#include <opensubdiv/version.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace kith::comparison {

/// A point in the form that OpenSubdiv interpolates.
template <class Real>
struct opensubdiv_point {
    std::array<Real, 3> at;

    void Clear(void* = nullptr) { at = {0, 0, 0}; }
    void AddWithWeight(const opensubdiv_point& other, Real weight)
    {
        for (std::size_t i = 0; i < 3; ++i)
            at[i] += weight * other.at[i];
    }
};

/// The points of one level. They need no initial values, since Interpolate clears them.
template <class Real>
using opensubdiv_points = std::unique_ptr<opensubdiv_point<Real>[]>;

/// Values at corners as OpenSubdiv takes them: corners with the same number share one value. Numbers begin at 0.
struct opensubdiv_corners {
    using rule = OpenSubdiv::Sdc::Options::FVarLinearInterpolation;

    std::vector<int> numbers; ///< one per corner, in the order of the corners
    int count = 0;            ///< of different numbers
    rule linear = rule::FVAR_LINEAR_ALL;
};

/// OpenSubdiv's uniform refinement, level by level, on one processor.
struct opensubdiv_peer {
    using mesh = std::unique_ptr<OpenSubdiv::Far::TopologyRefiner>;

    static std::string version()
    {
        return "OpenSubdiv " + std::to_string(OPENSUBDIV_VERSION_MAJOR) + '.' +
               std::to_string(OPENSUBDIV_VERSION_MINOR) + '.' + std::to_string(OPENSUBDIV_VERSION_PATCH);
    }

    /// Makes the unrefined mesh, with the creases and boundary corners of the scheme and, if given, values at corners.
    template <class Scheme>
    static mesh make(const basic_mesh<>& native, const Scheme& scheme, const opensubdiv_corners& corner_values = {})
    {
        namespace far = OpenSubdiv::Far;
        namespace sdc = OpenSubdiv::Sdc;
        std::vector<int> degrees, vertices;
        for (std::size_t f = 0; f < native.face_count(); ++f) {
            degrees.push_back(int(native.face(f).size()));
            vertices.insert(vertices.end(), native.face(f).begin(), native.face(f).end());
        }
        far::TopologyDescriptor description;
        description.numVertices = int(native.vertex_count());
        description.numFaces = int(native.face_count());
        description.numVertsPerFace = degrees.data();
        description.vertIndicesPerFace = vertices.data();
        std::vector<int> crease_ends, corners;
        std::vector<float> crease_sharpness, corner_sharpness;
        for (const auto& [edge, sharpness] : scheme.sharpness.edges()) {
            crease_ends.insert(crease_ends.end(), {end_of(native, 2 * edge), end_of(native, 2 * edge + 1)});
            crease_sharpness.push_back(told(sharpness));
        }
        for (const auto& [vertex, sharpness] : scheme.sharpness.vertices()) {
            corners.push_back(int(vertex));
            corner_sharpness.push_back(told(sharpness));
        }
        description.numCreases = int(crease_sharpness.size());
        description.creaseVertexIndexPairs = crease_ends.data();
        description.creaseWeights = crease_sharpness.data();
        description.numCorners = int(corners.size());
        description.cornerVertexIndices = corners.data();
        description.cornerWeights = corner_sharpness.data();
        sdc::Options options;
        options.SetCreasingMethod(scheme.sharpness.method == crease_method::uniform ? sdc::Options::CREASE_UNIFORM
                                                                                    : sdc::Options::CREASE_CHAIKIN);
        options.SetVtxBoundaryInterpolation(scheme.corners == boundary_corner::kept
                                                ? sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER
                                                : sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
        options.SetFVarLinearInterpolation(corner_values.linear);
        far::TopologyDescriptor::FVarChannel channel;
        channel.numValues = corner_values.count;
        channel.valueIndices = corner_values.numbers.data();
        description.numFVarChannels = corner_values.count == 0 ? 0 : 1;
        description.fvarChannels = &channel;
        using factory = far::TopologyRefinerFactory<far::TopologyDescriptor>;
        return mesh(factory::Create(description, factory::Options(type_of(scheme), options)));
    }

    /// Refines `levels` times. The last level has all connectivity if `full`, else its face-vertex lists only.
    static void refine(const mesh& refiner, int levels, bool full)
    {
        OpenSubdiv::Far::TopologyRefiner::UniformOptions options(levels);
        options.fullTopologyInLastLevel = full;
        refiner->RefineUniform(options);
    }

    /// Returns the points of the last level. Points of levels between are freed as soon as they have been used.
    template <class Real>
    static opensubdiv_points<Real> interpolate(const mesh& refiner, std::span<const opensubdiv_point<Real>> control)
    {
        const OpenSubdiv::Far::PrimvarRefinerReal<Real> interpolation(*refiner);
        opensubdiv_points<Real> last;
        const opensubdiv_point<Real>* coarse = control.data();
        for (int level = 1; level <= refiner->GetMaxLevel(); ++level) {
            const auto count = std::size_t(refiner->GetLevel(level).GetNumVertices());
            auto fine = std::make_unique_for_overwrite<opensubdiv_point<Real>[]>(count);
            auto* out = fine.get();
            interpolation.Interpolate(level, coarse, out);
            last = std::move(fine);
            coarse = last.get();
        }
        return last;
    }

    /// Returns the limit positions of the vertices of the last level, and two tangents at each. Precondition: the last
    /// level was refined with `full`.
    template <class Real>
    static std::array<opensubdiv_points<Real>, 3> limits(const mesh& refiner, const opensubdiv_points<Real>& points)
    {
        std::array<opensubdiv_points<Real>, 3> result;
        for (auto& of_all : result)
            of_all = std::make_unique_for_overwrite<opensubdiv_point<Real>[]>(
                std::size_t(refiner->GetLevel(refiner->GetMaxLevel()).GetNumVertices()));
        const auto* from = points.get();
        auto *positions = result[0].get(), *first = result[1].get(), *second = result[2].get();
        OpenSubdiv::Far::PrimvarRefinerReal<Real>(*refiner).Limit(from, positions, first, second);
        return result;
    }

    /// Returns the stencils of the points of the last level over the control points.
    template <class Real>
    static std::unique_ptr<const OpenSubdiv::Far::StencilTableReal<Real>> stencils(const mesh& refiner)
    {
        using factory = OpenSubdiv::Far::StencilTableFactoryReal<Real>;
        typename factory::Options options;
        options.generateIntermediateLevels = false;
        options.generateOffsets = true;
        options.maxLevel = unsigned(refiner->GetMaxLevel()) & 15U;
        return std::unique_ptr<const OpenSubdiv::Far::StencilTableReal<Real>>(factory::Create(*refiner, options));
    }

    /// Returns the points of the last level, evaluated with these stencils.
    template <class Real>
    static opensubdiv_points<Real> evaluated(const OpenSubdiv::Far::StencilTableReal<Real>& table,
                                             std::span<const opensubdiv_point<Real>> control)
    {
        auto points = std::make_unique_for_overwrite<opensubdiv_point<Real>[]>(std::size_t(table.GetNumStencils()));
        table.UpdateValues(control.data(), points.get());
        return points;
    }

    /// Returns the control points in the form that `interpolate` takes.
    template <class Real>
    static std::vector<opensubdiv_point<Real>> points_of(const basic_mesh<>& native)
    {
        std::vector<opensubdiv_point<Real>> result;
        for (const auto& [x, y, z] : native.points())
            result.push_back({{Real(x), Real(y), Real(z)}});
        return result;
    }

    static io::polygon_soup soup(const mesh& refiner, const opensubdiv_points<double>& points)
    {
        const auto& last = refiner->GetLevel(refiner->GetMaxLevel());
        io::polygon_soup result;
        for (int v = 0; v < last.GetNumVertices(); ++v)
            result.points.push_back(points[std::size_t(v)].at);
        for (int f = 0; f < last.GetNumFaces(); ++f) {
            const auto vertices = last.GetFaceVertices(f);
            result.faces.push_back(std::span(vertices.begin(), std::size_t(vertices.size())));
        }
        return result;
    }

private:
    /// Returns the vertex from which a half-edge starts.
    static int end_of(const basic_mesh<>& native, std::size_t halfedge)
    {
        return int(mesh_traits<basic_mesh<>>::source(native, {std::uint32_t(halfedge)}).value);
    }
    static float told(double sharpness)
    {
        return sharpness == infinitely_sharp ? OpenSubdiv::Sdc::Crease::SHARPNESS_INFINITE : float(sharpness);
    }
    static OpenSubdiv::Sdc::SchemeType type_of(const catmull_clark&) { return OpenSubdiv::Sdc::SCHEME_CATMARK; }
    static OpenSubdiv::Sdc::SchemeType type_of(const loop&) { return OpenSubdiv::Sdc::SCHEME_LOOP; }
};

} // namespace kith::comparison
