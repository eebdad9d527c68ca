// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/kernel/large_rings.hpp>
#include <kith/nasri_hasbini/boundary.hpp>
#include <kith/nasri_hasbini/polygons.hpp>
#include <kith/split/require_faces.hpp>
#include <kith/split/ternary_split.hpp>

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace kith {

/// Nasri-Hasbini: ternary refinement of bicubic B-splines, three times as fine per step, polygons of any kind.
/// Published (thesis 2.1.5) are the split and the masks of the regular part. The masks around extraordinary vertices,
/// in faces that are not quads and at irregular boundary vertices are in docs/schemes.md and not the original
/// authors'. C2 in the regular part. Extraordinary vertices and faces persist. Cost: O(corners), those of large faces
/// times the logarithm of their number.
struct nasri_hasbini {
    static constexpr auto traits()
    {
        return scheme_traits{.name = "nasri-hasbini",
                             .trusted = true,
                             .reach = [](int rings) { return (rings + 1) / 3 + 1; },
                             .ignores_numbers = [] { return true; }};
    }
    static constexpr auto columns() { return ternary_split::columns(); }

    template <running_step R>
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

        // All points (v), (v,e), (v,f) of a vertex are masks over its ring, so one loop over the vertices makes them
        // all.
        for_each(coarse.vertices(), [&](auto v) {
            if (v.is_boundary())
                rarely([&](auto x) { detail::make_ternary_boundary(x, assoc, large); }, v);
            else if (not has_quads_only(v))
                rarely([&](auto x) { detail::beside_polygons(x, assoc, rows_beside, large).make_all(); }, v);
            else if (v.valence() <= longest_row)
                make_inner(v, assoc, rows);
            else
                rarely([&](auto x) { make_large_inner(x, assoc); }, v);
        });

        ternary_split::connect(r);
    }

private:
    /// docs/schemes.md, Nasri-Hasbini, inner vertices.
    template <vertex_element Vertex, mask_evaluator Assoc, class Rows>
    static void make_inner(const Vertex& v, const Assoc& assoc, const Rows& rows)
    {
        using namespace targets;
        const auto first = v.first_corner();
        const auto ring = 304. * average(first.neighbors_from_here()) + 64. * average(first.opposites_from_here());
        assoc(v, V) = (361. * v + ring) / 729;
        const auto row = rows(v.valence());
        for (const auto c : v.corners()) {
            const auto e = c.next_edge();
            assoc(v, e, V) = (304. * v + sum(c.neighbors_from_here(), row.b) + sum(c.opposites_from_here(), row.c)) /
                             729;
            assoc(c, V) = (256. * v + sum(c.neighbors_from_here(), row.q) + sum(c.opposites_from_here(), row.g)) / 729;
        }
    }

    /// The same at a vertex with a large fan, by the waves of its ring.
    template <vertex_element Vertex, mask_evaluator Assoc>
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
};

} // namespace kith
#include <kith/compiled/nasri_hasbini.hpp>
