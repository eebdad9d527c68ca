// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dart_weights.hpp"
#include "sectors.hpp"
#include "sharp_rules.hpp"

#include <kith/schemes/kernel/limit_rules.hpp>

#include <array>
#include <cstddef>

namespace kith {

/// A scheme with creases, and the rules of its creases on a level.
template <scheme_with_sharp_rules Scheme, level Level>
struct creased_scheme {
    const Scheme& scheme;
    sharp_rules<Level> sharp;
};

/// The limit rules of schemes with sharp_rules; position and tangents take a creased_scheme. Functions with a parameter
/// `Rules` require these members, by which the masks of the schemes differ:
///
///   use_ring(c, n, use)      calls use with the two tangent masks of a ring of n faces that begins at corner c
///   across(sector, r)        the row across a curve whose vertex rule is r, 1 - 2r, r; for two faces or more
///   between(sector)          the row from a corner of the surface to the middle of a sector
///   across_one(sector, r)    the row into the only face of a sector
///   most_faces_of_planes     the most faces of a sector at a corner that has a tangent plane
///   darts(scheme, n)         the weights of dart_matrix, or null; has_opposites says which points it has
///
/// These functions are out of line: few vertices lie on creases, and inlining all of the functions takes minutes of
/// compilation.
struct crease_limits : limit_defaults {
    static constexpr bool are_alike_where_regular = true;
    /// Returns 0: the masks read the vertex's own faces only.
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
    /// Calls use(mask) with the limit of a corner, or of a vertex on the curve of a boundary or crease. The weights are
    /// 1/6, 2/3, 1/6 for a cubic B-spline and 1/5, 3/5, 1/5 for the curve of thirds.
    template <scheme_with_sharp_rules Scheme, level Level, class Use>
    [[gnu::noinline]] static void position_on_curve(const creased_scheme<Scheme, Level>& s, const vertex<Level>& v,
                                                    const Use& use)
    {
        const auto [kind, ends] = limit_of(s, v);
        if (kind == limit_kind::corner)
            use(sum(v));
        else if (kind == limit_kind::curve and curve_weight(s, v) == 1. / 6)
            use((ends[0] + 3. * v + ends[1]) / 5);
        else if (kind == limit_kind::curve)
            use((ends[0] + 4. * v + ends[1]) / 6);
    }
    /// Calls use(mask) with the limit of a dart.
    template <class Rules, scheme_with_sharp_rules Scheme, level Level, class Use>
    [[gnu::noinline]] static void position_of_dart(const creased_scheme<Scheme, Level>& s, const vertex<Level>& v,
                                                   const Use& use)
    {
        if (limit_of(s, v).kind == limit_kind::dart)
            for_each_sector(v, s.scheme.sharpness, [&](const vertex_sector<Level>& part) {
                if (const double* weights = Rules::darts(s.scheme, part.faces))
                    use(weighted(dart_row<Rules>(part, weights)));
            });
    }
    /// Returns true for an inner vertex on a crease and for a corner, except a boundary corner with one face: these
    /// have no single tangent plane. Returns false if sharpness still decays there.
    template <scheme_with_sharp_rules Scheme, level Level>
    static bool never_has_tangents(const creased_scheme<Scheme, Level>& s, const vertex<Level>& v)
    {
        if (s.sharp.is_smooth(v))
            return false;
        const auto kind = limit_of(s, v).kind;
        return kind == limit_kind::corner  ? not(v.is_boundary() and v.face_count() == 1)
               : kind == limit_kind::curve ? not v.is_boundary()
                                           : false;
    }
    /// Calls use(first, second) with the two edges of a corner with one face, which lies in their plane. At other
    /// corners and along creases each side has its own plane, and use is not called.
    template <scheme_with_sharp_rules Scheme, level Level, class Use>
    static void tangents_at_corner(const creased_scheme<Scheme, Level>& s, const vertex<Level>& v, const Use& use)
    {
        if (v.is_boundary() and v.face_count() == 1 and limit_of(s, v).kind == limit_kind::corner)
            use(v.first_rim() - v, v.last_rim() - v);
    }
    /// Calls use(first, second) with the tangents of a vertex that is not smooth. They exist if all its faces lie on
    /// one side of a curve, if it is a corner of one face, and at a dart. A smoothed corner has the plane of its two
    /// edges as well: the curve through it bends in this plane, and faster than its face. Precondition: the faces at v
    /// have the shape that the masks are for.
    template <class Rules, scheme_with_sharp_rules Scheme, level Level, class Use>
    [[gnu::noinline]] static void tangents_beside_creases(const creased_scheme<Scheme, Level>& s,
                                                          const vertex<Level>& v, const Use& use)
    {
        const auto kind = limit_of(s, v).kind;
        if (kind == limit_kind::corner)
            return tangents_at_corner(s, v, use);
        if (kind == limit_kind::dart or (kind == limit_kind::curve and v.is_boundary()))
            for_each_sector(v, s.scheme.sharpness, [&](const vertex_sector<Level>& part) {
                if (kind == limit_kind::curve and part.faces == 1 and curve_weight(s, v) != 1. / 6)
                    use(part.first_end() - v, part.last_end() - v);
                else
                    use_side<Rules>(
                        s, kind, part, [&](const auto& along, const auto&, const auto& across) { use(along, across); });
            });
    }
    /// Calls use(sector, is_half_turn, first, last, middle) for each sector of a vertex that is not smooth. `first` and
    /// `last` are the masks of the tangents along the edges that begin and end the sector, outwards; `middle` is that
    /// of a direction between them. Beside a curve the sector is half a turn, and the edges only span the plane of its
    /// tangents. Calls nothing if a sharp edge still decays. Precondition: the faces at v have the shape that the masks
    /// are for.
    template <class Rules, scheme_with_sharp_rules Scheme, level Level, class Use>
    [[gnu::noinline]] static void sides_beside_creases(const creased_scheme<Scheme, Level>& s, const vertex<Level>& v,
                                                       const Use& use)
    {
        if (s.sharp.is_smooth(v))
            return;
        if (const auto kind = limit_of(s, v).kind; kind != limit_kind::unknown)
            for_each_sector(v, s.scheme.sharpness, [&](const vertex_sector<Level>& part) {
                use_side<Rules>(
                    s, kind, part, [&](const auto&... masks) { use(part, kind != limit_kind::corner, masks...); });
            });
    }
    /// Calls use(sector) for each sector of a vertex, in the order of sides_beside_creases.
    template <scheme_with_sharp_rules Scheme, level Level, class Use>
    static void sectors(const creased_scheme<Scheme, Level>& s, const vertex<Level>& v, const Use& use)
    {
        for_each_sector(v, s.scheme.sharpness, use);
    }

private:
    /// The kinds of limit at a vertex that is not smooth, by the points that it depends on: the vertex alone (a
    /// corner), a curve, the ring around the end of a crease, or points that no mask knows.
    enum class limit_kind : unsigned char { corner, curve, dart, unknown };
    template <level Level>
    struct limit_rule {
        limit_kind kind;
        std::array<vertex<Level>, 2> ends; ///< the neighbours along the curve
    };
    template <scheme_with_sharp_rules Scheme, level Level>
    static limit_rule<Level> limit_of(const creased_scheme<Scheme, Level>& s, const vertex<Level>& v)
    {
        using kinds = typename sharp_rules<Level>::rule_kind;
        const auto rule = s.sharp.rule_of(v);
        const auto kind = not is_known(s, v)           ? limit_kind::unknown
                          : rule.kind == kinds::corner ? limit_kind::corner
                          : rule.kind == kinds::crease ? limit_kind::curve
                          : rule.sharp_edges == 1      ? limit_kind::dart
                                                       : limit_kind::unknown;
        return {kind, rule.ends};
    }
    /// Returns true if the rule of a vertex determines its limit. At semi-sharp elements the rule changes on a later
    /// level.
    template <scheme_with_sharp_rules Scheme, level Level>
    static bool is_known(const creased_scheme<Scheme, Level>& s, const vertex<Level>& v)
    {
        if (s.sharp.is_kept_corner(v))
            return true;
        const auto is_semi_sharp = [](double sharpness) { return 0 < sharpness and sharpness < infinitely_sharp; };
        for (const auto e : v.edges())
            if (is_semi_sharp(s.scheme.sharpness.sharpness(e)))
                return false;
        return not is_semi_sharp(s.scheme.sharpness.of_vertex(v.index()));
    }
    /// Returns the weight of each neighbour in the vertex rule of the curve through v.
    template <scheme_with_sharp_rules Scheme, level Level>
    static double curve_weight(const creased_scheme<Scheme, Level>& s, const vertex<Level>& v)
    {
        return v.is_boundary() and boundary_curve_of(s.scheme) == boundary_curve::thirds ? 1. / 6 : 1. / 8;
    }
    template <class Rules, level Level>
    static mask_row<Level> dart_row(const vertex_sector<Level>& part, const double* weights)
    {
        return row_over<Rules::has_opposites>(
            part,
            weights[0],
            [&](std::size_t j) { return weights[1 + j]; },
            [&](std::size_t j) { return weights[1 + part.faces + j]; });
    }
    template <class Rules, scheme_with_sharp_rules Scheme, level Level, class Use>
    static void use_side(const creased_scheme<Scheme, Level>& s, limit_kind kind, const vertex_sector<Level>& part,
                         const Use& use)
    {
        const auto v = part.first.v(), a = part.first_end(), z = part.last_end();
        const auto n = std::int64_t(part.faces);
        if (kind == limit_kind::dart) {
            const std::size_t points = 1 + part.faces * (Rules::has_opposites ? 2 : 1);
            if (const double* weights = Rules::darts(s.scheme, part.faces)) {
                const auto row = dart_row<Rules>(part, weights + points);
                Rules::use_ring(part.first, n, [&](const auto&, const auto& sine) {
                    use(weighted(row), -1. * weighted(row), sine);
                });
            }
        } else if (kind == limit_kind::curve and part.faces > 1) {
            use(a - z, z - a, weighted(Rules::across(part, curve_weight(s, v))));
        } else if (kind == limit_kind::curve) {
            const auto row = Rules::across_one(part, curve_weight(s, v));
            if (curve_weight(s, v) == 1. / 6)
                use(a - z, z - a, weighted(row)); // the curve bends less than its face
            else
                use(a - v, z - v, weighted(row));
        } else if (part.is_closed) {
            Rules::use_ring(part.first, n, [&](const auto& cosine, const auto& sine) {
                if (part.has_sharp_edge)
                    use(a - v, v - a, sine);
                else
                    use(cosine, -1. * cosine, sine);
            });
        } else {
            use(a - v, z - v, weighted(part.faces > 1 ? Rules::between(part) : Rules::across_one(part, 0)));
        }
    }
};

} // namespace kith
