// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "library.hpp"
#include "nasri_hasbini_kernels.hpp"
#include "ternary_split.hpp"

#include <kith/weight_rows.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace kith {

/// Nasri-Hasbini: ternary refinement of bicubic B-splines, three times as fine per step, polygons of any kind.
/// Published (thesis 2.1.5) are the split and the masks of the regular part. The masks around extraordinary vertices, in
/// faces that are not quads and at irregular boundary vertices are derived in docs/schemes.md and not the original
/// authors'. C2 in the regular part. Extraordinary vertices and faces persist. Cost: O(sum of squared valences and face
/// degrees).
struct nasri_hasbini {
    static constexpr auto traits()
    {
        return scheme_traits{.name = "nasri-hasbini",
                             .trusted = true,
                             .next = [](const counts& c, int) { return ternary_split::next(c); },
                             .reach = [](int rings) { return (rings + 1) / 3 + 1; }};
    }
    static constexpr auto columns() { return ternary_split::columns(); }

    static nasri_hasbini like(library other)
    {
        if (other != library::kith)
            refuse_preset<nasri_hasbini>("kith alone");
        return {};
    }

    /// Inside, among quads, the left eigenvector of the masks; on the boundary that of the curve, whose corners stay.
    /// docs/schemes.md. `use(mask)` is called unless no closed mask is known for v.
    template <class Level, class Use>
    void limit_position(const vertex<Level>& v, const Use& use) const
    {
        if (v.is_boundary() and v.face_count() == 1)
            use(sum(v));
        else if (v.is_boundary())
            use((v.first_rim() + 4. * v + v.last_rim()) / 6);
        else if (has_quads_only(v))
            use((4. * v + 4. * average(v.neighbors()) + average(v.opposites())) / 9);
    }
    /// Two tangents inside, among quads, counter-clockwise; docs/schemes.md.
    template <class Level, class Use>
    void limit_tangents(const vertex<Level>& v, const Use& use) const
    {
        const auto n = std::int64_t(v.valence());
        if (v.is_boundary() or n < 3 or not has_quads_only(v))
            return;
        const double y = n == 3 ? 11. / 43 : n == 4 ? 1 / (2 * detail::sqrt2) : 1 / (3 * detail::sqrt2);
        const auto cosine = [n](std::int64_t half_steps) { return cos_turn(half_steps, 2 * n); };
        const auto sine = [n](std::int64_t half_steps) { return sin_turn(half_steps, 2 * n); };
        const auto wave = [&v, y](auto f) {
            return sum(v.neighbors(), [f](std::size_t j) { return f(2 * std::int64_t(j)); }) +
                   sum(v.opposites(), [f, y](std::size_t j) { return y * f(2 * std::int64_t(j) + 1); });
        };
        use(wave(cosine), wave(sine));
    }

    template <class R>
    void operator()(const R& r) const
    {
        using namespace targets;
        using real = scalar_type<R>;
        const auto& [coarse, assoc, generation] = r;
        const ternary_rows<real> rows;
        const polygon_rows& beside_polygons = polygon_rows::shared();

        // All points (v), (v,e), (v,f) of a vertex are masks over its ring, so one loop over the vertices makes them all.
        for_each(coarse.vertices(), [&](auto v) {
            if (v.is_boundary())
                make_boundary(v, assoc);
            else if (has_quads_only(v))
                make_inner(v, assoc, rows);
            else
                make_beside_polygons<real>(v, assoc, beside_polygons);
        });

        ternary_split::connect(r);
    }

private:
    template <class Vertex>
    static bool has_quads_only(const Vertex& v)
    {
        for (const auto& c : v.corners())
            if (c.f().degree() != 4)
                return false;
        return true;
    }

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

    /// The boundary curve is the ternary cubic B-spline; a vertex with one face is a corner. docs/schemes.md.
    template <class Vertex, class Assoc>
    static void make_boundary(const Vertex& v, const Assoc& assoc)
    {
        using namespace targets;
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

    /// The vertex opposite v in its face; in a face that is not a quad a point that stands for it.
    template <class Corner>
    static auto diagonal(const Corner& c)
    {
        const std::size_t m = c.f().degree();
        return choose(
            m == 4,
            [c] { return sum(c.next().next().v()); },
            [c, m] { return sum(c.vertices_from_here(), [m](std::size_t k) { return diagonal_weight(k, m); }); });
    }

    /// docs/schemes.md, Nasri-Hasbini, faces that are not quads. The ring weights of the quad rule are redistributed: what
    /// belongs to a special face (one that holds the new point) is spent on the corners of that face by its own kernel.
    template <class Real, class Vertex, class Assoc>
    static void make_beside_polygons(const Vertex& v, const Assoc& assoc, const polygon_rows& rows)
    {
        using namespace targets;
        std::vector<decltype(v.first_corner())> ring;
        for (const auto c : v.corners())
            ring.push_back(c);
        const std::size_t n = ring.size();
        std::vector<std::pair<Vertex, Real>> row;
        std::vector<double> block(n); // of each special face
        polygon_rows::spare spare, spare_of_face;
        const auto make = [&](auto&& target, std::size_t i, ternary_point point) {
            const auto is_special = [&](std::size_t j) {
                const bool near = point == ternary_point::vertex or j == i or
                                  (point == ternary_point::edge and (j + 1) % n == i);
                return near and ring[j].f().degree() != 4;
            };
            std::size_t specials = 0;
            for (std::size_t j = 0; j < n; ++j)
                specials += is_special(j);
            row.clear();
            std::fill(block.begin(), block.end(), 0.);
            const double own = center_weight(point);
            const auto around = rows.around(point, n, spare);
            for (std::size_t j = 0; j < n; ++j) {
                if (is_special(j))
                    block[j] += own / double(specials);
                const std::size_t before = (j + n - 1) % n; // e_j lies between faces j-1 and j
                const double e = around.neighbors[(j + n - i) % n];
                const double d = around.opposites[(j + n - i) % n];
                const int sharing = int(is_special(j)) + int(is_special(before));
                if (sharing == 0)
                    row.emplace_back(ring[j].next().v(), Real(e));
                if (is_special(j))
                    block[j] += e / sharing;
                if (is_special(before))
                    block[before] += e / sharing;
                if (is_special(j))
                    block[j] += d;
                else if (const std::size_t m = ring[j].f().degree(); m == 4)
                    row.emplace_back(ring[j].next().next().v(), Real(d));
                else
                    spend(row, ring[j], d, [w = rows.diagonal(m, spare_of_face)](std::size_t k) { return w[k]; });
            }
            if (specials == 0)
                row.emplace_back(v, Real(own));
            for (std::size_t j = 0; j < n; ++j)
                if (is_special(j)) {
                    const std::size_t m = ring[j].f().degree();
                    const bool mirrored = point == ternary_point::edge and j != i;
                    spend(row, ring[j], block[j], [=, w = rows.special(point, m, spare_of_face)](std::size_t k) {
                        return w[mirrored ? (m - k) % m : k];
                    });
                }
            target = weighted(row) / 729;
        };
        make(assoc(v, V), 0, ternary_point::vertex);
        for (std::size_t i = 0; i < n; ++i) {
            make(assoc(v, ring[i].next_edge(), V), i, ternary_point::edge);
            make(assoc(ring[i], V), i, ternary_point::face);
        }
    }

    /// Adds the corners of c's face to a row, counted from c.
    template <class Row, class Corner, class WeightOf>
    static void spend(Row& row, const Corner& c, double total, const WeightOf& weight_of)
    {
        std::size_t k = 0;
        for (const auto u : c.vertices_from_here()) {
            if (const double weight = weight_of(k++); weight != 0)
                row.emplace_back(u, typename Row::value_type::second_type(total * weight));
        }
    }
};

} // namespace kith
