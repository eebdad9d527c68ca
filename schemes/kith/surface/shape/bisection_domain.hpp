// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "face_domain.hpp"

#include <kith/schemes/split/bisection_split.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <vector>

namespace kith::detail {

/// The domain of the 4-8 bisection. Each triangle is halved at its first edge. Two steps halve all edges, and split the
/// quads that pairs of triangles make into four. A face has the children of two steps. So the rings are those of these
/// quads: two rings around a quad make two around each child. Single steps leave some edges whole and would need more
/// rings each time. The box spline has different polynomials on both sides of the diagonals of these quads: cells are
/// the halves of a face.
template <>
struct face_domain<decltype(bisection_split::columns())> : domain_of_triangles {
    static constexpr bool keeps_first_corners = true;
    static constexpr bool has_polynomials_at_boundaries = false;
    static constexpr std::size_t fineness = 2;
    static constexpr int steps = 27;
    static constexpr int steps_at_once = 2;
    static constexpr int rings = 5; // of triangles, which contain two rings of quads

    static constexpr std::size_t degree = 6; ///< of the splines that are searched for
    /// Returns the faces of two rings of quads.
    template <class Cutter, std::unsigned_integral Index>
    static std::vector<Index> faces_around(Cutter& cutter, const connectivity<Index>& mesh, Index face, int)
    {
        std::vector<Index> result{face};
        add_pairs(mesh, result);
        for (int ring = 0; ring < 2; ++ring) {
            result = cutter.faces_around(result, 1);
            add_pairs(mesh, result);
        }
        return result;
    }
    static std::size_t cells(const domain_face&) { return 2; }
    static std::size_t enter(const domain_face&, std::size_t, face_parameters& at) { return halve(at); }
    static std::size_t corner_at(const domain_face&, std::size_t cell, const std::array<double, 2>& at)
    {
        if (at == corners[0])
            return cell == 0 ? 2 : 1;
        return at == corners[1] ? 2 * cell : sides;
    }
    /// Nearer to the boundary derivatives of polynomials would be rounding errors.
    static bool is_at_wall(const domain_face& face, std::size_t cell, const face_parameters& at)
    {
        constexpr double near = 0x1p-20;
        const bool is_at_half = cell == 0 ? at.s + at.t >= 1 - near : at.s <= near; // of the first side
        return (face.is_wall[0] and is_at_half) or (face.is_wall[cell == 0 ? 2 : 1] and at.t <= near);
    }
    static std::size_t children(const domain_face&) { return 2; }
    /// Returns the number of child k: children are the faces at the ends of the first edge.
    template <std::unsigned_integral Index, class Ids>
    static std::size_t child(const connectivity<Index>& mesh, const Ids& ids, const domain_face& face, std::size_t k)
    {
        return ids.faces.template id<tuple_kind::vf>(mesh.first_corner(face.number) + k);
    }
    static child_cell descend(const domain_face&, std::size_t cell, face_parameters& at)
    {
        const std::size_t half = halve(at);
        return {2 * cell + half, halve(at)};
    }

private:
    /// Returns the half in which a place lies, and replaces its parameters by those of the half.
    static std::size_t halve(face_parameters& at)
    {
        const double s = at.s, t = at.t, from_middle = 2 * s + t - 1;
        if (from_middle <= 0) {
            at.replace(-from_middle, -2, -1, 2 * s, 2, 0);
            return 0;
        }
        at.replace(t, 0, 1, std::max(2 * (1 - s - t), 0.), -2, -2);
        return 1;
    }
    /// Adds the other triangles of the quads of some triangles.
    template <std::unsigned_integral Index>
    static void add_pairs(const connectivity<Index>& mesh, std::vector<Index>& faces)
    {
        for (std::size_t i = 0, count = faces.size(); i < count; ++i)
            if (const Index across = mesh.across(Index(mesh.first_corner(faces[i]))); across != mesh.none)
                faces.push_back(Index(mesh.face_of(across)));
        std::ranges::sort(faces);
        faces.erase(std::ranges::unique(faces).begin(), faces.end());
    }
};

} // namespace kith::detail
