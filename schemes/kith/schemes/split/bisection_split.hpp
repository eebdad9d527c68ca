// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/numbering/step/refinement.hpp>

#include <cstdint>
#include <string>

namespace kith {

/// The 4-8 bisection of a tri-quad mesh. Its triangles each mark one edge, and both triangles of an inner marked edge
/// mark it. Every marked edge gives birth to a vertex and is bisected; the unmarked edges are the marked edges of the
/// next level. The marked edge of a triangle is its first one, on every mesh type. So the mark needs no memory and is
/// passed on by the order of the corners alone. Velho & Zorin 2001, section 3.
struct bisection_split {
    /// Returns true if the half-edge from this corner is the marked edge of its triangle.
    template <corner_element Corner>
    static bool is_first(const Corner& c)
    {
        return c == c.f().first_corner();
    }
    /// Returns true if the triangles at the edge mark it; the one on its left tells.
    template <edge_element Edge>
    static bool is_marked(const Edge& e)
    {
        return is_first(e.lcorner());
    }

    /// Returns the corner of the next side of a pair, for a corner whose half-edge is a side of it. The two triangles
    /// at a marked edge are a pair, a quad. Precondition: the marked edge of c's triangle does not lie at the boundary.
    template <corner_element Corner>
    static Corner next_in_pair(const Corner& c)
    {
        return c.next() == c.f().first_corner() ? c.next().across().next() : c.next();
    }

    /// The numbering of the tuples that a column picks, without the mesh. `before(n, m)` is the number of picked tuples
    /// before the n-th one, with m marked edges before that of the n-th. `picked(r, m)` is the r-th picked tuple, if m
    /// marked edges come first. `marked(counts, generation)` is m for a whole level.
    struct of_marks {
        /// Returns the number of marked edges. Boundary edges are marked in odd generations, as `tri_quad` makes and
        /// numbers them.
        static constexpr std::uint64_t marked(const counts& c, int generation)
        {
            return (c.faces + (generation % 2 != 0 ? c.boundary_edges : 0)) / 2;
        }
    };
    /// The column of edges that are bisected.
    struct marked_edge : of_marks {
        template <edge_element Edge>
        constexpr bool operator()(const Edge& e) const
        {
            return is_marked(e);
        }
        static constexpr std::uint64_t before(std::uint64_t, std::uint64_t m) { return m; }
        static constexpr std::uint64_t picked(std::uint64_t r, std::uint64_t) { return r; }
    };
    /// The column of edges that stay.
    struct unmarked_edge : of_marks {
        template <edge_element Edge>
        constexpr bool operator()(const Edge& e) const
        {
            return not is_marked(e);
        }
        static constexpr std::uint64_t before(std::uint64_t n, std::uint64_t m) { return n - m; }
        static constexpr std::uint64_t picked(std::uint64_t r, std::uint64_t m) { return r + m; }
    };
    /// The column of the halves of marked edges.
    struct end_of_marked_edge : marked_edge {
        static constexpr std::uint64_t before(std::uint64_t n, std::uint64_t m) { return 2 * m + n % 2; }
    };
    /// The column of the two corners of a triangle at its marked edge.
    struct corner_at_marked_edge : of_marks {
        template <corner_element Corner>
        constexpr bool operator()(const Corner& c) const
        {
            return not(c.next() == c.f().first_corner());
        }
        static constexpr std::uint64_t before(std::uint64_t n, std::uint64_t) { return n / 3 * 2 + n % 3; }
        static constexpr std::uint64_t picked(std::uint64_t r, std::uint64_t) { return r / 2 * 3 + r % 2; }
    };

    static constexpr auto columns()
    {
        return kith::columns(new_vertices(per_vertex, per_edge.only(marked_edge{})),
                             new_edges(per_edge.only(unmarked_edge{}), per_end.only(end_of_marked_edge{}), per_face),
                             new_faces(triangles(per_corner).only(corner_at_marked_edge{})));
    }

    /// Returns true if a triangle and the one across its marked edge agree on this edge.
    template <face_element Face>
    static bool agrees_on_mark(const Face& f)
    {
        const auto c = f.first_corner();
        return c.is_boundary() or is_first(c.across());
    }
    /// Returns true if all triangles agree on their marked edges. Cost: O(faces).
    template <level Level>
    static bool has_marks(const Level& coarse)
    {
        for (const auto f : coarse.faces())
            if (not agrees_on_mark(f))
                return false;
        return true;
    }
    /// Throws mesh_error unless all triangles agree on their marked edges. Cost: O(faces).
    template <level Level>
    static void require_marks(const Level& coarse)
    {
        for (const auto f : coarse.faces())
            if (const auto c = f.first_corner(); not agrees_on_mark(f))
                throw mesh_error(
                    "4-8: faces " + std::to_string(number_in_mesh(coarse, f)) + " and " +
                    std::to_string(number_in_mesh(coarse, c.across().f())) +
                    " do not both start with the edge between them; make a tri-quad mesh first (tri_quad)");
    }

    template <step_context R>
    static void connect(const R& r)
    {
        using namespace targets;
        const auto& [coarse, assoc, generation] = r;
        for_each(coarse.faces(), [&](auto f) {
            const auto a = f.first_corner(); // the marked edge is a -> b, the apex d
            const auto b = a.next();
            const auto d = b.next();
            const auto ab = a.next_edge();
            const auto bd = b.next_edge();
            const auto da = d.next_edge();
            assoc(a, F) = polygon(assoc(d.v(), V) >> assoc(da, E).along(da),
                                  assoc(a.v(), V) >> assoc(a.v(), ab, E).along(ab),
                                  assoc(ab, V) >> assoc(f, E).left());
            assoc(b, F) = polygon(assoc(b.v(), V) >> assoc(bd, E).along(bd),
                                  assoc(d.v(), V) >> assoc(f, E).right(),
                                  assoc(ab, V) >> assoc(b.v(), ab, E).along(ab));
        });
        for_each(coarse.vertices(), [&](auto v) {
            const auto c = v.first_corner();
            const auto a = c.f().first_corner();
            const auto en = c.next_edge();
            if (c == a)
                assoc(v, V).starts_at(assoc(a, F).corner(1), assoc(v, en, E).along(en));
            else
                assoc(v, V).starts_at(assoc(c == a.next() ? c : a, F).corner(0), assoc(en, E).along(en));
        });
        for_each(coarse.edges(), [&](auto e) {
            if (is_marked(e))
                assoc(e, V).starts_at(assoc(e.lcorner().next(), F).corner(2), assoc(e.dst(), e, E).left());
        });
    }
};

} // namespace kith
