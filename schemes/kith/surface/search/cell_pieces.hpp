// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cell_place.hpp"

#include <kith/surface/shape/face_domain.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace kith::detail {

/// A cell within parameters that are cut into cells: the image of the unit square, or of the triangle (0, 0), (1, 0),
/// (0, 1), under an affine map.
struct cell_piece {
    child_cell of;
    parameters origin, along_s, along_t;
};

/// Returns true if a piece lies within the square or triangle that was cut: sub-faces may share a child.
inline bool lies_within(const cell_piece& piece, bool is_quad)
{
    constexpr double rounding = 1e-9;
    const auto is_inside = [&](const parameters& x) {
        return x[0] >= -rounding and x[1] >= -rounding and
               (is_quad ? std::max(x[0], x[1]) <= 1 + rounding : x[0] + x[1] <= 1 + rounding);
    };
    const parameters at_s = add_multiple(piece.origin, 1, piece.along_s);
    return is_inside(piece.origin) and is_inside(at_s) and is_inside(add_multiple(piece.origin, 1, piece.along_t)) and
           (not is_quad or is_inside(add_multiple(at_s, 1, piece.along_t)));
}

/// Returns points in all pieces into which a domain of this fineness cuts a square or a triangle.
inline std::vector<parameters> points_in_pieces(std::size_t fineness, bool is_quad)
{
    const std::size_t segments = is_quad ? fineness : 2 * fineness;
    const double n = double(segments);
    std::vector<parameters> result;
    for (std::size_t i = 0; i < segments; ++i)
        for (std::size_t j = 0; j < (is_quad ? segments : segments - i); ++j) {
            result.push_back({(double(i) + .25) / n, (double(j) + .5) / n});
            if (is_quad or i + j + 1 < segments)
                result.push_back({(double(i) + .75) / n, (double(j) + .5) / n});
        }
    return result;
}

/// Returns the pieces into which cut(face_parameters&) cuts a square or a triangle; `samples` are points in all pieces.
/// `cut` returns the child_cell of a place and replaces the parameters by those in the cell.
template <class Cut>
std::vector<cell_piece> pieces_of(std::span<const parameters> samples, const Cut& cut)
{
    std::vector<cell_piece> result;
    for (const parameters& sample : samples) {
        face_parameters at{sample[0], sample[1]};
        const child_cell of = cut(at);
        if (std::ranges::any_of(result, [&](const cell_piece& known) {
                return known.of.child == of.child and known.of.cell == of.cell;
            }))
            continue;
        const double determinant = at.s_u * at.t_v - at.s_v * at.t_u;
        const parameters along_s{at.t_v / determinant, -at.t_u / determinant},
            along_t{-at.s_v / determinant, at.s_u / determinant};
        result.push_back({of, add_multiple(add_multiple(sample, -at.s, along_s), -at.t, along_t), along_s, along_t});
    }
    return result;
}

} // namespace kith::detail
