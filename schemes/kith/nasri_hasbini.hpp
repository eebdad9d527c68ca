// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/mask/large_rings.hpp>
#include <kith/mask/weight_rows.hpp>
#include <kith/nasri_hasbini/polygons.hpp>
#include <kith/split/require_faces.hpp>
#include <kith/split/ternary_split.hpp>

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace kith {

/// Nasri-Hasbini: ternary refinement of bicubic B-splines, three times as fine per step, polygons of any kind.
/// Published (thesis 2.1.5) are the split and the masks of the regular part. The masks around extraordinary vertices, in
/// faces that are not quads and at irregular boundary vertices are derived in docs/schemes.md and not the original
/// authors'. C2 in the regular part. Extraordinary vertices and faces persist. Cost: O(corners), those of large faces times
/// the logarithm of their number.
struct nasri_hasbini {
    static constexpr auto traits()
    {
        return scheme_traits{
            .name = "nasri-hasbini", .trusted = true, .reach = [](int rings) { return (rings + 1) / 3 + 1; }};
    }
    static constexpr auto columns() { return ternary_split::columns(); }

    template <class R>
    void operator()(const R& r) const
    {
        using namespace targets;
        using real = scalar_type<R>;
        const auto& [coarse, assoc, generation] = r;
        const ternary_rows<real> rows;
        const polygon_rows& rows_beside = polygon_rows::shared();
        const large_faces large(coarse, [&assoc = assoc](const auto& f, std::size_t n) {
            return ring_waves<std::remove_cvref_t<decltype(assoc)>, 2>(assoc, f.vertices(), n);
        });

        // All points (v), (v,e), (v,f) of a vertex are masks over its ring, so one loop over the vertices makes them all.
        for_each(coarse.vertices(), [&](auto v) {
            if (v.is_boundary())
                make_boundary(v, assoc, large);
            else if (not has_quads_only(v))
                detail::beside_polygons(v, assoc, rows_beside, large).make_all();
            else if (v.valence() <= longest_row)
                make_inner(v, assoc, rows);
            else
                make_large_inner(v, assoc);
        });

        ternary_split::connect(r);
    }

private:
    /// docs/schemes.md, Nasri-Hasbini, inner vertices.
    template <class Vertex, class Assoc, class Rows>
    static void make_inner(const Vertex& v, const Assoc& assoc, const Rows& rows)
    {
        using namespace targets;
        const std::size_t n = v.valence();
        const auto first = v.first_corner();
        const auto ring = 304. * average(first.neighbors_from_here()) + 64. * average(first.opposites_from_here());
        assoc(v, V) = (361. * v + ring) / 729;
        typename Rows::spare spare;
        const auto row = rows(n, spare);
        for (const auto c : v.corners()) {
            const auto e = c.next_edge();
            assoc(v, e, V) = (304. * v + sum(c.neighbors_from_here(), row.b) + sum(c.opposites_from_here(), row.c)) /
                             729;
            assoc(c, V) = (256. * v + sum(c.neighbors_from_here(), row.q) + sum(c.opposites_from_here(), row.g)) / 729;
        }
    }

    /// The same at a vertex with a large fan, by the waves of its ring.
    template <class Vertex, class Assoc>
    static void make_large_inner(const Vertex& v, const Assoc& assoc)
    {
        using namespace targets;
        const std::size_t n = v.valence();
        const ring_waves<Assoc, 2> e(assoc, v.neighbors(), n), d(assoc, v.opposites(), n);
        assoc(v, V) = (361. * v + e.mask({304, 0, 0}, 0) + d.mask({64, 0, 0}, 0)) / 729;
        std::int64_t turn = 0;
        for (const auto c : v.corners()) {
            using detail::kernel_b, detail::kernel_c, detail::kernel_q, detail::kernel_g;
            assoc(v, c.next_edge(), V) = (304. * v + e.mask(kernel_b(n), turn) + d.mask(kernel_c(n), turn - 1)) / 729;
            assoc(c, V) = (256. * v + e.mask(kernel_q(n), turn + 1) + d.mask(kernel_g(n), turn)) / 729;
            turn += 2;
        }
    }

    /// The boundary curve is the ternary cubic B-spline; a vertex with one face is a corner. docs/schemes.md.
    template <class Vertex, class Assoc, class LargeFaces>
    static void make_boundary(const Vertex& v, const Assoc& assoc, const LargeFaces& large)
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
};

} // namespace kith
