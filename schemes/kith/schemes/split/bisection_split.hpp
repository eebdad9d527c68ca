// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/numbering/step/refinement.hpp>

#include <cstdint>
#include <string>

namespace kith {

/// The 4-8 bisection of a tri-quad mesh: triangles that each mark one edge, both triangles of an inner marked edge
/// marking it. Every marked edge gives birth to a vertex and is bisected; the edges that were unmarked are the marked
/// ones of the next level. The marked edge of a triangle is its first one, on every mesh type, so the mark needs no
/// room and is handed on by the order of the corners alone. Velho & Zorin 2001, section 3.
struct bisection_split {
    /// Whether the marked edge of its triangle leaves from this corner.
    template <corner_element Corner>
    static bool is_first(const Corner& c)
    {
        return c == c.f().first_corner();
    }
    /// Whether the triangles at the edge mark it; that on its left tells.
    template <edge_element Edge>
    static bool is_marked(const Edge& e)
    {
        return is_first(e.lcorner());
    }

    /// The two triangles at a marked edge are a pair, a quad; of a corner whose half-edge is a side of one, that of the
    /// next side. Precondition: the marked edge of c's triangle does not lie at the boundary.
    template <corner_element Corner>
    static Corner next_in_pair(const Corner& c)
    {
        return c.next() == c.f().first_corner() ? c.next().across().next() : c.next();
    }

    /// What the columns pick. `before(n, m)`: how many of the tuples before the n-th, with m marked edges before that
    /// of the n-th. `picked(r, m)`: the r-th that is picked, where the m marked edges come first. By these what is
    /// picked is numbered without the mesh. `marked(counts, generation)`: m of a whole level.
    struct of_marks {
        /// Boundary edges are marked in odd generations, as `tri_quad` makes and numbers them.
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

    /// Whether a triangle and the one behind its marked edge agree on it.
    template <face_element Face>
    static bool agrees_on_mark(const Face& f)
    {
        const auto c = f.first_corner();
        return c.is_boundary() or is_first(c.across());
    }
    /// Whether the triangles agree on their marked edges. Cost: O(faces).
    template <level Level>
    static bool has_marks(const Level& coarse)
    {
        for (const auto f : coarse.faces())
            if (not agrees_on_mark(f))
                return false;
        return true;
    }
    /// Errors: mesh_error unless they do. Cost: as above.
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
