// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "boundary.hpp"
#include "kernels.hpp"
#include "polygons.hpp"

#include <kith/core/level/for_each.hpp>
#include <kith/numbering/association/step_context.hpp>
#include <kith/numbering/step/refinement.hpp>
#include <kith/schemes/kernel/large_rings.hpp>
#include <kith/schemes/split/require_faces.hpp>

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace kith::detail {

/// Makes the points of an inner vertex among quads with a large fan, by the waves of its ring.
template <vertex_element Vertex, mask_evaluator Assoc>
void make_large_inner(const Vertex& v, const Assoc& assoc)
{
    using namespace targets;
    const std::size_t n = v.valence();
    const ring_waves<Assoc, 2> e(assoc, v.neighbors(), n), d(assoc, v.opposites(), n);
    assoc(v, V) = (361. * v + e.mask({304, 0, 0}, 0) + d.mask({64, 0, 0}, 0)) / 729;
    std::int64_t turn = 0;
    for (const auto c : v.corners()) {
        assoc(v, c.next_edge(), V) = (304. * v + e.mask(kernel_b(n), turn) + d.mask(kernel_c(n), turn - 1)) / 729;
        assoc(c, V) = (256. * v + e.mask(kernel_q(n), turn + 1) + d.mask(kernel_g(n), turn)) / 729;
        turn += 2;
    }
}

/// Calls inner(v, weights) for each inner vertex among quads, with the weights of its valence. Makes the points of all
/// other vertices: at the boundary, beside faces that are not quads, and with large fans. Cost: O(corners); each corner
/// of a large face costs O(log large faces).
template <step_context R, class Inner>
void make_ternary_points(const R& r, const Inner& inner)
{
    const auto& [coarse, assoc, generation] = r;
    const ternary_weights<scalar_type<R>> weights;
    const polygon_weights& weights_beside = polygon_weights::shared();
    const large_faces large(coarse, [&assoc = assoc](const auto& f, std::size_t n) {
        return ring_waves<std::remove_cvref_t<decltype(assoc)>, 2>(assoc, f.vertices(), n);
    });
    for_each(coarse.vertices(), [&, inner](auto v) {
        if (v.is_boundary())
            out_of_line([&](auto x) { make_ternary_boundary(x, assoc, large); }, v);
        else if (not has_quads_only(v))
            out_of_line([&](auto x) { beside_polygons(x, assoc, weights_beside, large).make_all(); }, v);
        else if (v.valence() <= longest_row)
            inner(v, weights(v.valence()));
        else
            out_of_line([&](auto x) { make_large_inner(x, assoc); }, v);
    });
}

} // namespace kith::detail
