// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "opensubdiv_peer.hpp"

#include <kith/surface.hpp>

#include <opensubdiv/far/patchMap.h>
#include <opensubdiv/far/patchTable.h>
#include <opensubdiv/far/patchTableFactory.h>
#include <opensubdiv/far/ptexIndices.h>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace kith::comparison {

/// The limit surface of a mesh by the patch tables of OpenSubdiv's Far. Gregory patches approximate irregular patches,
/// which is Far's default.
class far_peer {
public:
    /// Refines a mesh adaptively, up to `level` at irregular vertices and creases. The mesh must outlive this object.
    far_peer(const opensubdiv_peer::mesh& mesh, std::span<const std::array<double, 3>> control, int level)
        : mesh_(*mesh), faces_(*mesh)
    {
        OpenSubdiv::Far::PatchTableFactory::Options options{unsigned(level)};
        options.SetPatchPrecision<double>();
        options.generateVaryingTables = false;
        options.useInfSharpPatch = true;
        mesh->RefineAdaptive(options.GetRefineAdaptiveOptions());
        table_.reset(OpenSubdiv::Far::PatchTableFactory::Create(*mesh, options));
        map_.emplace(*table_);
        refined_ = std::size_t(mesh->GetNumVerticesTotal());
        points_.resize(refined_ + std::size_t(table_->GetNumLocalPoints()));
        move(control);
    }

    /// Computes the points of all patches for other control points.
    void move(std::span<const std::array<double, 3>> control)
    {
        for (std::size_t v = 0; v < control.size(); ++v)
            points_[v].at = control[v];
        const OpenSubdiv::Far::PrimvarRefinerReal<double> interpolation(mesh_);
        auto* coarse = points_.data();
        for (int level = 1; level <= mesh_.GetMaxLevel(); ++level) {
            auto* fine = coarse + mesh_.GetLevel(level - 1).GetNumVertices();
            interpolation.Interpolate(level, coarse, fine);
            coarse = fine;
        }
        if (const auto* local = table_->GetLocalPointStencilTable<double>(); local != nullptr)
            local->UpdateValues(points_.data(), points_.data() + refined_);
    }

    /// Evaluates the point at a place and, if there are three outputs, its first derivatives.
    template <std::size_t Outputs>
    void evaluate(const surface_place& place, std::array<std::array<double, 3>, Outputs>& to) const
    {
        static_assert(Outputs == 1 or Outputs == 3);
        constexpr std::size_t most_points = 20; // of a Gregory patch
        std::array<std::array<double, most_points>, Outputs> weights;
        const auto& patch = *map_->FindPatch(faces_.GetFaceId(int(place.face)) + int(place.corner), place.u, place.v);
        if constexpr (Outputs == 1)
            table_->EvaluateBasis(patch, place.u, place.v, weights[0].data());
        else
            table_->EvaluateBasis(patch, place.u, place.v, weights[0].data(), weights[1].data(), weights[2].data());
        const auto vertices = table_->GetPatchVertices(patch);
        to = {};
        for (int i = 0; i < vertices.size(); ++i) {
            const auto& point = points_[std::size_t(vertices[i])].at;
            for (std::size_t k = 0; k < Outputs; ++k)
                for (std::size_t axis = 0; axis < 3; ++axis)
                    to[k][axis] += weights[k][std::size_t(i)] * point[axis];
        }
    }

private:
    const OpenSubdiv::Far::TopologyRefiner& mesh_;
    OpenSubdiv::Far::PtexIndices faces_;
    std::unique_ptr<const OpenSubdiv::Far::PatchTable> table_;
    std::optional<OpenSubdiv::Far::PatchMap> map_;
    std::size_t refined_ = 0; // number of refined points; points of patches follow them
    std::vector<opensubdiv_point<double>> points_;
};

} // namespace kith::comparison
