// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "large_rings.hpp"

#include <kith/core/level/for_each.hpp>
#include <kith/core/mask/by_valence.hpp>
#include <kith/core/mask/choose.hpp>
#include <kith/numbering/association/step_context.hpp>

#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith {

/// Returns the kind of each vertex: whether an inner vertex has the regular valence; boundary vertices are of the given
/// kind.
template <level Level>
std::vector<fan_kind> fan_kinds(const Level& coarse, std::size_t regular, fan_kind at_boundary)
{
    std::vector<fan_kind> result(coarse.vertex_count());
    for_each(coarse.vertices(), [&](const auto& v) {
        const std::size_t n = v.is_boundary() ? 0 : v.valence();
        result[v.index()] = n == 0 ? at_boundary : n == regular ? fan_kind::regular : irregular_fan(n);
    });
    return result;
}

/// The weighted sums of the neighbours of irregular vertices, with weights that go around the ring. They are made by a
/// row of weights or, in a large ring, by its waves, with the weights of a wave_kernel.
template <mask_evaluator Space, weight_number Scalar>
class irregular_rings {
    using waves = ring_waves<Space, 2>;

public:
    using row_function = std::function<std::vector<double>(std::size_t)>;
    using kernel_function = wave_kernel (*)(std::size_t);

    /// Takes the weights of a ring of n neighbours: `weights(n)` as a row, and `kernel(n)` by the angle, for large
    /// rings. Cost: O(corners); the n corners of large fans cost O(n log n).
    template <step_context R>
    irregular_rings(const R& r, std::size_t regular, row_function weights, kernel_function kernel)
        : kinds_(fan_kinds(r.coarse, regular, fan_kind::regular))
        , rows_(std::move(weights))
        , kernel_(kernel)
        , large_(r.coarse, kinds_, [&r](const auto& v, std::size_t n) { return waves(r.assoc, v.neighbors(), n); })
    {
    }

    /// Returns true for an inner vertex of regular valence and for every boundary vertex.
    template <vertex_element Vertex>
    [[nodiscard]] bool is_regular(const Vertex& v) const
    {
        return kinds_[v.index()] == fan_kind::regular;
    }
    /// Returns the valence of an irregular vertex, given one of its corners.
    template <corner_element Corner>
    [[nodiscard]] std::size_t valence(const Corner& c) const
    {
        return is_large(c) ? large_.at(c).sums.operands() : c.v().valence();
    }
    /// Returns the sum around the vertex of c, which is irregular. The first weight is that of the neighbour along the
    /// edge of c. This object must outlive the sum.
    template <corner_element Corner>
    [[nodiscard]] auto sum_from_edge(const Corner& c) const
    {
        return sum_from(c, 0, [](const Corner& d) { return d; });
    }
    /// Returns the same with angles counted from the middle of the face of c. The first weight is that of the next
    /// neighbour.
    template <corner_element Corner>
    [[nodiscard]] auto sum_from_face(const Corner& c) const
    {
        return sum_from(c, 1, [](const Corner& d) { return d.prev().across(); });
    }

private:
    template <corner_element Corner>
    [[nodiscard]] bool is_large(const Corner& c) const
    {
        return kinds_[c.v().index()] == fan_kind::large;
    }
    template <corner_element Corner, class First>
    [[nodiscard]] auto sum_from(const Corner& c, int half_steps, const First& first) const
    {
        const bool by_waves = is_large(c);
        const Scalar* row = by_waves ? nullptr : rows_(c.v().valence());
        return choose(
            by_waves,
            [c, half_steps, this] {
                const auto [sums, step] = large_.at(c);
                return sums.mask(kernel_(sums.operands()), 2 * step + half_steps);
            },
            [c, row, first] { return sum(first(c).neighbors_from_here(), row); });
    }

    std::vector<fan_kind> kinds_;
    rows_by_valence<Scalar> rows_;
    kernel_function kernel_;
    large_fans<waves> large_;
};

template <step_context R, class Weights, class Kernel>
irregular_rings(const R&, std::size_t, const Weights&, const Kernel&)
    -> irregular_rings<std::remove_cvref_t<decltype(std::declval<const R&>().assoc)>, typename R::scalar>;

} // namespace kith
