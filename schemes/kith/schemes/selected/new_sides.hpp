// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/level/elements.hpp>
#include <kith/core/level/for_each.hpp>
#include <kith/core/mask/mask.hpp>
#include <kith/numbering/association/association_space.hpp>
#include <kith/numbering/association/step_context.hpp>

namespace kith {

/// The new sides to which the side from a corner of a face to the next one gives birth, each in the same direction. A
/// kept edge gives birth to itself, a cut edge to its halves.
template <mask_evaluator Assoc>
class new_sides {
    static constexpr targets::to_edge E{};

protected:
    explicit new_sides(const Assoc& assoc) : assoc_(assoc) {}

    template <corner_element Corner>
    [[nodiscard]] auto kept(const Corner& c) const
    {
        const auto e = c.next_edge();
        return assoc_(e, E).along(e);
    }
    template <corner_element Corner>
    [[nodiscard]] auto start(const Corner& c) const
    {
        const auto e = c.next_edge();
        return assoc_(c.v(), e, E).along(e);
    }
    template <corner_element Corner>
    [[nodiscard]] auto end(const Corner& c) const
    {
        const auto e = c.next_edge();
        return assoc_(c.next().v(), e, E).along(e);
    }

    const Assoc& assoc_;
};

/// Makes the faces of the next level, and sets where the fans of the old vertices and of those on cut edges start.
/// `split_of(face)` returns the split of a face, with these members: make_all() makes the new elements. leaving(corner)
/// and leaving_middle(corner) return half-edges, each as the corner in which it starts and its side. They leave the
/// vertex of a corner and the middle of the side from it. Cost: O(corners).
template <step_context R, class Closure, class SplitOf>
void connect_split_faces(const R& r, const Closure& marks, const SplitOf& split_of)
{
    using namespace targets;
    const auto& [coarse, assoc, generation] = r;
    for_each(coarse.faces(), [&](auto f) { split_of(f).make_all(); });
    for_each(coarse.vertices(), [&](auto v) {
        const auto c = v.first_corner();
        const auto [corner, side] = split_of(c.f()).leaving(c);
        assoc(v, V).starts_at(corner, side);
    });
    for_each(coarse.edges(), [&](auto e) {
        if (not marks.is_cut(e))
            return;
        const auto c = e.lcorner();
        const auto [corner, side] = split_of(c.f()).leaving_middle(c);
        assoc(e, V).starts_at(corner, side);
    });
}

} // namespace kith
