// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/counts.hpp>
#include <kith/numbering/association/columns.hpp>
#include <kith/tiles/part/tile.hpp>

namespace kith {

/// The counts of the elements of a level in the whole mesh.
struct global_counts {
    global_id vertices = 0, edges = 0, faces = 0, corners = 0;
    global_id marked_edges = 0; ///< of schemes that mark edges, see marks_edges

    [[nodiscard]] constexpr element_counts elements() const { return {vertices, edges, faces, corners}; }

    /// Returns the counts as those of a level, which do not contain the vertices at the boundary.
    [[nodiscard]] constexpr counts as_counts() const { return {vertices, edges, faces, 2 * edges - corners}; }

    friend bool operator==(const global_counts&, const global_counts&) = default;
};

} // namespace kith
