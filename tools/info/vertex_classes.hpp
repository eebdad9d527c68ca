// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <boost/iterator/function_output_iterator.hpp>
#include <boost/pending/disjoint_sets.hpp>
#include <boost/range/counting_range.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <vector>

namespace kith::tool {

using point3 = std::array<double, 3>;

inline double distance(const point3& a, const point3& b)
{
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// The points of one mesh in a tree that finds them by position.
class point_finder {
public:
    /// Builds the tree. Precondition: the points are finite, and stay where they are in memory.
    explicit point_finder(std::span<const point3> points)
        : points_(points), tree_(boost::counting_range(std::size_t(0), points.size()), {}, {points})
    {
    }

    /// Calls f with the number and the distance of each point that is not farther from `center` than `reach`.
    template <class F>
    void for_each_within(const point3& center, double reach, const F& f) const
    {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        const auto away = [&](std::size_t i, double by, double towards) {
            return std::nextafter(center[i] + by, towards);
        };
        const box around{{away(0, -reach, -infinity), away(1, -reach, -infinity), away(2, -reach, -infinity)},
                         {away(0, reach, infinity), away(1, reach, infinity), away(2, reach, infinity)}};
        tree_.query(boost::geometry::index::intersects(around),
                    boost::make_function_output_iterator([&](std::size_t found) {
                        if (const double d = distance(center, points_[found]); d <= reach)
                            f(found, d);
                    }));
    }
    /// Returns the distance to the nearest point, or infinity if there are no points.
    [[nodiscard]] double nearest_distance(const point3& center) const
    {
        double result = std::numeric_limits<double>::infinity();
        tree_.query(boost::geometry::index::nearest(spot(center[0], center[1], center[2]), 1),
                    boost::make_function_output_iterator(
                        [&](std::size_t found) { result = distance(center, points_[found]); }));
        return result;
    }

private:
    using spot = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
    using box = boost::geometry::model::box<spot>;
    struct place_of {
        using result_type = spot;
        std::span<const point3> points;
        result_type operator()(std::size_t i) const { return {points[i][0], points[i][1], points[i][2]}; }
    };

    std::span<const point3> points_;
    boost::geometry::index::rtree<std::size_t, boost::geometry::index::linear<16>, place_of> tree_;
};

/// Classes of vertices of two meshes that may be the same vertex. A vertex and one of the other mesh not farther than
/// the tolerance are in one class; chains of such pairs form larger classes. Nearly always a class is one vertex of
/// each mesh.
struct vertex_classes {
    using id = std::uint32_t;

    std::vector<id> of_a, of_b; ///< class of each vertex
    std::size_t count = 0;
    std::size_t unmatched = 0;   ///< vertices that have no partner because the other mesh has fewer in their class
    bool one_to_one = true;      ///< true if no class has two vertices of one mesh
    double largest_distance = 0; ///< largest distance from a vertex to the nearest one of the other mesh
};

/// Returns the classes of the vertices of two meshes. Errors: std::invalid_argument for a tolerance that is too large
/// to mean anything, and for too many vertices. Cost: O(n log n).
inline vertex_classes classify(std::span<const point3> a, std::span<const point3> b, double tolerance)
{
    using id = vertex_classes::id;
    if (a.size() + b.size() >= std::numeric_limits<id>::max())
        throw std::invalid_argument("the meshes have too many vertices to be compared");
    vertex_classes result;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::vector<double> from_b(b.size(), infinity);
    boost::disjoint_sets_with_storage<> sets(a.size() + b.size());
    {
        const point_finder finder(b);
        const std::size_t most_links = 64 * (a.size() + b.size()) + 1'000'000;
        std::size_t links = 0;
        for (std::size_t v = 0; v < a.size(); ++v) {
            double from_a = infinity;
            finder.for_each_within(a[v], tolerance, [&](std::size_t w, double d) {
                sets.union_set(v, a.size() + w);
                from_a = std::min(from_a, d);
                from_b[w] = std::min(from_b[w], d);
                ++links;
            });
            if (links > most_links)
                throw std::invalid_argument("the tolerance is larger than the distance between vertices of one mesh; "
                                            "choose a smaller one");
            result.largest_distance = std::max(result.largest_distance,
                                               from_a < infinity ? from_a : finder.nearest_distance(a[v]));
        }
    }
    if (std::ranges::find(from_b, infinity) != from_b.end()) {
        const point_finder finder(a);
        for (std::size_t w = 0; w < b.size(); ++w)
            if (from_b[w] == infinity)
                from_b[w] = finder.nearest_distance(b[w]);
    }
    for (const double d : from_b)
        result.largest_distance = std::max(result.largest_distance, d);

    constexpr id none = std::numeric_limits<id>::max();
    std::vector<id> class_of_root(a.size() + b.size(), none);
    std::vector<std::array<id, 2>> members; // of each mesh
    const auto enter = [&](std::size_t vertex, int mesh) {
        id& c = class_of_root[sets.find_set(vertex)];
        if (c == none) {
            c = id(members.size());
            members.push_back({0, 0});
        }
        ++members[c][mesh];
        return c;
    };
    for (std::size_t v = 0; v < a.size(); ++v)
        result.of_a.push_back(enter(v, 0));
    for (std::size_t w = 0; w < b.size(); ++w)
        result.of_b.push_back(enter(a.size() + w, 1));
    result.count = members.size();
    for (const auto& [in_a, in_b] : members) {
        result.unmatched += in_a > in_b ? in_a - in_b : in_b - in_a;
        result.one_to_one = result.one_to_one and in_a <= 1 and in_b <= 1;
    }
    return result;
}

} // namespace kith::tool
