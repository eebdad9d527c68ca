// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "large_rings.hpp"

#include <kith/numbering/association/step_context.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith {

/// The weights of the corners of a face in the new point of one of them. They are those of a kernel by the angle from
/// that corner. The corner itself and the two next to it have an additional weight.
struct face_kernel {
    wave_kernel around;
    double own, neighbors;

    /// Returns the weight of the j-th corner of a face of degree n, counted from the corner that the point belongs to.
    [[nodiscard]] constexpr double at(std::size_t j, std::size_t n) const
    {
        return (j == 0 ? own : j == 1 or j == n - 1 ? neighbors : 0) + around.at(2 * std::int64_t(j), n);
    }
};

/// The masks with the weights of a face_kernel: rows for the degrees that occur, waves for degrees above longest_row.
template <mask_evaluator Space, weight_number Real>
class face_masks {
    using waves = ring_waves<Space, 1>;

public:
    /// Takes a step and the kernel of the weights. Cost: O(corners).
    template <step_context R>
    face_masks(const R& r, const face_kernel& kernel)
        : kernel_(kernel)
        , large_(r.coarse, [&r](const auto& f, std::size_t n) { return waves(r.assoc, f.vertices(), n); })
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
                rows_[n].push_back(Real(kernel.at(j, n)));
                others = others + rows_[n].back();
            }
            rows_[n][0] = 1 - others; // so that they sum to one exactly
        }
    }

    /// Calls use(mask) with the mask of the corner c of a face of degree n.
    template <corner_element Corner, class Use>
    void of_corner(const Corner& c, std::size_t n, const Use& use) const
    {
        if (n <= longest_row)
            return use(sum(c.vertices_from_here(), rows_[n].data()));
        const auto around = large_.of(c.f()).mask(kernel_.around, 2 * step_in_face(c));
        if (kernel_.neighbors == 0)
            use(kernel_.own * c.v() + around);
        else
            use(kernel_.own * c.v() + kernel_.neighbors * (c.prev().v() + c.next().v()) + around);
    }

private:
    face_kernel kernel_;
    std::vector<std::vector<Real>> rows_;
    large_faces<waves> large_;
};

template <step_context R>
face_masks(const R&, const face_kernel&)
    -> face_masks<std::remove_cvref_t<decltype(std::declval<const R&>().assoc)>, typename R::scalar>;

/// Returns the weights of the corners of a quad at the boundary, from c on: the tensor product of the clamped quadratic
/// B-spline. In each direction the nearer corner has the whole weight if the point is on the boundary. It has half of
/// it if the opposite side is at the boundary, else 3/4. docs/schemes.md.
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
