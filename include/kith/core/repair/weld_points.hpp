// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/affine.hpp>
#include <kith/core/base/in_library.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <ranges>
#include <span>
#include <unordered_map>
#include <vector>

namespace kith::detail {

/// The coordinates of points as doubles, point after point.
struct point_coordinates {
    std::size_t dimension = 0;
    std::vector<double> values{};

    [[nodiscard]] std::size_t size() const { return dimension == 0 ? 0 : values.size() / dimension; }
    [[nodiscard]] std::span<const double> operator[](std::size_t point) const
    {
        return std::span(values).subspan(point * dimension, dimension);
    }
};

/// Returns a coordinate as a double; exact numbers are rounded.
template <class Number>
double as_double(const Number& x)
{
    if constexpr (requires { static_cast<double>(x); })
        return static_cast<double>(x);
    else
        return to_double(x); // to_double of CGAL
}

template <std::ranges::input_range Points>
point_coordinates coordinates_of(const Points& points)
{
    using traits = affine<std::ranges::range_value_t<Points>>;
    point_coordinates result;
    std::size_t count = 0;
    for (const auto& point : points) {
        const typename traits::sum value = traits::load(point);
        if constexpr (std::ranges::range<typename traits::sum>)
            for (const auto& x : value)
                result.values.push_back(as_double(x));
        else
            result.values.push_back(as_double(value));
        ++count;
    }
    result.dimension = count == 0 ? 0 : result.values.size() / count;
    return result;
}

/// Returns for each point the point with which it is joined, or itself. The candidates are processed in order. Each is
/// joined with the nearest point within the tolerance that stays, or the first of equally near ones; otherwise it
/// stays. So no chain of near points collapses, and a joined point lies within the tolerance of its partner. Points
/// that are not finite stay. Precondition: tolerance is 0 or more. Cost: O(points) on average, as a cell of the grid
/// holds few points that stay.
std::vector<std::size_t> joined_points(const point_coordinates& points, const std::vector<std::size_t>& candidates,
                                       double tolerance);

/// Returns the length of the diagonal of the smallest box around the finite points.
double diagonal_of(const point_coordinates& points);

#ifdef KITH_HAS_BODIES

/// A grid with the points that stay, each in the cell in which it lies. The first three coordinates choose the cell.
class point_grid {
public:
    point_grid(const point_coordinates& points, double tolerance)
        : points_(points)
        , tolerance_(tolerance)
        , axes_(std::min<std::size_t>(points.dimension, 3))
        , next_(points.size(), none)
        , order_(points.size(), none)
    {
    }

    /// Returns the nearest point within the tolerance, or `none`.
    [[nodiscard]] std::size_t nearest(std::size_t point) const
    {
        std::array<double, 3> low{}, high{};
        for (std::size_t axis = 0; axis < axes_; ++axis) {
            low[axis] = cell_of(points_[point][axis] - tolerance_);
            high[axis] = cell_of(points_[point][axis] + tolerance_);
        }
        std::size_t result = none;
        double least = 1;
        for (unsigned side = 0; side < 1U << axes_; ++side) { // a cell is four times as wide as the tolerance
            std::array<double, 3> cell = low;
            bool is_new = true;
            for (std::size_t axis = 0; axis < axes_; ++axis)
                if ((side >> axis & 1U) != 0) {
                    is_new = is_new and low[axis] != high[axis];
                    cell[axis] = high[axis];
                }
            const auto found = is_new ? first_.find(hash(cell)) : first_.end();
            for (std::size_t other = found == first_.end() ? none : found->second; other != none; other = next_[other])
                if (const double d = distance(point, other);
                    d < least or (d == least and (result == none or order_[other] < order_[result]))) {
                    least = d;
                    result = other;
                }
        }
        return result;
    }
    void add(std::size_t point)
    {
        std::array<double, 3> cell{};
        for (std::size_t axis = 0; axis < axes_; ++axis)
            cell[axis] = cell_of(points_[point][axis]);
        const auto [place, is_new] = first_.try_emplace(hash(cell), none);
        next_[point] = place->second;
        place->second = point;
        order_[point] = added_++;
    }

    static constexpr std::size_t none = std::size_t(-1);

private:
    /// Returns the cell of a coordinate. For coordinates so large that the grid has no number for their cells, it is
    /// the coordinate itself.
    [[nodiscard]] double cell_of(double x) const
    {
        const double cell = std::floor(x / (4 * tolerance_));
        return std::isfinite(cell) ? cell + 0 : x + 0; // -0 + 0 is 0
    }
    /// Returns the square of the distance in units of the tolerance. Without tolerance, it is more than 1 for different
    /// points.
    [[nodiscard]] double distance(std::size_t a, std::size_t b) const
    {
        double sum = 0;
        for (std::size_t axis = 0; axis < points_.dimension; ++axis)
            if (const double d = points_[a][axis] - points_[b][axis]; d != 0)
                sum += tolerance_ == 0 ? 2 : (d / tolerance_) * (d / tolerance_);
        return sum;
    }
    static std::uint64_t hash(const std::array<double, 3>& cell)
    {
        std::uint64_t result = 0;
        for (const double x : cell) {
            result = (result ^ std::bit_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15;
            result ^= result >> 32;
        }
        return result;
    }

    const point_coordinates& points_;
    double tolerance_;
    std::size_t axes_;
    std::size_t added_ = 0;
    std::vector<std::size_t> next_;                        ///< the next point in the same cell
    std::vector<std::size_t> order_;                       ///< the order in which points were added
    std::unordered_map<std::uint64_t, std::size_t> first_; ///< the first point by the hash of the cell
};

KITH_IN_LIBRARY std::vector<std::size_t> joined_points(const point_coordinates& points,
                                                       const std::vector<std::size_t>& candidates, double tolerance)
{
    std::vector<std::size_t> result(points.size());
    std::iota(result.begin(), result.end(), std::size_t(0));
    point_grid grid(points, tolerance);
    for (const std::size_t point : candidates) {
        if (not std::ranges::all_of(points[point], [](double x) { return std::isfinite(x); }))
            continue;
        if (const std::size_t into = grid.nearest(point); into != grid.none)
            result[point] = into;
        else
            grid.add(point);
    }
    return result;
}

KITH_IN_LIBRARY double diagonal_of(const point_coordinates& points)
{
    double sum = 0;
    for (std::size_t axis = 0; axis < points.dimension; ++axis) {
        double low = 0, high = 0;
        bool is_first = true;
        for (std::size_t i = axis; i < points.values.size(); i += points.dimension)
            if (const double x = points.values[i]; std::isfinite(x)) {
                low = is_first ? x : std::min(low, x);
                high = is_first ? x : std::max(high, x);
                is_first = false;
            }
        sum = std::hypot(sum, high - low);
    }
    return sum;
}

#endif

} // namespace kith::detail
