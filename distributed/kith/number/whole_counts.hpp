// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/association/columns.hpp>
#include <kith/base/error.hpp>
#include <kith/part/tile.hpp>

namespace kith {

/// How many elements a level has in the whole mesh.
struct whole_counts {
    global_id vertices = 0, edges = 0, faces = 0, corners = 0;
    global_id marked_edges = 0; ///< of schemes that mark some, see marks_edges

    friend bool operator==(const whole_counts&, const whole_counts&) = default;
};

namespace detail {

inline global_id tuples_of(const whole_counts& whole, tuple_kind kind)
{
    switch (kind) {
    case tuple_kind::v: return whole.vertices;
    case tuple_kind::e: return whole.edges;
    case tuple_kind::f: return whole.faces;
    case tuple_kind::ve: return 2 * whole.edges;
    case tuple_kind::vfe: return 2 * whole.corners;
    default: return whole.corners;
    }
}

inline global_id add_ids(global_id a, global_id b)
{
    global_id sum;
    if (__builtin_add_overflow(a, b, &sum))
        throw mesh_error("the whole mesh has more elements than 64 bits can number; refine fewer times");
    return sum;
}

} // namespace detail

} // namespace kith
