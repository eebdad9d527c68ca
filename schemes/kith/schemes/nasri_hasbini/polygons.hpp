// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kernels.hpp"

#include <kith/core/mask/choose.hpp>
#include <kith/numbering/association/association.hpp>
#include <kith/schemes/kernel/large_rings.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace kith::detail {

/// Returns the vertex opposite that of c in its face; in a face that is not a quad, a point that stands for it.
template <corner_element Corner, class LargeFaces>
auto diagonal(const Corner& c, const LargeFaces& large)
{
    const std::size_t m = c.f().degree();
    return choose(
        m == 4,
        [c] { return sum(c.next().next().v()); },
        [c, m, &large] {
            return choose(
                m <= longest_row,
                [c, m] { return sum(c.vertices_from_here(), [m](std::size_t k) { return diagonal_weight(k, m); }); },
                [c, &large] { return large.of(c.f()).mask(diagonal_kernel, 2 * step_in_face(c)); });
        });
}

/// The points of an inner vertex beside faces that are not quads; docs/schemes.md, Nasri-Hasbini. The ring weights of
/// the quad rule are redistributed. The weights that belong to a special face (one that contains the new point) go to
/// the corners of that face, by its own kernel. Cost: O(valence + corners of the faces that are not large); in fans
/// that are not large, times 64.
template <vertex_element Vertex, mask_evaluator Assoc, class LargeFaces>
class beside_polygons {
public:
    using corner_type = decltype(std::declval<const Vertex&>().first_corner());
    using real = typename Assoc::scalar;

    beside_polygons(const Vertex& v, const Assoc& assoc, const polygon_weights& weights, const LargeFaces& large)
        : v_(v), assoc_(assoc), weights_(weights), large_(large)
    {
        for (const auto c : v.corners())
            ring_.push_back(c);
        totals_.resize(ring_.size());
    }

    void make_all()
    {
        using namespace targets;
        make(assoc_(v_, V), 0, ternary_point::vertex);
        if (ring_.size() > longest_row)
            return make_large();
        for (std::size_t i = 0; i < ring_.size(); ++i) {
            make(assoc_(v_, ring_[i].next_edge(), V), i, ternary_point::edge);
            make(assoc_(ring_[i], V), i, ternary_point::face);
        }
    }

private:
    /// A vertex, or a sum of vertices that is already known.
    struct operand : mask_base {
        Vertex vertex;
        const typename Assoc::sum* known;

        operand(const Vertex& vertex, const typename Assoc::sum* known = nullptr) : vertex(vertex), known(known) {}

        template <value_space Values>
        [[nodiscard]] typename Values::sum evaluate(const Values& values) const
        {
            return known != nullptr ? *known : vertex.evaluate(values);
        }
    };

    template <class Association>
    void make(const Association& target, std::size_t i, ternary_point point)
    {
        const std::size_t n = ring_.size();
        const auto is_special = [&](std::size_t j) {
            const bool near = point == ternary_point::vertex or j == i or
                              (point == ternary_point::edge and (j + 1) % n == i);
            return near and ring_[j].f().degree() != 4;
        };
        std::size_t specials = 0;
        for (std::size_t j = 0; j < n; ++j)
            specials += is_special(j);
        row_.clear();
        std::fill(totals_.begin(), totals_.end(), 0.);
        const double own = center_weight(point);
        for (std::size_t j = 0; j < n; ++j) {
            if (is_special(j))
                totals_[j] += own / double(specials);
            const std::size_t before = (j + n - 1) % n; // e_j lies between faces j-1 and j
            const double e = weights_.neighbor(point, (j + n - i) % n, n);
            const double d = weights_.opposite(point, (j + n - i) % n, n);
            const int sharing = int(is_special(j)) + int(is_special(before));
            if (sharing == 0)
                row_.emplace_back(ring_[j].next().v(), real(e));
            if (is_special(j))
                totals_[j] += e / sharing;
            if (is_special(before))
                totals_[before] += e / sharing;
            if (is_special(j))
                totals_[j] += d;
            else
                spend_on_opposite(ring_[j], d);
        }
        if (specials == 0)
            row_.emplace_back(v_, real(own));
        for (std::size_t j = 0; j < n; ++j)
            if (is_special(j))
                spend_on_special(point, j, totals_[j], point == ternary_point::edge and j != i);
        target = weighted(row_) / 729;
    }

    /// Makes the points on the edges and in the faces of a large fan: those of the quad rule, by its waves, corrected
    /// for the one or two special faces of each point.
    void make_large()
    {
        using namespace targets;
        const std::size_t n = ring_.size();
        using waves = ring_waves<Assoc, 2>;
        const waves neighbors(assoc_, v_.neighbors(), n);
        const waves opposites(assoc_, v_.corners().map([this](const auto& c) { return diagonal(c, large_); }), n);
        for (std::size_t i = 0; i < n; ++i) {
            const auto turn = 2 * std::int64_t(i);
            row_.clear();
            spend(neighbors, kernel_b(n), turn, 1);
            spend(opposites, kernel_c(n), turn - 1, 1);
            mend(ternary_point::edge, i, {(i + n - 1) % n, i});
            assoc_(v_, ring_[i].next_edge(), V) = weighted(row_) / 729;

            row_.clear();
            spend(neighbors, kernel_q(n), turn + 1, 1);
            spend(opposites, kernel_g(n), turn, 1);
            mend(ternary_point::face, i, {i, i});
            assoc_(ring_[i], V) = weighted(row_) / 729;
        }
    }
    /// Redistributes, in the row of the quad rule, the weights that belong to special faces. `near` has the faces of
    /// the new point, twice the same one for a point in a face.
    void mend(ternary_point point, std::size_t i, std::array<std::size_t, 2> near)
    {
        const std::size_t n = ring_.size();
        const auto is_special = [&](std::size_t j) {
            return (j == near[0] or j == near[1]) and ring_[j].f().degree() != 4;
        };
        const bool both = near[0] != near[1];
        const int specials = int(is_special(near[0])) + int(both and is_special(near[1]));
        const double own = center_weight(point);
        if (specials == 0)
            row_.emplace_back(v_, real(own));
        for (std::size_t k = 0; k < (both ? 2 : 1); ++k) {
            const std::size_t j = near[k];
            if (not is_special(j))
                continue;
            const double d = opposite_weight(point, (j + n - i) % n, n);
            double total = own / specials + d;
            spend_on_opposite(ring_[j], -d);
            for (const std::size_t at : {j, (j + 1) % n}) { // the neighbours in this face
                const double e = neighbor_weight(point, (at + n - i) % n, n);
                const int sharing = int(is_special(at)) + int(is_special((at + n - 1) % n));
                row_.emplace_back(ring_[at].next().v(), real(-e / sharing));
                total += e / sharing;
            }
            spend_on_special(point, j, total, point == ternary_point::edge and j != i);
        }
    }

    void spend_on_opposite(const corner_type& c, double total)
    {
        const std::size_t m = c.f().degree();
        if (m == 4)
            row_.emplace_back(c.next().next().v(), real(total));
        else if (m > longest_row)
            spend(large_.of(c.f()), diagonal_kernel, 2 * step_in_face(c), total);
        else
            spend(c, total, [w = weights_.diagonal(m)](std::size_t k) { return w[k]; });
    }
    void spend_on_special(ternary_point point, std::size_t j, double total, bool mirrored)
    {
        const corner_type& c = ring_[j];
        const std::size_t m = c.f().degree();
        if (m > longest_row) {
            auto [k0, k1, k2] = polygon_kernel(point, m);
            if (mirrored)
                k1 = std::conj(k1), k2 = std::conj(k2);
            spend(large_.of(c.f()), {1, k1 / k0, k2 / k0}, 2 * step_in_face(c), total);
        } else {
            spend(
                c, total, [=, w = weights_.special(point, m)](std::size_t k) { return w[mirrored ? (m - k) % m : k]; });
        }
    }
    /// Adds the corners of c's face to the row, counted from c.
    template <class WeightOf>
    void spend(const corner_type& c, double total, const WeightOf& weight_of)
    {
        std::size_t k = 0;
        for (const auto u : c.vertices_from_here()) {
            if (const double weight = weight_of(k++); weight != 0)
                row_.emplace_back(u, real(total * weight));
        }
    }
    /// Adds a ring to the row by its sums.
    template <class Waves>
    void spend(const Waves& waves, const wave_kernel& kernel, std::int64_t half_steps, double total)
    {
        const auto weights = waves.weights(kernel, half_steps, total);
        for (std::size_t k = 0; k < weights.size(); ++k)
            row_.emplace_back(operand(v_, &waves.values()[k]), weights[k]);
    }

    Vertex v_;
    const Assoc& assoc_;
    const polygon_weights& weights_;
    const LargeFaces& large_;
    std::vector<corner_type> ring_;
    std::vector<std::pair<operand, real>> row_;
    std::vector<double> totals_; // of each special face
};

} // namespace kith::detail
