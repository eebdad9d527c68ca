// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "irregular_rings.hpp"

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith {

/// The points that continue the lines of a quad mesh beyond their vertices, for rules along four points of a line.
/// Beyond a regular vertex this is the next vertex. Beyond an extraordinary one it is Kobbelt's virtual point, in which
/// `gamma` weighs the vertices opposite the vertex. Beyond a boundary it is a reflection. Kobbelt 1996;
/// docs/schemes.md.
template <mask_evaluator Space, weight_number Scalar>
class virtual_points {
    using waves = ring_waves<Space, 0>;

public:
    /// Takes a step and the weight gamma. Cost: O(corners); the n corners of large fans cost O(n log n).
    template <step_context R>
    virtual_points(const R& r, double gamma)
        : gamma_(gamma)
        , kinds_(fan_kinds(r.coarse, 4, fan_kind::irregular))
        , neighbor_rows_(neighbor_weights)
        , opposite_rows_([gamma](std::size_t n) { return opposite_weights(n, gamma); })
        , large_(r.coarse, kinds_, [&r](const auto& v, std::size_t n) {
            return std::pair(waves(r.assoc, v.neighbors(), n), waves(r.assoc, v.opposites(), n));
        })
    {
    }

    /// Calls use(l, r) with the points that continue an edge beyond its ends.
    template <edge_element Edge, class Use>
    void beyond_ends(const Edge& e, const Use& use) const
    {
        if (is_regular(e.org()) and is_regular(e.dst()))
            use(straight_on(e.lcorner()), straight_on(e.rcorner()));
        else
            rarely_inlined([this, &use](const auto& irregular) { this->beyond_irregular_ends(irregular, use); }, e);
    }

private:
    template <vertex_element Vertex>
    [[nodiscard]] bool is_regular(const Vertex& v) const
    {
        return kinds_[v.index()] == fan_kind::regular;
    }
    /// Returns the vertex that continues the edge of c beyond c's own vertex, which is inside and has valence 4.
    template <corner_element Corner>
    static auto straight_on(const Corner& c)
    {
        return c.prev().across().prev().across().next().v();
    }
    template <edge_element Edge, class Use>
    void beyond_irregular_ends(const Edge& e, const Use& use) const
    {
        if (not e.is_boundary())
            return use(beyond(e.lcorner()), beyond(e.rcorner()));
        const auto along = [](auto v, auto w, auto rim) { // the curve ends at corners: reflect
            return choose(v.face_count() == 1, [v, w] { return 2. * v - w; }, [rim] { return sum(rim); });
        };
        const auto x = e.org();
        const auto y = e.dst();
        use(along(x, y, x.last_rim()), along(y, x, y.first_rim()));
    }
    /// Returns the point that continues the edge of c beyond the vertex of c.
    template <corner_element Corner>
    [[nodiscard]] auto beyond(const Corner& c) const
    {
        const auto v = c.v();
        const fan_kind kind = kinds_[v.index()];
        const bool has_row = kind == fan_kind::irregular and not v.is_boundary();
        const std::size_t n = has_row ? v.valence() : 0;
        const Scalar* l = has_row ? neighbor_rows_(n) : nullptr;
        const Scalar* k = has_row ? opposite_rows_(n) : nullptr;
        const auto by_row = [=] { return sum(c.neighbors_from_here(), l) + sum(c.opposites_from_here(), k); };
        const auto inside = [=, this] {
            return choose(
                kind == fan_kind::large,
                [=, this] { return beyond_large_fan(c); },
                [=] { return choose(kind == fan_kind::regular, [c] { return sum(straight_on(c)); }, by_row); });
        };
        return choose(v.is_boundary(), [c, v] { return 2. * v - c.next().v(); }, inside);
    }
    /// Returns the virtual point of a large fan from stored sums:
    /// 4/n sum l_j - (l_-1 + l_0 + l_1) + gamma (k_-2 + k_-1 + k_0 + k_1 - 4/n sum k_j).
    template <corner_element Corner>
    [[nodiscard]] auto beyond_large_fan(const Corner& c) const
    {
        const auto& [neighbors, opposites] = large_.at(c).sums;
        const auto clockwise = [](const Corner& d) { return d.across().next(); };
        const auto l = [](const Corner& d) { return d.next().v(); };
        const auto k = [](const Corner& d) { return d.next().next().v(); };
        const Corner after = c.prev().across(), before = clockwise(c), twice_before = clockwise(before);
        return neighbors.mask({4, 0, 0}, 0) - (l(before) + l(c) + l(after)) +
               Scalar(gamma_) * (k(twice_before) + k(before) + k(c) + k(after) + opposites.mask({-4, 0, 0}, 0));
    }

    /// Returns the weights of the neighbours l_j of a vertex of valence n: 4/n - [j = -1, 0, 1]. l_0 is the other end
    /// of the edge.
    static std::vector<double> neighbor_weights(std::size_t n)
    {
        std::vector<double> row(n, 4. / double(n));
        for (const std::size_t j : {n - 1, n, n + 1})
            row[j % n] -= 1;
        return row;
    }
    /// Returns the weights of the vertices k_j opposite it in its faces: gamma ([j = -2, -1, 0, 1] - 4/n). k_j lies
    /// between l_j and l_j+1.
    static std::vector<double> opposite_weights(std::size_t n, double gamma)
    {
        std::vector<double> row(n, -4 * gamma / double(n));
        for (const std::size_t j : {2 * n - 2, 2 * n - 1, 2 * n, 2 * n + 1})
            row[j % n] += gamma;
        return row;
    }

    double gamma_;
    std::vector<fan_kind> kinds_;
    rows_by_valence<Scalar> neighbor_rows_, opposite_rows_;
    large_fans<std::pair<waves, waves>> large_;
};

template <step_context R>
virtual_points(const R&, double)
    -> virtual_points<std::remove_cvref_t<decltype(std::declval<const R&>().assoc)>, typename R::scalar>;

} // namespace kith
