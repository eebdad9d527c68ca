// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/for_parts.hpp>
#include <kith/core/mesh/basic_mesh.hpp>
#include <kith/core/mesh/foreign_level.hpp>

#include <cstddef>
#include <cstdint>
#include <new>
#include <vector>

namespace kith::in_place {

/// Calls body(begin, end) for ranges of all numbers below `size`, on threads if there is memory for them. Precondition:
/// calling the body twice for a number has the same effect as calling it once.
template <class Body>
void for_parts_surely(std::size_t size, const Body& body) noexcept
{
    try {
        kith::detail::for_parts(size, true, body);
    } catch (const std::bad_alloc&) {
        body(std::size_t(0), size);
    }
}

/// A class that joins the elements of a mesh by connectivity arrays, which must outlive it. The mesh has as many edges
/// and faces as the arrays and no others; edge i and face i have index i. handle_of(v) is the handle of vertex v.
class element_joiner {
    using index = std::uint32_t;

public:
    /// Allocates what joining needs, so that join() cannot fail. Cost: O(elements).
    explicit element_joiner(const connectivity<index>& t) : t_(&t)
    {
        // Along the boundary the sides without a face run the other way.
        if (t.is_closed())
            return;
        leaving_.resize(t.vertices);
        for (std::size_t e = 0; e < t.edges(); ++e)
            if (const auto side = index(2 * e + 1); t.halfedge_corner[side] == t.none) {
                outer_.push_back(side);
                leaving_[t.ends(e)[1]] = side;
            }
    }

    /// Joins the elements. Precondition: no elements of the mesh are joined yet. Cost: O(elements).
    template <class Traits, class M, class HandleOf>
    void join(M& mesh, const HandleOf& handle_of) const noexcept
    {
        const connectivity<index>& t = *t_;
        const auto halfedge = [](std::size_t i) { return Traits::template at<typename Traits::halfedge>(i); };
        const auto face = [](std::size_t i) { return Traits::template at<typename Traits::face>(i); };
        for_parts_surely(t.vertices, [&](std::size_t begin, std::size_t end) {
            for (std::size_t v = begin; v < end; ++v)
                Traits::set_start(mesh, handle_of(v), halfedge(t.corner_halfedge[t.vertex_corner[v]]));
        });
        for_parts_surely(t.faces, [&](std::size_t begin, std::size_t end) {
            for (std::size_t f = begin; f < end; ++f) {
                const index first = t.first_corner(f), behind = t.first_corner(f + 1);
                for (index c = first; c < behind; ++c) {
                    const index next = c + 1 == behind ? first : c + 1;
                    Traits::set_side(mesh,
                                     halfedge(t.corner_halfedge[c]),
                                     face(f),
                                     handle_of(t.corner_vertex[next]),
                                     halfedge(t.corner_halfedge[next]));
                }
                Traits::set_start(mesh, face(f), halfedge(t.corner_halfedge[first]), behind - first);
            }
        });
        for (const index side : outer_) {
            const index to = t.ends(side / 2)[0]; // its edge is directed by the inner side
            Traits::set_boundary_side(mesh, halfedge(side), handle_of(to), halfedge(leaving_[to]));
        }
    }

private:
    const connectivity<index>* t_;
    std::vector<index> outer_;   ///< the sides without a face
    std::vector<index> leaving_; ///< by vertex, the side without a face that leaves it
};

} // namespace kith::in_place
