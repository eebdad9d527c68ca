// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/base/cos_turn.hpp>
#include <kith/crease/sharp_rules.hpp>
#include <kith/field/with_fields.hpp>
#include <kith/mask/mask.hpp>
#include <kith/step/scheme.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>

namespace kith {

/// What limit_rules say unless they say something else.
struct limit_defaults {
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
    /// After how many further steps a normal may be known where a position is: beside irregular vertices one or two.
    static constexpr int tangent_steps = 2;

protected:
    /// The weight of the j-th point of a ring by its angle, j/n of a turn.
    static auto cosine_wave(std::int64_t n)
    {
        return [n](std::size_t j) { return cos_turn(std::int64_t(j), n); };
    }
    static auto sine_wave(std::int64_t n)
    {
        return [n](std::size_t j) { return sin_turn(std::int64_t(j), n); };
    }
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
    static_assert(not detail::has_limit_position<Scheme>(),
                  "a scheme has a member limit_position, which nobody looks at; specialise kith::limit_rules for it");
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

/// A scheme with creases, and what they are on a level.
template <scheme Scheme, level Level>
struct creased_scheme {
    const Scheme& scheme;
    sharp_rules<Level> sharp;
};

/// The limit rules of schemes that have the members `sharpness` and `corners`; position and tangents take a
/// creased_scheme.
struct crease_limits : limit_defaults {
    template <scheme Scheme, level Level>
    static creased_scheme<Scheme, Level> on(const Scheme& scheme, const Level& level)
    {
        boundary_curve curve = boundary_curve::cubic;
        if constexpr (requires { curve = scheme.boundary; })
            curve = scheme.boundary;
        return {scheme, sharp_rules(level, scheme.sharpness, scheme.corners, curve)};
    }
    /// The limit at corners, and along boundaries and creases: 1/6, 2/3, 1/6, where a cubic B-spline curve ends up.
    template <level Level, class Use>
    static void position_on_curve(const sharp_rules<Level>& sharp, const vertex<Level>& v, const Use& use)
    {
        using kinds = typename sharp_rules<Level>::limit_kind;
        const auto [kind, ends] = sharp.limit_of(v);
        if (kind == kinds::corner)
            use(sum(v));
        else if (kind == kinds::curve)
            use((ends[0] + 4. * v + ends[1]) / 6);
    }
    /// A corner with one face lies in the plane of its two edges; at other corners and along creases each side has a
    /// plane of its own, and none is given.
    template <level Level, class Use>
    static void tangents_at_corner(const sharp_rules<Level>& sharp, const vertex<Level>& v, const Use& use)
    {
        using kinds = typename sharp_rules<Level>::limit_kind;
        if (v.is_boundary() and v.face_count() == 1 and sharp.limit_of(v).kind == kinds::corner)
            use(v.first_rim() - v, v.last_rim() - v);
    }

protected:
    struct ring_turns {
        bool inside;        ///< the ring spans a full turn, and not half of one
        std::int64_t turns; ///< a face at the vertex spans one of so many parts of a full turn
    };
    /// Nothing where the ring spans neither: at corners and along creases.
    template <level Level>
    static std::optional<ring_turns> turns_of_ring(const sharp_rules<Level>& sharp, const vertex<Level>& v)
    {
        const std::size_t k = v.face_count();
        if (sharp.is_smooth(v))
            return ring_turns{true, std::int64_t(k)};
        if (sharp.is_on_boundary_curve(v))
            return ring_turns{false, std::int64_t(2 * k)};
        return {};
    }
};

} // namespace kith
