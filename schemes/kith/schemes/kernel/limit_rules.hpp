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

/// The functions and constants of limit_rules that do not define their own.
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
    /// Returns the first argument of position and tangents: the scheme, or an object with the facts that it needs about
    /// the whole level.
    template <scheme Scheme, level Level>
    static const Scheme& on(const Scheme& scheme, const Level&)
    {
        return scheme;
    }
    /// Returns the number of rings of faces, around a vertex's own faces, that the masks read.
    template <scheme Scheme>
    static constexpr int rings(const Scheme&)
    {
        return 2;
    }
    /// Returns the rings needed before a step for `rings` rings after it, in the search for limits without a mask:
    /// those of tiles.
    template <reaching_scheme Scheme>
    static constexpr int reach(const Scheme& scheme, int rings)
    {
        return reach_of(scheme, rings);
    }
    /// A promise, if true: the masks, counted from the first corner of a fan, are the same at all regular vertices. A
    /// vertex is regular here if all vertices within the rings are inner ones of regular valence, and all faces have
    /// one degree. The masks depend neither on where faces and other fans begin nor on which way edges run.
    /// limit_surface_of then reads them once for all these vertices.
    static constexpr bool are_alike_where_regular = false;
    /// The number of steps after its position is known in which a normal may become known: one or two beside irregular
    /// vertices.
    static constexpr int tangent_steps = 2;
    /// Returns true if a vertex without tangents will have none after further steps either.
    template <class Rules, vertex_element Vertex>
    static constexpr bool never_has_tangents(const Rules&, const Vertex&)
    {
        return false;
    }

protected:
    /// Returns a function of j: the weight of the j-th point of a ring by its angle, j/n of a turn. cosine_wave takes
    /// exact_cos, sine_wave sin_turn. The weights are computed once for each n that occurs. Precondition of the
    /// function: j <= n.
    static auto cosine_wave(std::int64_t n) { return kept_wave<exact_cos>(n); }
    static auto sine_wave(std::int64_t n) { return kept_wave<sin_turn>(n); }
    /// Calls use(first, second) with the tangents of a ring of n points, if no other points have weights.
    template <mask_range Range, class Use>
    static void use_first_wave(const Range& ring, std::int64_t n, const Use& use)
    {
        use(sum(ring, cosine_wave(n)), sum(ring, sine_wave(n)));
    }
};

/// The limits of a scheme. A scheme whose limits are known in closed form specialises this template, next to its own
/// definition. Its functions call use(mask), or use(first, second), unless no closed-form mask is known for an element:
///
///   template <>
///   struct kith::limit_rules<my_scheme> : kith::limit_defaults {
///       template <class Level>
///       static void position(const my_scheme& s, const kith::vertex<Level>& v, const auto& use);
///       template <class Level>
///       static void tangents(const my_scheme& s, const kith::vertex<Level>& v, const auto& use);
///   };
///
/// There are overloads for face<Level>, too, if faces shrink to one point of the surface. The two tangents are
/// counter-clockwise. Without a specialisation the limits of a scheme are found by refining (limit_surface).
/// Precondition: the specialisation comes before the first use.
template <scheme Scheme>
struct limit_rules : limit_defaults {
    static_assert(
        not detail::has_limit_position<Scheme>(),
        "a scheme has a member limit_position, which kith does not read; specialise kith::limit_rules for it");
};

/// The limit rules of a scheme with fields: those of the scheme without them.
template <scheme Scheme, class... Fields>
struct limit_rules<with_fields<Scheme, Fields...>> : limit_rules<Scheme> {
    template <level Level>
    static decltype(auto) on(const with_fields<Scheme, Fields...>& scheme, const Level& level)
    {
        return limit_rules<Scheme>::on(scheme.plain(), level);
    }
};

} // namespace kith
