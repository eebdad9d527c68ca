// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "find_seams.hpp"

#include <kith/fields/level_by_corners.hpp>
#include <kith/fields/rules/inherit.hpp>
#include <kith/fields/rules/linear_masks.hpp>
#include <kith/numbering/step/children.hpp>
#include <kith/numbering/step/refinement.hpp>
#include <kith/schemes/crease/fading.hpp>

#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith {

/// The values at the corners of a level, as the new vertices have them in the faces of the next level. A face, and a
/// vertex or edge away from seams, have one value, by the masks of the scheme itself. In these masks a neighbour has
/// the value on this side of its own seams. Along a seam each side is a separate surface with a boundary.
template <class T, finished_step Step>
class varied_level {
    using level_type = std::remove_cvref_t<decltype(std::declval<const Step&>().coarse)>;
    using view_type = level_by_corners<level_type>;
    using tuple = std::pair<tuple_kind, std::size_t>;

public:
    struct value_and_mark {
        T value;
        corner_rule rule;
    };

    /// Takes a step, values and marks, all of which must outlive this object.
    varied_level(const Step& step, std::span<const T> values, std::span<const corner_mark> marks,
                 face_varying_linear linear)
        : step_(step)
        , view_(step.coarse)
        , values_(values)
        , marks_(marks)
        , linear_(linear)
        , old_values_(step.coarse, values)
        , large_fans_(creases_of_level().large_fans(view_))
        , at_corners_(values.size())
        , rules_(values.size(), corner_rule::of_vertex)
    {
        corner_values<T, level_type> made(step.coarse, values);
        run_scheme<connect::nothing, false>(
            view_, step.scheme, step.generation, step.ids, detail::columns_of_step(step), made);
        smooth_ = made.take();
        detail::for_parts(view_.vertex_count(), view_type::parallel, [&](std::size_t begin, std::size_t end) {
            for (std::size_t v = begin; v < end; ++v)
                make_at_seams(view_.vertices()[v]);
        });
    }

    /// Returns the value of a new vertex in a new face, and its rule on the next level. Both elements are given by the
    /// tuples that gave birth to them.
    [[nodiscard]] value_and_mark at(const tuple& face, const tuple& vertex, std::size_t new_vertex) const
    {
        if (vertex.first == tuple_kind::v) {
            const auto c = view_.corners()[face.second];
            if (rules_[c.index()] != corner_rule::of_vertex)
                return {at_corners_[c.index()], rules_[c.index()]};
        } else if (vertex.first == tuple_kind::e) {
            const auto c = side(face, vertex.second);
            if (marks_[c.index()].seam)
                return {masks::middle(values_[c.index()], values_[c.next().index()]),
                        linear_ == face_varying_linear::boundaries ? corner_rule::corner : corner_rule::curve};
            if (c.is_boundary() and linear_ == face_varying_linear::boundaries)
                return {smooth_[new_vertex], corner_rule::corner};
        }
        return {smooth_[new_vertex], corner_rule::of_vertex};
    }
    /// Returns true if the edge of a new face from one new vertex to another lies on a seam.
    [[nodiscard]] bool is_seam(const tuple& face, const tuple& from, const tuple& to) const
    {
        const bool along_edge = (from.first == tuple_kind::v) != (to.first == tuple_kind::v) and
                                (from.first == tuple_kind::e) != (to.first == tuple_kind::e);
        return along_edge and marks_[side(face, from.first == tuple_kind::e ? from.second : to.second).index()].seam;
    }

private:
    using masks = detail::linear_masks_of<T, std::remove_cvref_t<decltype(std::declval<const Step&>().ids.vertices)>>;
    using span_type = corner_span<view_type>;

    [[nodiscard]] const creases& creases_of_level() const { return step_.scheme.sharpness; }

    /// Returns the corner before an edge in the old face that gave birth to a new one.
    [[nodiscard]] corner<view_type> side(const tuple& face, std::size_t edge) const
    {
        if (face.first != tuple_kind::f) {
            const auto c = view_.corners()[face.second];
            return c.halfedge() / 2 == edge ? c : c.prev();
        }
        const auto left = view_.edges()[edge].lcorner();
        return left.f().index() == face.second ? left : left.across();
    }

    void make_at_seams(const vertex<view_type>& v)
    {
        if (marks_[v.first_corner().index()].rule == corner_rule::of_vertex)
            return;
        for_each_span(v, marks_, [&](const span_type& span) {
            const auto [value, rule] = next_value(v, span);
            span.for_corners([&, &value = value, &rule = rule](const auto& c) {
                at_corners_[c.index()] = value;
                rules_[c.index()] = rule;
            });
        });
    }

    /// The sharpness inside a span: whether there is any on this level and on the next one, and the weight of the
    /// sharper rule in between.
    struct sharp_inside {
        bool now, later;
        double weight;
    };
    [[nodiscard]] sharp_inside look_inside(const vertex<view_type>& v, const span_type& span) const
    {
        const creases& sharp = creases_of_level();
        const double s = sharp.of_vertex(v.index());
        sharp_inside result{s > 0, s > 1, 0};
        fading transition(sharp.method);
        transition.add_vertex(s);
        span.for_inner_edges([&](const auto& e) {
            const double now = sharp.sharpness(e);
            if (now <= 0)
                return;
            const double later = sharp.child_sharpness(v, e, large_fans_);
            result.now = true;
            result.later = result.later or later > 0;
            transition.add_edge(now, later);
        });
        result.weight = transition.weight();
        return result;
    }
    [[nodiscard]] bool stays_semi_sharp(const vertex<view_type>& v) const
    {
        for (const auto e : v.edges())
            if (const double later = creases_of_level().child_sharpness(v, e, large_fans_);
                later > 0 and later < infinitely_sharp)
                return true;
        return false;
    }

    [[nodiscard]] value_and_mark next_value(const vertex<view_type>& v, const span_type& span) const
    {
        const auto& [rule, seam] = marks_[span.first.index()];
        if (rule == corner_rule::curve) {
            const sharp_inside inside = look_inside(v, span);
            return {inside.later ? here(span) : along(span, inside.now ? inside.weight : 0), rule};
        }
        if (rule == corner_rule::dependent) {
            sharp_inside other{};
            for_each_span(v, marks_, [&](const span_type& s) {
                if (not(s.first == span.first))
                    other = look_inside(v, s);
            });
            if (not stays_semi_sharp(v))
                return {along(span, other.weight), corner_rule::curve};
            return {here(span), other.later ? rule : corner_rule::curve};
        }
        return {here(span), rule};
    }
    [[nodiscard]] const T& here(const span_type& span) const { return values_[span.first.index()]; }
    /// Returns a blend of the value, which has this weight, and the curve along the ends of the span.
    [[nodiscard]] T along(const span_type& span, double weight) const
    {
        const auto v = span.first.v(), before = span.first.next().v(), after = span.last.prev().v();
        const auto blended = [&](const auto& curve) {
            if (weight == 0)
                return store(curve);
            return store(weight * v + (1 - weight) * curve);
        };
        return boundary_curve_of(step_.scheme) == boundary_curve::thirds
                   ? blended(thirds_curve_vertex(v, before, after))
                   : blended(cubic_curve_vertex(v, before, after));
    }
    template <mask Mask>
    [[nodiscard]] T store(const Mask& mask) const
    {
        return affine<T>::store(mask.evaluate(old_values_));
    }

    const Step& step_;
    view_type view_;
    std::span<const T> values_;
    std::span<const corner_mark> marks_;
    face_varying_linear linear_;
    corner_values<T, level_type> old_values_;
    std::vector<creases::large_fan> large_fans_;
    storage<T> smooth_, at_corners_; ///< of new vertices; of old vertices at seams, by corner
    storage<corner_rule> rules_;     ///< of old vertices on the next level, by corner
};

} // namespace kith
