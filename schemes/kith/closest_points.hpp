// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/surface/search/best_first.hpp>
#include <kith/surface/search/closest_point_query.hpp>
#include <kith/surface/search/surface_cells.hpp>

#include <kith/core/base/error.hpp>
#include <kith/core/base/for_parts.hpp>
#include <kith/core/level/to_native.hpp>

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace kith {

/// The point of a limit surface that is nearest to a given point.
struct closest_point {
    surface_place place;
    std::array<double, 3> point;
    double distance;
};

/// A search for the nearest points of a limit surface. Each result is the nearest point of the whole surface. The
/// search skips a part of the surface only if a bound by Bezier or control points proves that none of its points is
/// nearer. The point is exact to about 1e-11 of the size of the surface, the distance to 1e-12. If several points are
/// equally near, the result is one of them.
///
/// The search takes points of three coordinates, and schemes that are splines among regular faces and have no negative
/// weights. These are Catmull-Clark, Loop and the linear schemes, with all creases; Doo-Sabin, mid-edge, 4-8 and
/// unified on closed meshes; Nasri-Hasbini on quads. One thread at a time may use an object.
template <parametric_scheme Scheme, std::unsigned_integral Index = std::uint32_t>
class closest_points {
    using vector = std::array<double, 3>;

public:
    /// Takes the limit surface of a mesh, which need not outlive this object.
    /// Errors: those of `surface_locator`; mesh_error for a mesh without faces, and for schemes that are no splines.
    /// Cost: O(corners), and that of some steps around a face for each kind of irregular face.
    template <class Point, std::same_as<Index> I>
    explicit closest_points(const basic_mesh<Point, I>& mesh, const Scheme& scheme = Scheme()) : cells_(mesh, scheme)
    {
        if (cells_.empty())
            throw mesh_error("closest_points: the mesh has no faces; give a mesh with at least one");
    }
    template <mesh M>
    explicit closest_points(const M& mesh, const Scheme& scheme = Scheme())
        : closest_points(to_native_valid(mesh), scheme)
    {
    }

    /// Returns the nearest point for each of some points. The search runs on threads; the results are the same bits for
    /// any number of threads. Errors: mesh_error for a point that is not finite, and for schemes that are no splines.
    /// Cost: for each point O(log faces) and usually a few dozen subdivisions of polynomials. It is more if many points
    /// of the surface are nearly as near as the nearest one.
    [[nodiscard]] std::vector<closest_point> of(std::span<const vector> points)
    {
        for (std::size_t q = 0; q < points.size(); ++q)
            if (not(std::isfinite(points[q][0]) and std::isfinite(points[q][1]) and std::isfinite(points[q][2])))
                throw mesh_error("point " + std::to_string(q) + " is not finite; correct it");
        std::vector<surface_place> places(points.size());
        detail::for_searches(points.size(), [&](auto&& work) {
            detail::best_first<cells> search(cells_);
            work.for_each([&](std::size_t begin, std::size_t end) {
                for (std::size_t q = begin; q < end; ++q)
                    places[q] = place_of(points[q], search);
            });
        });
        const auto found = cells_.points_at(places);
        std::vector<closest_point> result;
        for (std::size_t q = 0; q < points.size(); ++q)
            result.push_back({places[q], found[q], detail::length_of(detail::vector_between(points[q], found[q]))});
        return result;
    }

private:
    using cells = detail::surface_cells<Scheme, Index>;

    [[nodiscard]] surface_place place_of(const vector& point, detail::best_first<cells>& search) const
    {
        detail::closest_point_query<typename cells::patch> query(point, cells_.radius(), cells_.rounding());
        search.run(query);
        return query.place();
    }

    cells cells_;
};

template <mesh M, parametric_scheme Scheme>
closest_points(const M&, const Scheme&) -> closest_points<Scheme>;
template <class Point, std::unsigned_integral Index, parametric_scheme Scheme>
closest_points(const basic_mesh<Point, Index>&, const Scheme&) -> closest_points<Scheme, Index>;

} // namespace kith
