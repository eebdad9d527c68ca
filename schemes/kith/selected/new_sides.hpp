// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/association/association_space.hpp>
#include <kith/level/elements.hpp>

namespace kith {

/// What the side from a corner of a face to the next one gives birth to, each the side of the new edge that runs the
/// same way: the edge itself where it is kept, and where it is cut its halves.
template <class Assoc>
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

} // namespace kith
