// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/surface/search/best_first.hpp>
#include <kith/surface/search/ray_query.hpp>
#include <kith/surface/search/surface_cells.hpp>

#include <kith/core/base/error.hpp>
#include <kith/core/level/to_native.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace kith {

/// The points origin + t * direction, for t from 0 to `furthest`.
struct surface_ray {
    std::array<double, 3> origin, direction; ///< the direction may have any length but zero
    double furthest = std::numeric_limits<double>::infinity();
};
/// The first point of a ray that lies on a limit surface.
struct ray_hit {
    surface_place place;
    std::array<double, 3> point;
    double distance; ///< t of the ray, in lengths of its direction
};

/// A search for the first hits of rays on a limit surface, from either side. Each result is the first hit. The search
/// skips a part of the surface only if Bezier or control points prove that the ray misses it or hits another part
/// before. No ray passes between two faces. A hit is exact to about 1e-12 of the size of the surface if the ray crosses
/// the surface. If a ray only touches it, hits and misses by less than that are not distinguished.
///
/// The search takes points of three coordinates, and schemes that are splines among regular faces and have no negative
/// weights. These are Catmull-Clark, Loop and the linear schemes, with all creases; Doo-Sabin, mid-edge, 4-8 and
/// unified on closed meshes; Nasri-Hasbini on quads. One thread at a time may use an object.
template <parametric_scheme Scheme, std::unsigned_integral Index = std::uint32_t>
class ray_hits {
public:
    /// Takes the limit surface of a mesh, which need not outlive this object.
    /// Errors: those of `surface_locator`; mesh_error for schemes that are no splines.
    /// Cost: O(corners), and that of some steps around a face for each kind of irregular face.
    template <class Point, std::same_as<Index> I>
    explicit ray_hits(const basic_mesh<Point, I>& mesh, const Scheme& scheme = Scheme()) : cells_(mesh, scheme)
    {
    }
    template <mesh M>
    explicit ray_hits(const M& mesh, const Scheme& scheme = Scheme()) : ray_hits(to_native_valid(mesh), scheme)
    {
    }

    /// Returns the first hit of each ray, or nothing for a ray that misses the surface. A hit at the origin counts. The
    /// search runs on threads; the results are the same bits for any number of threads. Errors: mesh_error for a ray
    /// with numbers that are not finite, without direction or with a negative length, and for schemes that are no
    /// splines. Cost: for each ray O(log faces + faces whose boxes it meets) and usually a few dozen subdivisions of
    /// polynomials.
    [[nodiscard]] std::vector<std::optional<ray_hit>> of(std::span<const surface_ray> rays)
    {
        for (std::size_t i = 0; i < rays.size(); ++i)
            require_ray(rays[i], i);
        std::vector<std::optional<ray_hit>> result(rays.size());
        detail::for_searches(rays.size(), [&](auto&& work) {
            detail::best_first<cells> search(cells_);
            work.for_each([&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i)
                    result[i] = first_hit(rays[i], search);
            });
        });
        std::vector<surface_place> places;
        for (const auto& hit : result)
            if (hit)
                places.push_back(hit->place);
        const auto points = cells_.points_at(places);
        std::size_t next = 0;
        for (auto& hit : result)
            if (hit)
                hit->point = points[next++];
        return result;
    }

private:
    using cells = detail::surface_cells<Scheme, Index>;

    /// Returns a length. Squares of the coordinates neither overflow nor vanish.
    static double length_of(const std::array<double, 3>& v) { return std::hypot(v[0], v[1], v[2]); }
    static void require_ray(const surface_ray& ray, std::size_t number)
    {
        const auto are_finite = [](const auto& v) {
            return std::ranges::all_of(v, [](double x) { return std::isfinite(x); });
        };
        const auto refuse = [&](const char* problem) { throw mesh_error("ray " + std::to_string(number) + problem); };
        if (not are_finite(ray.origin) or not are_finite(ray.direction))
            refuse(" is not finite; correct its origin or direction");
        if (not std::isnormal(length_of(ray.direction)))
            refuse(" has no direction; give one that is not zero");
        if (not(ray.furthest >= 0))
            refuse(" has a negative length; give 0 or more");
    }
    [[nodiscard]] std::optional<ray_hit> first_hit(const surface_ray& ray, detail::best_first<cells>& search) const
    {
        const double length = length_of(ray.direction);
        const std::array<double, 3> direction{
            ray.direction[0] / length, ray.direction[1] / length, ray.direction[2] / length};
        detail::ray_query<typename cells::patch> query(
            ray.origin, direction, ray.furthest * length, cells_.middle(), cells_.radius(), cells_.rounding());
        search.run(query);
        if (not query.place())
            return {};
        return ray_hit{*query.place(), {}, query.distance() / length};
    }

    cells cells_;
};

template <mesh M, parametric_scheme Scheme>
ray_hits(const M&, const Scheme&) -> ray_hits<Scheme>;
template <class Point, std::unsigned_integral Index, parametric_scheme Scheme>
ray_hits(const basic_mesh<Point, Index>&, const Scheme&) -> ray_hits<Scheme, Index>;

} // namespace kith
