// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/base/cos_turn.hpp>
#include <kith/crease/sharp_rules.hpp>
#include <kith/field/with_fields.hpp>
#include <kith/mask/by_valence.hpp>
#include <kith/mask/mask.hpp>
#include <kith/step/scheme.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
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
    /// After how many further steps a normal may be known where a position is: beside irregular vertices one or two.
    static constexpr int tangent_steps = 2;
    /// Whether a vertex without tangents will have none after further steps either.
    template <class Rules, vertex_element Vertex>
    static constexpr bool never_has_tangents(const Rules&, const Vertex&)
    {
        return false;
    }

protected:
    /// The weight of the j-th point of a ring by its angle, j/n of a turn: cos_turn and sin_turn, which are computed
    /// once for each n that meshes have. Precondition of what is returned: j <= n.
    static auto cosine_wave(std::int64_t n) { return kept_wave<cos_turn>(n); }
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
template <scheme_with_sharp_rules Scheme, level Level>
struct creased_scheme {
    const Scheme& scheme;
    sharp_rules<Level> sharp;
};

/// The limit rules of schemes with sharp_rules; position and tangents take a creased_scheme.
struct crease_limits : limit_defaults {
    /// The masks ask about the vertex's own faces alone.
    template <scheme_with_sharp_rules Scheme>
    static constexpr int rings(const Scheme&)
    {
        return 0;
    }
    template <scheme_with_sharp_rules Scheme, level Level>
    static creased_scheme<Scheme, Level> on(const Scheme& scheme, const Level& level)
    {
        return {scheme, sharp_rules(level, scheme.sharpness, scheme.corners, boundary_curve_of(scheme))};
    }
    /// The limit at corners, and along boundaries and creases: 1/6, 2/3, 1/6, where a cubic B-spline curve ends up.
    template <scheme_with_sharp_rules Scheme, level Level, class Use>
    static void position_on_curve(const creased_scheme<Scheme, Level>& s, const vertex<Level>& v, const Use& use)
    {
        const auto [kind, ends] = limit_of(s, v);
        if (kind == limit_kind::corner)
            use(sum(v));
        else if (kind == limit_kind::curve)
            use((ends[0] + 4. * v + ends[1]) / 6);
    }
    /// Corners and vertices of creases stay what they are, unless these decay.
    template <scheme_with_sharp_rules Scheme, level Level>
    static bool never_has_tangents(const creased_scheme<Scheme, Level>& s, const vertex<Level>& v)
    {
        return not s.sharp.is_smooth(v) and limit_of(s, v).kind != limit_kind::unknown and not turns_of_ring(s, v) and
               not is_corner_of_one_face(s, v);
    }
    /// A corner with one face lies in the plane of its two edges; at other corners and along creases each side has a
    /// plane of its own, and none is given.
    template <scheme_with_sharp_rules Scheme, level Level, class Use>
    static void tangents_at_corner(const creased_scheme<Scheme, Level>& s, const vertex<Level>& v, const Use& use)
    {
        if (is_corner_of_one_face(s, v))
            use(v.first_rim() - v, v.last_rim() - v);
    }

protected:
    struct ring_turns {
        bool inside;        ///< the ring spans a full turn, and not half of one
        std::int64_t turns; ///< a face at the vertex spans one of so many parts of a full turn
    };
    /// Nothing where the ring spans neither: at corners and along creases.
    template <scheme_with_sharp_rules Scheme, level Level>
    static std::optional<ring_turns> turns_of_ring(const creased_scheme<Scheme, Level>& s, const vertex<Level>& v)
    {
        const std::size_t k = v.face_count();
        if (s.sharp.is_smooth(v))
            return ring_turns{true, std::int64_t(k)};
        if (v.is_boundary() and k >= 2 and limit_of(s, v).kind == limit_kind::curve)
            return ring_turns{false, std::int64_t(2 * k)};
        return {};
    }

private:
    /// What the limit at a vertex that is not smooth depends on: nothing (a corner), a curve, or more than a mask can
    /// tell.
    enum class limit_kind : unsigned char { corner, curve, unknown };
    template <level Level>
    struct limit_rule {
        limit_kind kind;
        std::array<vertex<Level>, 2> ends; ///< the neighbours along the curve
    };
    template <scheme_with_sharp_rules Scheme, level Level>
    static bool is_corner_of_one_face(const creased_scheme<Scheme, Level>& s, const vertex<Level>& v)
    {
        return v.is_boundary() and v.face_count() == 1 and limit_of(s, v).kind == limit_kind::corner;
    }
    template <scheme_with_sharp_rules Scheme, level Level>
    static limit_rule<Level> limit_of(const creased_scheme<Scheme, Level>& s, const vertex<Level>& v)
    {
        using kinds = typename sharp_rules<Level>::rule_kind;
        const auto rule = s.sharp.rule_of(v);
        if (not is_known(s, v) or rule.kind == kinds::smooth)
            return {limit_kind::unknown, rule.ends};
        return {rule.kind == kinds::corner ? limit_kind::corner : limit_kind::curve, rule.ends};
    }
    /// Whether the rule of a vertex says its limit: what is semi-sharp has another rule on a later level, and the limit
    /// of the curve of thirds is not known.
    template <scheme_with_sharp_rules Scheme, level Level>
    static bool is_known(const creased_scheme<Scheme, Level>& s, const vertex<Level>& v)
    {
        if (s.sharp.is_kept_corner(v))
            return true;
        if (v.is_boundary() and boundary_curve_of(s.scheme) == boundary_curve::thirds)
            return false;
        const auto is_semi_sharp = [](double sharpness) { return 0 < sharpness and sharpness < infinitely_sharp; };
        for (const auto e : v.edges())
            if (is_semi_sharp(s.scheme.sharpness.sharpness(e)))
                return false;
        return not is_semi_sharp(s.scheme.sharpness.of_vertex(v.index()));
    }
};

} // namespace kith
