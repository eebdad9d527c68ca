// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "opensubdiv_peer.hpp"

#include <kith/surface.hpp>

#include <opensubdiv/bfr/refinerSurfaceFactory.h>
#include <opensubdiv/bfr/surface.h>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace kith::comparison {

/// The limit surfaces of all faces of a mesh by OpenSubdiv's Bfr, with their patch points.
class bfr_peer {
public:
    using surface = OpenSubdiv::Bfr::Surface<double>;

    /// A point and its derivatives in Bfr's order: P, Du, Dv, Duu, Duv, Dvv.
    using values = std::array<std::array<double, 3>, 6>;

    /// Makes the surfaces. Bfr refines up to level `smooth` at irregular vertices and up to level `sharp` at creases;
    /// its own defaults are 2 and 6. The mesh must outlive this object.
    bfr_peer(const opensubdiv_peer::mesh& mesh, std::span<const std::array<double, 3>> control, int smooth = 2,
             int sharp = 6)
        : surfaces_(std::size_t(mesh->GetLevel(0).GetNumFaces())), points_(surfaces_.size())
    {
        OpenSubdiv::Bfr::RefinerSurfaceFactory<>::Options options;
        options.SetApproxLevelSmooth(smooth).SetApproxLevelSharp(sharp);
        const OpenSubdiv::Bfr::RefinerSurfaceFactory<> factory(*mesh, options);
        for (std::size_t f = 0; f < surfaces_.size(); ++f) {
            if (not factory.InitVertexSurface(int(f), &surfaces_[f]))
                continue;
            points_[f].resize(std::size_t(surfaces_[f].GetNumPatchPoints()) * 3);
        }
        move(control);
    }

    /// Computes the patch points for other control points.
    void move(std::span<const std::array<double, 3>> control)
    {
        for (std::size_t f = 0; f < surfaces_.size(); ++f)
            if (surfaces_[f].IsValid())
                surfaces_[f].PreparePatchPoints(control.data()->data(), 3, points_[f].data(), 3);
    }

    [[nodiscard]] const surface& of_face(std::size_t face) const { return surfaces_[face]; }

    /// Returns the parameters of a place in Bfr's parameterization.
    [[nodiscard]] std::array<double, 2> parameters(const surface_place& place) const
    {
        const auto parameterization = surfaces_[place.face].GetParameterization();
        const std::array<double, 2> here{place.u, place.v};
        if (not parameterization.HasSubFaces())
            return here;
        std::array<double, 2> result{};
        parameterization.ConvertNormalizedSubFaceToCoord(int(place.corner), here.data(), result.data());
        return result;
    }
    /// Evaluates the point and, if there are 3 or 6 outputs, its first or its first and second derivatives.
    template <std::size_t Outputs>
    void evaluate(std::size_t face, const std::array<double, 2>& at,
                  std::array<std::array<double, 3>, Outputs>& to) const
    {
        const double* const points = points_[face].data();
        const auto evaluate_into = [&](auto... k) { surfaces_[face].Evaluate(at.data(), points, 3, to[k].data()...); };
        if constexpr (Outputs == 1)
            evaluate_into(0U);
        else if constexpr (Outputs == 3)
            evaluate_into(0U, 1U, 2U);
        else
            evaluate_into(0U, 1U, 2U, 3U, 4U, 5U);
    }

private:
    std::vector<surface> surfaces_;
    std::vector<std::vector<double>> points_;
};

} // namespace kith::comparison
