// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "large_rings.hpp"

#include <kith/association/running_step.hpp>

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith {

/// Weights around faces, for rules that make a point of each corner of a face: rows for the degrees that occur, waves
/// for larger ones.
template <mask_evaluator Space, weight_number Real>
class face_masks {
    using waves = ring_waves<Space, 1>;

public:
    /// weight(j, n): of the j-th corner of a face of degree n, counted from the one that the point belongs to.
    /// Cost: O(corners).
    template <running_step R, class Weight>
    face_masks(const R& r, const Weight& weight)
        : large_(r.coarse, [&r](const auto& f, std::size_t n) { return waves(r.assoc, f.vertices(), n); })
    {
        for (const auto f : r.coarse.faces()) {
            const std::size_t n = f.degree();
            if (n > longest_row or (n < rows_.size() and not rows_[n].empty()))
                continue;
            if (n >= rows_.size())
                rows_.resize(n + 1);
            Real others(0);
            rows_[n].push_back(others);
            for (std::size_t j = 1; j < n; ++j) {
                rows_[n].push_back(Real(weight(j, n)));
                others = others + rows_[n].back();
            }
            rows_[n][0] = 1 - others; // so that they sum to one exactly
        }
    }

    /// Calls use(mask) with the mask of the corner c of a face of degree n. Of a large face in_large(sum_by, use) does
    /// so, with the same weights by what they have in common: sum_by(kernel) is the sum around the face from c on.
    template <corner_element Corner, class InLarge, class Use>
    void of_corner(const Corner& c, std::size_t n, const InLarge& in_large, const Use& use) const
    {
        if (n <= longest_row)
            use(sum(c.vertices_from_here(), rows_[n].data()));
        else
            in_large([&](const wave_kernel& kernel) { return large_.of(c.f()).mask(kernel, 2 * step_in_face(c)); },
                     use);
    }

private:
    std::vector<std::vector<Real>> rows_;
    large_faces<waves> large_;
};

template <running_step R, class Weight>
face_masks(const R&, const Weight&)
    -> face_masks<std::remove_cvref_t<decltype(std::declval<const R&>().assoc)>, typename R::scalar>;

/// The weights of the corners of a quad at the boundary, from c on: the tensor product of the clamped quadratic
/// B-spline, in each direction all of the weight for a point on the boundary, half of it beside a boundary, else 3/4.
/// docs/schemes.md.
template <class Real, corner_element Corner>
std::array<Real, 4> clamped_quad_weights(const Corner& c)
{
    const auto d = c.next().next();
    const auto towards = [](bool on, bool beside) { return on ? Real(1) : beside ? Real(1) / 2 : Real(3) / 4; };
    const Real a = towards(c.prev().is_boundary(), c.next().is_boundary());
    const Real b = towards(c.is_boundary(), d.is_boundary());
    return {a * b, (1 - a) * b, (1 - a) * (1 - b), a * (1 - b)};
}

} // namespace kith
