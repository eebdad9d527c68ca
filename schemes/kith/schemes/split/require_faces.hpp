// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/error.hpp>
#include <kith/core/level/for_each.hpp>
#include <kith/numbering/step/scheme.hpp>

#include <cstddef>
#include <string>
#include <string_view>

namespace kith {

namespace detail {

/// Throws mesh_error for a vertex between two faces only, given by its number.
[[noreturn, gnu::noinline, gnu::cold]] inline void refuse_two_faces(std::string_view scheme, std::size_t vertex,
                                                                    bool are_triangles)
{
    throw mesh_error(std::string(scheme) + ": vertex " + std::to_string(vertex) +
                     " lies between 2 faces only, the scheme needs three; " +
                     (are_triangles ? "remove these triangles, which are back to back, or put a vertex into one of them"
                                    : "merge its two edges into one first"));
}

} // namespace detail

/// Throws mesh_error at inner vertices between two faces only. Schemes that make a face of every vertex would make one
/// of two corners there. If both faces are triangles, they are back to back. Schemes that split triangles would then
/// make two edges with the same ends, at every level, which no list of faces can distinguish. With
/// face_shape::triangles, only these vertices are refused. No step makes such vertices if there are none, so it is
/// enough to check a mesh before the first step. Cost: O(vertices).
template <scheme Scheme, level Level>
void require_three_faces(const Level& coarse, face_shape refused = face_shape::any)
{
    for_each_by_number(coarse.vertices(), [&coarse, refused](const auto& v) {
        const auto first = v.first_corner(), before = first.prev();
        if (first.is_boundary() or before.is_boundary())
            return;
        const auto second = before.across();
        if (not(first.across().next() == second)) // the neighbours in the fan, clockwise and counter-clockwise
            return;
        const bool triangles = first.f().degree() == 3 and second.f().degree() == 3;
        if (triangles or refused == face_shape::any)
            detail::refuse_two_faces(scheme_name<Scheme>(), number_in_mesh(coarse, v), triangles);
    });
}

/// The check of require_three_faces as a function for the traits of a scheme: `.require = three_faces_at_vertices`.
inline constexpr auto three_faces_at_vertices = []<scheme Scheme>(const Scheme&, const auto& level, int) {
    require_three_faces<Scheme>(level);
};

/// Returns true if all faces at a vertex are quads.
template <vertex_element Vertex>
bool has_quads_only(const Vertex& v)
{
    for (const auto& c : v.corners())
        if (c.f().degree() != 4)
            return false;
    return true;
}

} // namespace kith
