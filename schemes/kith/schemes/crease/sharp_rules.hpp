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
/// blend for semi-sharp elements. DeRose, Kass & Truong 1998, section 3; case by case as in OpenSubdiv;
/// docs/schemes.md.
template <level Level>
class sharp_rules {
public:
    /// Takes a level with its creases and the rules of its boundary. Errors: mesh_error for sharp elements that the
    /// level does not have.
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

    /// Returns the rule of all edges; smooth(e) is the scheme's own mask, for edges at which nothing is sharp. The rule
    /// must not outlive this object.
    template <class Smooth>
    [[nodiscard]] auto at_edges(const Smooth& smooth) const
    {
        return [this, smooth](const auto& r) { this->make_all(r.coarse.edges(), r.assoc, smooth); };
    }
    /// Returns the same for all vertices.
    template <class Smooth>
    [[nodiscard]] auto at_vertices(const Smooth& smooth) const
    {
        return [this, smooth](const auto& r) { this->make_all(r.coarse.vertices(), r.assoc, smooth); };
    }

    /// Returns true if the element is not on the boundary and has no sharpness; a vertex must also have no sharp edge.
    [[nodiscard]] bool is_smooth(const edge<Level>& e) const
    {
        return not e.is_boundary() and (edge_is_sharp_.empty() or not edge_is_sharp_[e.index()]);
    }
    [[nodiscard]] bool is_smooth(const vertex<Level>& v) const
    {
        return (near_sharp_.empty() or not near_sharp_[v.index()]) and not v.is_boundary();
    }

    /// The rules of a vertex: it stays (a corner), follows the curve of a crease or of the boundary, or the scheme's
    /// own mask, as a dart does.
    enum class rule_kind : unsigned char { smooth, crease, corner };
    struct vertex_rule {
        rule_kind kind = rule_kind::smooth;
        std::size_t sharp_edges = 0;
        std::array<vertex<Level>, 2> ends; ///< other ends of the first two: the neighbours along the curve

        explicit vertex_rule(const vertex<Level>& v) : ends{v, v} {}
        void add(const vertex<Level>& end)
        {
            if (sharp_edges < 2)
                ends[sharp_edges] = end;
            ++sharp_edges;
        }
    };
    /// Returns the rule, in the step from this level, of a vertex that is not smooth.
    [[nodiscard]] vertex_rule rule_of(const vertex<Level>& v) const { return classify(v).parent; }
    /// Returns true for a boundary vertex with one face if such corners are kept, whatever else is sharp there.
    [[nodiscard]] bool is_kept_corner(const vertex<Level>& v) const
    {
        return corners_ == boundary_corner::kept and v.is_boundary() and v.face_count() == 1;
    }

private:
    /// Makes the points of a range of elements. On native levels without sharp elements the loop has no other branch:
    /// with a call in it, the compiler would reload all values each time.
    template <class Range, mask_evaluator Space, class Smooth>
    void make_all(const Range& range, const Space& assoc, const Smooth& smooth_mask) const
    {
        const Smooth smooth = smooth_mask; // so that the compiler knows that it has no aliases
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

    /// Returns the point of an edge that is not smooth: its midpoint, or a blend of it and the smooth mask. The result
    /// is a sum, so that no formula is compiled for each pair of masks.
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

    /// Returns the same for a vertex.
    template <mask_evaluator Space, class Smooth>
    typename Space::sum sum_at(vertex<Level> v, const Space& assoc, const Smooth& smooth) const
    {
        if (near_sharp_.empty() or not near_sharp_[v.index()]) // on the boundary, with no crease at it
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
        double weight; ///< of the parent's rule, if the two differ
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
    bool all_smooth_;                              // no boundary and no creases
    std::vector<bool> edge_is_sharp_, near_sharp_; // empty if there are no creases
    std::vector<creases::large_fan> large_fans_;
};

} // namespace kith
