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

/// The search for the first point of a surface on a ray, for `best_first`. Coordinates are two across the ray, x and y,
/// and one along it. Bounds and the limit are lengths along the ray, from a point near the surface.
///
/// A patch meets the ray where x = y = 0. Balls around the Bezier points of derivatives show whether x and y have
/// nearly the same derivatives in all of the patch. Then they vanish at one place at most, which Newton's method finds.
/// Other patches are cut until they are off the ray, or too small to matter.
template <class Patch>
class ray_query {
    using vector = std::array<double, 3>;
    using values = typename Patch::values;

public:
    /// Takes a ray that begins at `from` and leads along `direction`, which has length one, up to the length
    /// `furthest`. `middle` and `radius` are those of the surface, `rounding` that of its points.
    ray_query(const vector& from, const vector& direction, double furthest, const vector& middle, double radius,
              double rounding)
        : along_(direction), rounding_(rounding), tiny_(std::max(1e-13 * radius, 8 * rounding))
    {
        const vector to_middle = vector_between(from, middle);
        ahead_ = dot(to_middle, direction);
        for (std::size_t i = 0; i < 3; ++i)
            base_[i] = from[i] + ahead_ * direction[i];
        begin_ = std::max(-ahead_, -radius);
        limit_ = std::min(furthest - ahead_, radius);
        // A vector across the ray, made from the axis that is furthest from its direction.
        const std::size_t axis = std::size_t(
            std::ranges::min_element(direction, {}, [](double x) { return std::abs(x); }) - direction.begin());
        for (std::size_t i = 0; i < 3; ++i)
            across_[i] = (i == axis ? 1 : 0) - direction[axis] * direction[i];
        const double length = length_of(across_);
        for (double& x : across_)
            x /= length;
        for (std::size_t i = 0; i < 3; ++i)
            further_across_[i] = along_[(i + 1) % 3] * across_[(i + 2) % 3] -
                                 along_[(i + 2) % 3] * across_[(i + 1) % 3];
    }

    /// Returns the place that has been found, if any.
    [[nodiscard]] const std::optional<surface_place>& place() const { return place_; }
    /// Returns the distance of that place from the begin of the ray.
    [[nodiscard]] double distance() const { return std::max(ahead_ + limit_, 0.); }

    [[nodiscard]] vector to_local(const vector& p) const
    {
        const vector off = vector_between(base_, p);
        return {dot(off, across_), dot(off, further_across_), dot(off, along_)};
    }
    [[nodiscard]] double bound_of(std::span<const vector> points) const
    {
        constexpr double none = std::numeric_limits<double>::infinity();
        const auto [least, most] = space_box::of(points);
        const bool is_off = least[0] > rounding_ or most[0] < -rounding_ or least[1] > rounding_ or
                            most[1] < -rounding_ or most[2] < begin_ - rounding_;
        return is_off ? none : std::max(least[2], begin_);
    }
    [[nodiscard]] double limit() const { return limit_; }
    [[nodiscard]] bool is_tiny(std::span<const vector> points) const
    {
        return std::ranges::all_of(points,
                                   [&](const vector& p) { return length_of(vector_between(points[0], p)) <= tiny_; });
    }
    void accept(std::span<const vector> points, const surface_place& place) { answer(points[0][2], place); }
    template <class Place>
    [[nodiscard]] std::optional<double> solve(const Patch& patch, const Place& place)
    {
        constexpr parameters middle = middle_of_cell<Patch::is_tensor>;
        const values here = patch.at(middle[0], middle[1]);
        if (is_beside(patch, here.s) or is_beside(patch, here.t))
            return {};
        if (is_nearly_linear(patch, here)) {
            find_place(patch, place, here);
            return {};
        }
        if (not is_tiny(patch.points))
            return begin_;
        answer(here.point[2], place.at(middle));
        return {};
    }

private:
    /// Returns true if the patch is on one side of the line through the ray in this direction.
    [[nodiscard]] bool is_beside(const Patch& patch, const vector& direction) const
    {
        const double length = std::hypot(direction[0], direction[1]);
        double least = std::numeric_limits<double>::infinity(), most = -least;
        for (const vector& p : patch.points) {
            const double off = direction[0] * p[1] - direction[1] * p[0];
            least = std::min(least, off);
            most = std::max(most, off);
        }
        return least > rounding_ * length or most < -rounding_ * length;
    }

    /// The derivatives of x and y by s and t, inverted.
    struct inverse {
        explicit inverse(const values& at) : s(at.s), t(at.t), determinant(s[0] * t[1] - s[1] * t[0]) {}
        [[nodiscard]] parameters times(const vector& v) const
        {
            return {(t[1] * v[0] - t[0] * v[1]) / determinant, (s[0] * v[1] - s[1] * v[0]) / determinant};
        }

        vector s, t;
        double determinant;
    };
    /// Returns true if the derivatives in the patch differ from those in the middle by a quarter at most. Newton's
    /// method then converges to the only place of a hit.
    static bool is_nearly_linear(const Patch& patch, const values& middle)
    {
        const inverse by_middle(middle);
        if (not(std::abs(by_middle.determinant) > std::numeric_limits<double>::min()))
            return false;
        double of_s = 0, of_t = 0;
        const auto note = [&](double& most, const parameters& expected) {
            return [&, expected](const vector& derivative) {
                const parameters off = add_multiple(by_middle.times(derivative), -1, expected);
                most = std::max(most, off[0] * off[0] + off[1] * off[1]);
            };
        };
        patch.template for_each_point_of_derivative<1, 0>(note(of_s, {1, 0}));
        patch.template for_each_point_of_derivative<0, 1>(note(of_t, {0, 1}));
        return of_s + of_t <= 1. / 16;
    }
    /// Finds the place at which a patch that is nearly linear meets the ray.
    template <class Place>
    void find_place(const Patch& patch, const Place& place, values here)
    {
        constexpr int most_steps = 60;
        constexpr double small_step = 1e-9; // after this step the next one is below rounding
        parameters at = middle_of_cell<Patch::is_tensor>;
        for (int step = 0; step < most_steps; ++step) {
            const parameters next = nearest_in_cell<Patch::is_tensor>(
                add_multiple(at, -1, inverse(here).times(here.point)));
            const parameters move = add_multiple(next, -1, at);
            at = next;
            here = patch.at(at[0], at[1]);
            if (std::hypot(move[0], move[1]) < small_step)
                break;
        }
        if (std::hypot(here.point[0], here.point[1]) <= 2 * rounding_)
            answer(here.point[2], place.at(at));
    }

    void answer(double length, const surface_place& place)
    {
        if (length < begin_ - rounding_ or length > limit_ or (place_ and length == limit_))
            return;
        limit_ = length;
        place_ = place;
    }

    vector base_{}, along_, across_{}, further_across_{};
    double rounding_, tiny_;
    double ahead_ = 0; // from the begin of the ray to its base
    double begin_ = 0, limit_ = 0;
    std::optional<surface_place> place_;
};

} // namespace kith::detail
