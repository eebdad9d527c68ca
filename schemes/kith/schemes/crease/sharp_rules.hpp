// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "boundary.hpp"
#include "creases.hpp"
#include "fading.hpp"

#include <kith/core/level/for_each.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace kith {

/// The rules of Catmull-Clark and Loop where a mesh is not smooth: at boundaries, creases, corners and darts, with the
/// blend of semi-sharp ones. DeRose, Kass & Truong 1998, section 3; case by case as in OpenSubdiv; docs/schemes.md.
template <level Level>
class sharp_rules {
public:
    /// Errors: mesh_error for sharp elements that the level does not have.
    sharp_rules(const Level& coarse, const creases& sharp, boundary_corner corners,
                boundary_curve curve = boundary_curve::cubic)
        : sharp_(&sharp), corners_(corners), curve_(curve), all_smooth_(sharp.empty() and coarse.is_closed())
    {
        if (sharp.empty())
            return;
        sharp.require_one_each(coarse);
        edge_is_sharp_.resize(coarse.edge_count());
        near_sharp_.resize(coarse.vertex_count());
        for (const auto& [edge, sharpness] : sharp.edges()) {
            const auto e = coarse.edges()[edge];
            edge_is_sharp_[edge] = true;
            near_sharp_[e.org().index()] = near_sharp_[e.dst().index()] = true;
        }
        for (const auto& [vertex, sharpness] : sharp.vertices())
            near_sharp_[vertex] = true;
        large_fans_ = sharp.large_fans(coarse);
    }

    /// The rule of all edges: smooth(e) where the scheme's own mask is all there is to it. It must not outlive this.
    template <class Smooth>
    [[nodiscard]] auto at_edges(const Smooth& smooth) const
    {
        return [this, smooth](const auto& r) { this->make_all(r.coarse.edges(), r.assoc, smooth); };
    }
    /// The same of all vertices.
    template <class Smooth>
    [[nodiscard]] auto at_vertices(const Smooth& smooth) const
    {
        return [this, smooth](const auto& r) { this->make_all(r.coarse.vertices(), r.assoc, smooth); };
    }

    /// Neither boundary nor crease.
    [[nodiscard]] bool is_smooth(const edge<Level>& e) const
    {
        return not e.is_boundary() and (edge_is_sharp_.empty() or not edge_is_sharp_[e.index()]);
    }
    [[nodiscard]] bool is_smooth(const vertex<Level>& v) const
    {
        return (near_sharp_.empty() or not near_sharp_[v.index()]) and not v.is_boundary();
    }

    /// A vertex stays (a corner), goes along the curve of a crease or the boundary, or by the scheme's own mask, as a
    /// dart does.
    enum class rule_kind : unsigned char { smooth, crease, corner };
    struct vertex_rule {
        rule_kind kind = rule_kind::smooth;
        std::size_t sharp_edges = 0;
        std::array<vertex<Level>, 2> ends; ///< of the first two of them: the neighbours along the curve

        explicit vertex_rule(const vertex<Level>& v) : ends{v, v} {}
        void add(const vertex<Level>& end)
        {
            if (sharp_edges < 2)
                ends[sharp_edges] = end;
            ++sharp_edges;
        }
    };
    /// The rule of a vertex that is not smooth, in the step from this level.
    [[nodiscard]] vertex_rule rule_of(const vertex<Level>& v) const { return classify(v).parent; }
    /// A corner of the surface, whatever is sharp there.
    [[nodiscard]] bool is_kept_corner(const vertex<Level>& v) const
    {
        return corners_ == boundary_corner::kept and v.is_boundary() and v.face_count() == 1;
    }

private:
    /// On native levels a loop that meets nothing rare is a loop of its own: a call would have it read all anew every
    /// time.
    template <class Range, mask_evaluator Space, class Smooth>
    void make_all(const Range& range, const Space& assoc, const Smooth& smooth_mask) const
    {
        const Smooth smooth = smooth_mask; // the compiler knows that a local copy has no aliases
        constexpr bool native = detail::ordered_by_faces<Level>;
        if constexpr (native)
            if (all_smooth_)
                return for_each(range, [&](auto x) { assoc(x, targets::V) = smooth(x); });
        for_each(range, [&](auto x) {
            if ((not native and all_smooth_) or is_smooth(x))
                assoc(x, targets::V) = smooth(x);
            else
                out_of_line([this, &assoc, &smooth](
                                auto y) { assoc(y, targets::V) = mask_of_sum(this->sum_at(y, assoc, smooth)); },
                            x);
        });
    }

    /// An edge that is not smooth has its midpoint, or a place between that and the smooth mask. What each comes to is
    /// a sum, so that no formula is compiled for each pair of masks.
    template <mask_evaluator Space, class Smooth>
    typename Space::sum sum_at(edge<Level> e, const Space& assoc, const Smooth& smooth) const
    {
        const double s = sharp_->sharpness(e);
        const bool stays_sharp = sharp_->method == crease_method::chaikin and
                                 sharp_->child_sharpness(e.org(), e, large_fans_) > 0 and
                                 sharp_->child_sharpness(e.dst(), e, large_fans_) > 0;
        const typename Space::sum middle = assoc.evaluate(average(e.org(), e.dst()));
        return s >= 1 or stays_sharp ? middle : between(s, middle, assoc.evaluate(smooth(e)), assoc);
    }

    /// The same of a vertex.
    template <mask_evaluator Space, class Smooth>
    typename Space::sum sum_at(vertex<Level> v, const Space& assoc, const Smooth& smooth) const
    {
        if (near_sharp_.empty() or not near_sharp_[v.index()]) // on the boundary, far from all creases
            return is_kept_corner(v) ? assoc.evaluate(v) : sum_on_curve(v, {v.first_rim(), v.last_rim()}, assoc);
        const auto [parent, child, weight] = classify(v);
        const auto by_rule = [&](const vertex_rule& rule) {
            return rule.kind == rule_kind::corner   ? assoc.evaluate(v)
                   : rule.kind == rule_kind::crease ? sum_on_curve(v, rule.ends, assoc)
                                                    : assoc.evaluate(smooth(v));
        };
        if (parent.kind == rule_kind::smooth or parent.kind == child.kind)
            return by_rule(parent);
        return between(weight, by_rule(parent), by_rule(child), assoc);
    }
    template <mask_evaluator Space>
    typename Space::sum sum_on_curve(const vertex<Level>& v, const std::array<vertex<Level>, 2>& ends,
                                     const Space& assoc) const
    {
        return v.is_boundary() and curve_ == boundary_curve::thirds
                   ? assoc.evaluate(thirds_curve_vertex(v, ends[0], ends[1]))
                   : assoc.evaluate(cubic_curve_vertex(v, ends[0], ends[1]));
    }
    template <mask_evaluator Space>
    static typename Space::sum between(double weight, const typename Space::sum& now, const typename Space::sum& later,
                                       const Space& assoc)
    {
        return assoc.evaluate(weight * mask_of_sum(now) + (1 - weight) * mask_of_sum(later));
    }

    struct classes {
        vertex_rule parent, child;
        double weight; ///< of the parent's rule where the two differ
    };

    static rule_kind kind_of(bool corner, std::size_t sharp_edges)
    {
        return corner or sharp_edges >= 3 ? rule_kind::corner
               : sharp_edges == 2         ? rule_kind::crease
                                          : rule_kind::smooth; // with one sharp edge: a dart
    }
    classes classify(const vertex<Level>& v) const
    {
        const double s = is_kept_corner(v) ? infinitely_sharp : sharp_->of_vertex(v.index());
        fading transition(sharp_->method);
        transition.add_vertex(s);
        vertex_rule parent(v), child(v);
        for (const auto e : v.edges()) {
            const double now = sharp_->sharpness(e);
            if (now <= 0)
                continue;
            const auto end = e.org() == v ? e.dst() : e.org();
            const double later = sharp_->child_sharpness(v, e, large_fans_);
            parent.add(end);
            if (later > 0)
                child.add(end);
            transition.add_edge(now, later);
        }
        parent.kind = kind_of(s > 0, parent.sharp_edges);
        child.kind = kind_of(s > 1, child.sharp_edges);
        return {parent, child, transition.weight()};
    }

    const creases* sharp_;
    boundary_corner corners_;
    boundary_curve curve_;
    bool all_smooth_;                              // nothing to look at
    std::vector<bool> edge_is_sharp_, near_sharp_; // empty: no creases
    std::vector<creases::large_fan> large_fans_;
};

} // namespace kith
