// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/base/cos_turn.hpp>
#include <kith/mask/large_rings.hpp>
#include <kith/mask/weight_rows.hpp>
#include <kith/split/require_faces.hpp>
#include <kith/split/triangle_split.hpp>
#include <kith/step/blocks.hpp>

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace kith {

/// Modified Butterfly: triangles, interpolating. Dyn, Gregory & Levin 1990; Zorin, Schroeder & Sweldens 1996, section 3.
/// An end of an edge is irregular if it lies inside and has not six neighbours. Boundary: the four-point curve; wings
/// beyond it are reflected. C1. Cost: O(corners), those of large fans times their logarithm.
struct butterfly {
    static constexpr auto traits()
    {
        return scheme_traits{.name = "butterfly",
                             .faces = face_shape::triangles,
                             .trusted = true,
                             .require = [](const auto& level, int) { require_three_faces<butterfly>(level); },
                             .reach = [](int rings) { return (rings + 1) / 2 + 1; },
                             .ignores_numbers = [] { return true; }};
    }
    static constexpr auto columns() { return triangle_split::columns(); }

    /// The weights of the neighbours of an irregular vertex of valence n, from the other end of the edge on; ZSS 1996.
    static std::vector<double> ring_weights(std::size_t n)
    {
        if (n == 3)
            return {5. / 12, -1. / 12, -1. / 12};
        if (n == 4)
            return {3. / 8, 0, -1. / 8, 0};
        std::vector<double> row;
        for (std::size_t j = 0; j < n; ++j) {
            const auto cosine = [&](std::size_t turns) { return cos_turn(std::int64_t(turns * j), std::int64_t(n)); };
            row.push_back((1. / 4 + cosine(1) + 1. / 2 * cosine(2)) / double(n));
        }
        return row;
    }

    /// The same weights for n >= 5 by the angle from the other end of the edge.
    static constexpr wave_kernel ring_kernel{1. / 4, 1. / 2, 1. / 4};

    template <class R>
    void operator()(const R& r) const
    {
        using namespace targets;
        using real = scalar_type<R>;
        const auto& [coarse, assoc, generation] = r;
        const weight_rows<real> rows(ring_weights);

        std::vector<fan_kind> kinds(coarse.vertex_count());
        for_each(coarse.vertices(), [&](auto v) {
            const std::size_t n = v.is_boundary() ? 6 : v.valence();
            kinds[v.index()] = n == 6 ? fan_kind::regular : irregular_fan(n);
            assoc(v, V) = v;
        });
        const large_fans large(coarse, kinds, [&assoc = assoc](const auto& v, std::size_t n) {
            return ring_waves<std::remove_cvref_t<decltype(assoc)>, 2>(assoc, v.neighbors(), n);
        });

        in_blocks(r, [&](const auto& block) {
            for_each(block.coarse.edges(), [&](auto e) {
                const auto x = e.org();
                const auto y = e.dst();
                if (e.is_boundary()) {
                    assoc(e, V) = 9. / 16 * (x + y) + -1. / 16 * (x.last_rim() + y.first_rim());
                    return;
                }
                const auto l = e.lcorner(); // of x
                const auto r = e.rcorner(); // of y
                std::vector<real> spare_x, spare_y;
                const auto ring = [&](auto c,
                                      auto& spare) { // of c's vertex, the other end of e being its first neighbour
                    const bool is_large = kinds[c.v().index()] == fan_kind::large;
                    const real* row = is_large ? nullptr : rows(c.v().valence(), spare);
                    return choose(
                        is_large,
                        [c, &large] {
                            const auto [sums, step] = large.at(c);
                            return sums.mask(ring_kernel, 2 * step);
                        },
                        [c, row] { return sum(c.neighbors_from_here(), row); });
                };
                const auto around = [&](auto c, auto& spare) { return 3. / 4 * c.v() + ring(c, spare); };
                const bool x_is_irregular = kinds[x.index()] != fan_kind::regular;
                const bool y_is_irregular = kinds[y.index()] != fan_kind::regular;
                if (x_is_irregular and y_is_irregular)
                    assoc(e, V) = (around(l, spare_x) + around(r, spare_y)) / 2;
                else if (x_is_irregular)
                    assoc(e, V) = around(l, spare_x);
                else if (y_is_irregular)
                    assoc(e, V) = around(r, spare_y);
                else
                    assoc(e, V) = 1. / 2 * (x + y) + 1. / 8 * (l.prev().v() + r.prev().v()) +
                                  -1. / 16 * (wing(l.next()) + wing(l.prev()) + (wing(r.next()) + wing(r.prev())));
            });

            triangle_split::connect(block);
        });
    }

private:
    /// The vertex across the next edge of c; beyond the boundary the reflection of the triangle's own third vertex.
    template <class Corner>
    static auto wing(const Corner& c)
    {
        return choose(
            c.is_boundary(),
            [c] { return c.v() + c.next().v() - c.prev().v(); },
            [c] { return sum(c.across().prev().v()); });
    }
};

} // namespace kith
