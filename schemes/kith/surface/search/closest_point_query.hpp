// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bezier_patch.hpp"
#include "box_tree.hpp"
#include "cell_place.hpp"

#include <kith/limits/limit_sides.hpp>
#include <kith/limits/unit_normal.hpp>
#include <kith/surface/surface_place.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>

namespace kith::detail {

/// The search for the point of a surface that is nearest to a given point, for `best_first`. Coordinates are relative
/// to the given point. Bounds and the limit are squares of distances.
///
/// Half the square of the distance is a function f of the parameters of a patch. Its value, slope and second
/// derivatives in the middle, and balls around the Bezier points of all derivatives, bound f from below (Taylor's
/// theorem). Where they prove that f is convex, Newton's method finds the only minimum. Other patches are cut.
template <class Patch>
class closest_point_query {
    using vector = std::array<double, 3>;
    using values = typename Patch::values;

public:
    /// Takes the given point. `radius` is that of the surface, `rounding` that of its points.
    closest_point_query(const vector& point, double radius, double rounding)
        : point_(point)
        , rounding_(rounding + 1e-15 * std::max({std::abs(point[0]), std::abs(point[1]), std::abs(point[2])}))
        , tiny_(std::max(1e-13 * radius, 8 * rounding_))
    {
    }
    [[nodiscard]] surface_place place() const { return place_; }

    [[nodiscard]] vector to_local(const vector& p) const { return vector_between(point_, p); }
    [[nodiscard]] double bound_of(std::span<const vector> points) const
    {
        const auto [least, most] = space_box::of(points);
        double result = 0;
        for (std::size_t x = 0; x < 3; ++x) {
            const double off = std::max({least[x], -most[x], 0.});
            result += off * off;
        }
        return result;
    }
    [[nodiscard]] double limit() const { return limit_; }
    [[nodiscard]] bool is_tiny(std::span<const vector> points) const
    {
        return std::ranges::all_of(points,
                                   [&](const vector& p) { return length_of(vector_between(points[0], p)) <= tiny_; });
    }
    void accept(std::span<const vector> points, const surface_place& place)
    {
        answer(dot(points[0], points[0]), place);
    }
    template <class Place>
    [[nodiscard]] std::optional<double> solve(const Patch& patch, const Place& place)
    {
        constexpr parameters middle = middle_of_cell<Patch::is_tensor>;
        const values here = patch.at(middle[0], middle[1]);
        const double square = dot(here.point, here.point);
        double best = square, least = std::numeric_limits<double>::infinity(), furthest = 0;
        parameters place_of_best = middle;
        for (const parameters& corner : corners_of_cell<Patch::is_tensor>) {
            const parameters move = add_multiple(corner, -1, middle);
            least = std::min(least, move[0] * dot(here.s, here.point) + move[1] * dot(here.t, here.point));
            furthest = std::max(furthest, move[0] * move[0] + move[1] * move[1]);
            const vector& there = patch.at_corner(corner[0] != 0, corner[1] != 0);
            if (const double square_there = dot(there, there); square_there < best) {
                best = square_there;
                place_of_best = corner;
            }
        }
        limit_to(best);
        const double curvature = least_curvature(patch, here);
        const double bound = std::max(square + 2 * least + std::min(curvature, 0.) * furthest, bound_of(patch.points));
        if (bound > limit_)
            return {};
        if (curvature > 0) {
            minimise(patch, place, here);
            return {};
        }
        if (std::sqrt(best) - std::sqrt(bound) > tiny_)
            return bound;
        answer(best, place.at(place_of_best));
        return {};
    }

private:
    /// The second derivatives of f, by s, by s and t, by t.
    using matrix = std::array<double, 3>;

    static matrix second_derivatives(const values& at)
    {
        return {dot(at.s, at.s) + dot(at.point, at.ss),
                dot(at.s, at.t) + dot(at.point, at.st),
                dot(at.t, at.t) + dot(at.point, at.tt)};
    }
    /// Returns a bound from below for the second derivatives of f in a patch, in all directions.
    static double least_curvature(const Patch& patch, const values& middle)
    {
        const auto radius = [](const vector& centre, double& result) {
            return [&](const vector& p) {
                const vector off = vector_between(centre, p);
                result = std::max(result, dot(off, off));
            };
        };
        double r = 0, r_s = 0, r_t = 0, r_ss = 0, r_st = 0, r_tt = 0;
        patch.template for_each_point_of_derivative<0, 0>(radius(middle.point, r));
        patch.template for_each_point_of_derivative<1, 0>(radius(middle.s, r_s));
        patch.template for_each_point_of_derivative<0, 1>(radius(middle.t, r_t));
        patch.template for_each_point_of_derivative<2, 0>(radius(middle.ss, r_ss));
        patch.template for_each_point_of_derivative<1, 1>(radius(middle.st, r_st));
        patch.template for_each_point_of_derivative<0, 2>(radius(middle.tt, r_tt));
        for (double* x : {&r, &r_s, &r_t, &r_ss, &r_st, &r_tt})
            *x = std::sqrt(*x);
        // The largest distance of products of vectors from those in the middle.
        const auto off = [](const vector& a, double r_a, const vector& b, double r_b) {
            return length_of(a) * r_b + length_of(b) * r_a + r_a * r_b;
        };
        const auto [ss, st, tt] = second_derivatives(middle);
        const double a = ss - off(middle.s, r_s, middle.s, r_s) - off(middle.point, r, middle.ss, r_ss);
        const double c = tt - off(middle.t, r_t, middle.t, r_t) - off(middle.point, r, middle.tt, r_tt);
        const double b = std::abs(st) + off(middle.s, r_s, middle.t, r_t) + off(middle.point, r, middle.st, r_st);
        return (a + c) / 2 - std::hypot((a - c) / 2, b);
    }

    /// Finds the minimum of f in a patch, in which f is convex.
    template <class Place>
    void minimise(const Patch& patch, const Place& place, values here)
    {
        constexpr int most_steps = 60;
        constexpr double small_step = 1e-9; // after this step the next one is below rounding
        parameters at = middle_of_cell<Patch::is_tensor>;
        double square = dot(here.point, here.point);
        for (int step = 0; step < most_steps; ++step) {
            parameters move = add_multiple(minimum_of_model(at, here), -1, at);
            const double size = std::hypot(move[0], move[1]);
            for (int halving = 0;; ++halving) {
                const parameters next = add_multiple(at, 1, move);
                const values there = patch.at(next[0], next[1]);
                const double next_square = dot(there.point, there.point);
                if (next_square <= square + 4 * std::sqrt(square) * rounding_ or halving == 30) {
                    at = next;
                    here = there;
                    square = next_square;
                    break;
                }
                move = add_multiple({0, 0}, .5, move);
            }
            if (size < small_step)
                break;
        }
        answer(square, place.at(at));
    }
    /// Returns the place in the cell at which the quadratic polynomial that agrees with f up to second derivatives is
    /// least.
    static parameters minimum_of_model(const parameters& at, const values& here)
    {
        const auto [ss, st, tt] = second_derivatives(here);
        const parameters slope{dot(here.s, here.point), dot(here.t, here.point)};
        const double determinant = ss * tt - st * st;
        const parameters inside{at[0] + (slope[1] * st - slope[0] * tt) / determinant,
                                at[1] + (slope[0] * st - slope[1] * ss) / determinant};
        if (inside[0] >= 0 and inside[1] >= 0 and
            (Patch::is_tensor ? inside[0] <= 1 and inside[1] <= 1 : inside[0] + inside[1] <= 1))
            return inside;
        const auto product = [&](const parameters& x, const parameters& y) {
            return x[0] * (ss * y[0] + st * y[1]) + x[1] * (st * y[0] + tt * y[1]);
        };
        constexpr auto corners = corners_of_cell<Patch::is_tensor>;
        parameters best = at;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const parameters edge = add_multiple(corners[(k + 1) % corners.size()], -1, corners[k]);
            const parameters begin = add_multiple(corners[k], -1, at);
            const double slope_along = slope[0] * edge[0] + slope[1] * edge[1] + product(begin, edge);
            const double x = std::clamp(-slope_along / product(edge, edge), 0., 1.);
            const parameters move = add_multiple(begin, x, edge);
            const double value = slope[0] * move[0] + slope[1] * move[1] + product(move, move) / 2;
            if (value < least) {
                least = value;
                best = add_multiple(corners[k], x, edge);
            }
        }
        return best;
    }

    /// Lowers the limit to this distance, at which there is a point.
    void limit_to(double square)
    {
        const double distance = std::sqrt(square) + rounding_;
        limit_ = std::min(limit_, distance * distance);
    }
    void answer(double square, const surface_place& place)
    {
        limit_to(square);
        if (square < best_) {
            best_ = square;
            place_ = place;
        }
    }

    vector point_;
    double rounding_, tiny_;
    double limit_ = std::numeric_limits<double>::infinity(), best_ = limit_;
    surface_place place_;
};

} // namespace kith::detail
