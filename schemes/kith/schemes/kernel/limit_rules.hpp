// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/exact_cos.hpp>
#include <kith/core/mask/by_valence.hpp>
#include <kith/core/mask/mask.hpp>
#include <kith/fields/with_fields.hpp>
#include <kith/numbering/step/scheme.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace kith {

/// What limit_rules say unless they say something else.
class limit_defaults {
    template <double (*Wave)(std::int64_t, std::int64_t)>
    static auto kept_wave(std::int64_t n)
    {
        static const rows_by_valence<double> rows([](std::size_t size) {
            std::vector<double> row;
            for (std::size_t j = 0; j <= size; ++j)
                row.push_back(Wave(std::int64_t(j), std::int64_t(size)));
            return row;
        });
        const double* const row = n <= std::int64_t(longest_row) ? rows(std::size_t(n)) : nullptr;
        return [n, row](std::size_t j) { return row != nullptr ? row[j] : Wave(std::int64_t(j), n); };
    }

public:
    /// The first argument of position and tangents: the scheme, or what it needs to know of a level as a whole.
    template <scheme Scheme, level Level>
    static const Scheme& on(const Scheme& scheme, const Level&)
    {
        return scheme;
    }
    /// How many rings of faces around a vertex's own the masks ask about.
    template <scheme Scheme>
    static constexpr int rings(const Scheme&)
    {
        return 2;
    }
    /// The rings that a step uses up, for the search of limits without a mask: those of tiles.
    template <reaching_scheme Scheme>
    static constexpr int reach(const Scheme& scheme, int rings)
    {
        return reach_of(scheme, rings);
    }
    /// True if the masks, counted from the first corner of a fan, are the same at all inner vertices of regular valence
    /// that have only such vertices, and faces of one degree, within their rings. These masks ask neither where faces
    /// and other fans begin nor which way edges run. Then limit_surface_of reads them once for all these vertices.
    static constexpr bool are_alike_where_regular = false;
    /// After how many further steps a normal may be known where a position is: beside irregular vertices one or two.
    static constexpr int tangent_steps = 2;
    /// Whether a vertex without tangents will have none after further steps either.
    template <class Rules, vertex_element Vertex>
    static constexpr bool never_has_tangents(const Rules&, const Vertex&)
    {
        return false;
    }

protected:
    /// The weight of the j-th point of a ring by its angle, j/n of a turn: exact_cos and sin_turn, which are computed
    /// once for each n that meshes have. Precondition of what is returned: j <= n.
    static auto cosine_wave(std::int64_t n) { return kept_wave<exact_cos>(n); }
    static auto sine_wave(std::int64_t n) { return kept_wave<sin_turn>(n); }
    /// The tangents of a ring of n points that are all that has a weight.
    template <mask_range Range, class Use>
    static void use_first_wave(const Range& ring, std::int64_t n, const Use& use)
    {
        use(sum(ring, cosine_wave(n)), sum(ring, sine_wave(n)));
    }
};

/// Where the surface of a scheme ends up. A scheme whose limits are known in closed form specialises this, beside its
/// own text, by functions that call use(mask), or use(first, second), unless no closed mask is known for an element:
///
///   template <>
///   struct kith::limit_rules<my_scheme> : kith::limit_defaults {
///       template <class Level>
///       static void position(const my_scheme& s, const kith::vertex<Level>& v, const auto& use);
///       template <class Level>
///       static void tangents(const my_scheme& s, const kith::vertex<Level>& v, const auto& use);
///   };
///
/// and of face<Level> where faces go to one point of it, too; tangents are two there, counter-clockwise. One without
/// them has its limits found by refining (limit_surface). Precondition: specialised before limits are asked for.
template <scheme Scheme>
struct limit_rules : limit_defaults {
    static_assert(
        not detail::has_limit_position<Scheme>(),
        "a scheme has a member limit_position, which kith does not read; specialise kith::limit_rules for it");
};

/// With fields beside it a scheme has the limits that it has without.
template <scheme Scheme, class... Fields>
struct limit_rules<with_fields<Scheme, Fields...>> : limit_rules<Scheme> {
    template <level Level>
    static decltype(auto) on(const with_fields<Scheme, Fields...>& scheme, const Level& level)
    {
        return limit_rules<Scheme>::on(scheme.plain(), level);
    }
};

} // namespace kith
