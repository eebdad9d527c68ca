// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "linear.hpp"

#include <kith/core/base/error.hpp>
#include <kith/fields/field.hpp>
#include <kith/schemes/seam/varied_level.hpp>
#include <kith/schemes/split/quad_triangle_split.hpp>

#include <concepts>
#include <cstddef>
#include <span>
#include <string>
#include <type_traits>
#include <utility>

namespace kith {

namespace detail {

template <class Scheme>
concept is_linear = std::derived_from<Scheme, linear> or std::derived_from<Scheme, linear_triangles>;

/// Requirements of a scheme with rules for the seams of values at corners: each new face lies in an old one, and points
/// follow sharp_rules.
template <class Scheme>
concept has_seam_rules = scheme_with_sharp_rules<Scheme> and requires(const Scheme& scheme) {
    requires std::same_as<decltype(columns_of(scheme, 0)), decltype(quad_split::columns())> or
                 std::same_as<decltype(columns_of(scheme, 0)), decltype(triangle_split::columns())> or
                 std::same_as<decltype(columns_of(scheme, 0)), decltype(quad_triangle_split::columns())>;
};

} // namespace detail

/// The rule of values at corners that are as smooth as the surface between their seams: on_corners(uv,
/// face_varying{linear}). It is for schemes with creases. A seam is an edge whose two faces have different
/// values at one of its ends. Seams are found once, in the first step, by ==. `linear` says where values stay
/// linear at seams. face_varying_linear::all is linear_in_faces and goes with any scheme; for the linear schemes every
/// choice is. At all corners of one new vertex between the same seams the values have the same bits. Source:
/// OpenSubdiv's face-varying interpolation, DeRose, Kass & Truong 1998, section 4; docs/schemes.md. Errors: mesh_error
/// for another scheme. Cost: that of the step without its connectivity, O(corners).
struct face_varying {
    using mark_type = corner_mark;

    face_varying_linear linear = face_varying_linear::corners_plus1;

    /// Returns true if the rule is that of linear_in_faces with every scheme.
    [[nodiscard]] bool is_linear_in_faces() const { return linear == face_varying_linear::all; }

    template <affine_value T, finished_step Step>
        requires std::equality_comparable<T>
    [[nodiscard]] std::pair<storage<T>, storage<corner_mark>>
    after(std::span<const T> values, std::span<const corner_mark> marks, const Step& step) const
    {
        using scheme_type = std::remove_cvref_t<decltype(step.scheme)>;
        if (linear == face_varying_linear::all or detail::is_linear<scheme_type>)
            return {linear_in_faces{}.after(values, step), {}};
        if constexpr (detail::has_seam_rules<scheme_type>) {
            if (not marks.empty())
                return next(values, marks, step);
            const auto found = seam_finder(step.coarse, values, step.scheme.sharpness, step.scheme.corners, linear)
                                   .find();
            return next(values, {found.data(), found.size()}, step);
        }
        throw mesh_error("values at corners go along seams with schemes that have creases, and not with " +
                         std::string(scheme_name<scheme_type>()) + "; take face_varying_linear::all");
    }

private:
    template <class T, finished_step Step>
    std::pair<storage<T>, storage<corner_mark>> next(std::span<const T> values, std::span<const corner_mark> marks,
                                                     const Step& step) const
    {
        const auto fine = step.fine();
        const varied_level<T, Step> varied(step, values, marks, linear);
        storage<T> result(fine.corner_count());
        storage<corner_mark> next_marks(fine.corner_count());
        detail::for_new_corners(fine, step.ids, [&](const auto& c, const auto& face) {
            const std::size_t v = c.v().index();
            const auto vertex = step.ids.vertices.origin(v);
            const auto [value, rule] = varied.at(face, vertex, v);
            result[c.index()] = value;
            next_marks[c.index()] = {rule,
                                     varied.is_seam(face, vertex, step.ids.vertices.origin(c.next().v().index()))};
        });
        return {std::move(result), std::move(next_marks)};
    }
};

} // namespace kith
