// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "face_domain.hpp"

#include <kith/schemes/split/sqrt3_split.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>

namespace kith::detail {

/// The domain of the sqrt(3) split. Each side of a triangle and the side across it make two triangles, each with half
/// of the side. If boundaries are cut in three, a triangle at the boundary has a child of its own in the middle.
template <>
struct face_domain<decltype(sqrt3_split::columns(0))> : domain_of_triangles {
    static constexpr std::size_t fineness = 6;
    static constexpr int steps = 34;

    /// Returns the number of children: the faces at the sides, then those across the sides.
    static std::size_t children(const domain_face&) { return 6; }
    template <std::unsigned_integral Index, class Ids>
    static std::size_t child(const connectivity<Index>& mesh, const Ids& ids, const domain_face& face, std::size_t k)
    {
        const Index corner = Index(mesh.first_corner(face.number) + k % 3);
        const Index across = k < 3 ? corner : mesh.across(corner);
        return ids.faces.template id<tuple_kind::ef>(across == mesh.none ? corner : across);
    }
    static child_cell descend(const domain_face& face, std::size_t, face_parameters& at)
    {
        const std::size_t wall = std::size_t(std::ranges::find(face.is_wall, true) - face.is_wall.begin());
        if (face.is_odd and wall < 3)
            return descend_in_cut(wall, at);
        std::size_t side = 0;
        while (not(at.t <= at.s and at.t <= 1 - at.s - at.t) and side < 2) {
            turn(at);
            ++side;
        }
        const double s = at.s, t = at.t;
        if (face.is_wall[side]) {
            at.replace(s - t, 1, -1, 3 * t, 0, 3);
            return {side, 0};
        }
        return beside(side, 1 - s - 2 * t >= s - t, at, s - t, 1, -1, 1 - s - 2 * t, -1, -2);
    }

private:
    /// Descends near a side into the triangle of its first or of its last vertex. The weights of these vertices are
    /// linear functions of s and t; the centre of the face has the rest.
    static child_cell beside(std::size_t side, bool is_near_first, face_parameters& at, double last, double last_by_s,
                             double last_by_t, double first, double first_by_s, double first_by_t)
    {
        if (is_near_first) { // of the vertex, the centre across and the centre
            at.replace(last, last_by_s, last_by_t, 1 - first, -first_by_s, -first_by_t);
            return {side, 0};
        }
        at.replace(1 - last, -last_by_s, -last_by_t, first, first_by_s, first_by_t);
        return {3 + side, 0};
    }
    /// Descends in a triangle with points at the thirds of one side, which replace the centre.
    static child_cell descend_in_cut(std::size_t wall, face_parameters& at)
    {
        for (std::size_t side = 0; side < wall; ++side)
            turn(at);
        const double s = at.s, t = at.t, r = std::max(1 - s - t, 0.);
        if (2 * s < r)
            return beside((wall + 2) % 3, t >= r - 2 * s, at, 1 - 3 * s - t, -3, -1, t, 0, 1);
        if (2 * r < s)
            return beside((wall + 1) % 3, s - 2 * r >= t, at, t, 0, 1, 3 * s + 2 * t - 2, 3, 2);
        at.replace(3 * s + t - 1, 3, 1, t, 0, 1);
        return {wall, 0};
    }
};

} // namespace kith::detail
