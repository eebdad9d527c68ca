// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "polygons.hpp"

#include <kith/numbering/association/association.hpp>

#include <cstddef>

namespace kith::detail {

/// Makes the points of a boundary vertex. The boundary curve is the ternary cubic B-spline; a vertex with one face is a
/// corner. docs/schemes.md.
template <vertex_element Vertex, mask_evaluator Assoc, class LargeFaces>
void make_ternary_boundary(const Vertex& v, const Assoc& assoc, const LargeFaces& large)
{
    using namespace targets;
    const auto diagonal = [&](const auto& c) { return detail::diagonal(c, large); };
    const auto a = v.first_rim();
    const auto z = v.last_rim();
    const auto first = v.first_corner();
    const auto last = v.last_corner();
    const std::size_t faces = v.face_count();
    const auto towards = [&](const auto& e, const auto& near, const auto& far) {
        if (faces == 1)
            assoc(v, e, V) = (2. * v + near) / 3;
        else
            assoc(v, e, V) = (far + 16. * v + 10. * near) / 27;
    };
    towards(first.next_edge(), a, z);
    towards(last.prev_edge(), z, a);
    if (faces == 1)
        assoc(v, V) = v;
    else
        assoc(v, V) = (4. * a + 19. * v + 4. * z) / 27;

    if (faces == 2) { // the first row inside, reflected at the boundary
        const auto c = last.next().v();
        const auto d0 = diagonal(first);
        const auto d1 = diagonal(last);
        assoc(v, last.next_edge(), V) = 2. * assoc(v, V) / 3 + (4. * d0 + 19. * c + 4. * d1) / 81;
        assoc(first, V) = 2. * assoc(v, first.next_edge(), V) / 3 + (d1 + 16. * c + 10. * d0) / 81;
        assoc(last, V) = 2. * assoc(v, last.prev_edge(), V) / 3 + (d0 + 16. * c + 10. * d1) / 81;
        return;
    }
    for (const auto c : v.corners()) {
        if (not c.is_boundary())
            assoc(v, c.next_edge(), V) = (2. * assoc(v, V) + c.next().v()) / 3;
        assoc(c, V) = (4. * assoc(v, V) + 2. * c.next().v() + 2. * c.prev().v() + diagonal(c)) / 9;
    }
}

} // namespace kith::detail
