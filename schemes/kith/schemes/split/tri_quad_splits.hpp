// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/numbering/step/refinement.hpp>
#include <kith/numbering/step/scheme_traits.hpp>

#include <vector>

namespace kith {

namespace detail {

/// The split of each quad into two triangles that mark the diagonal.
struct diagonal_split {
    const std::vector<unsigned char>* is_odd; ///< by face: the diagonal joins the second and the fourth corner

    static constexpr auto traits() { return scheme_traits{.faces = face_shape::quads}; }
    [[nodiscard]] auto columns() const
    {
        const auto apex = [is_odd = is_odd](const auto& c) { return is_apex(c, *is_odd); };
        return kith::columns(
            new_vertices(per_vertex), new_edges(per_edge, per_face), new_faces(triangles(per_corner).only(apex)));
    }
    template <step_context R>
    void operator()(const R& r) const
    {
        using namespace targets;
        const auto& [coarse, assoc, generation] = r;
        for_each(coarse.faces(), [&](auto f) {
            const auto c = (*is_odd)[f.index()] != 0 ? f.first_corner().next() : f.first_corner();
            for (const auto apex : {c.next(), c.prev()}) {
                const auto in = apex.prev_edge();
                const auto out = apex.next_edge();
                const auto diagonal = apex == c.next() ? assoc(f, E).left() : assoc(f, E).right();
                assoc(apex, F) = polygon(assoc(apex.next().v(), V) >> diagonal,
                                         assoc(apex.prev().v(), V) >> assoc(in, E).along(in),
                                         assoc(apex.v(), V) >> assoc(out, E).along(out));
            }
        });
        for_each(coarse.vertices(), [&](auto v) { // its fan starts at the same edge as before
            assoc(v, V) = v;
            const auto c = v.first_corner();
            const auto side = assoc(c.next_edge(), E).along(c.next_edge());
            if (is_apex(c, *is_odd))
                assoc(v, V).starts_at(assoc(c, F).corner(2), side);
            else
                assoc(v, V).starts_at(assoc(c.next(), F).corner(1), side);
        });
    }

private:
    template <corner_element Corner>
    static bool is_apex(const Corner& c, const std::vector<unsigned char>& is_odd)
    {
        return (c.index() - c.f().first_corner().index() + is_odd[c.f().index()]) % 2 == 1;
    }
};

/// The split of each face into triangles around its centroid that mark the edges of the face.
struct centroid_split {
    static constexpr auto columns()
    {
        return kith::columns(
            new_vertices(per_vertex, per_face), new_edges(per_edge, per_corner), new_faces(triangles(per_side)));
    }
    template <step_context R>
    void operator()(const R& r) const
    {
        using namespace targets;
        const auto& [coarse, assoc, generation] = r;
        for_each(coarse.vertices(), [&](auto v) { // its fan starts at the same edge as before
            assoc(v, V) = v;
            const auto c = v.first_corner();
            const auto e = c.next_edge();
            assoc(v, V).starts_at(assoc(e, c.f(), F).corner(0), assoc(e, E).along(e));
        });
        for_each(coarse.faces(), [&](auto f) {
            assoc(f, V) = average(f.vertices());
            const auto c = f.first_corner();
            assoc(f, V).starts_at(assoc(c.next_edge(), f, F).corner(2), assoc(c, E).right());
        });
        for_each(coarse.corners(), [&](auto c) {
            const auto e = c.next_edge();
            assoc(e, c.f(), F) = polygon(assoc(c.v(), V) >> assoc(e, E).along(e),
                                         assoc(c.next().v(), V) >> assoc(c.next(), E).left(),
                                         assoc(c.f(), V) >> assoc(c, E).right());
        });
    }
};

} // namespace detail

} // namespace kith
