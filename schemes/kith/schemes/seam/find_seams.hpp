// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "spans.hpp"

#include <kith/core/base/for_parts.hpp>
#include <kith/core/base/storage.hpp>
#include <kith/core/level/level_elements.hpp>
#include <kith/schemes/crease/boundary.hpp>
#include <kith/schemes/crease/creases.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <span>
#include <vector>

namespace kith {

/// The places where values at corners stay linear: along seams and boundaries, or everywhere. These are OpenSubdiv's
/// choices, by its names.
enum class face_varying_linear : unsigned char {
    none,          ///< nowhere: seams are smooth curves, also around a vertex where a single face lies between them
    corners_only,  ///< around a vertex where a single face lies between seams
    corners_plus1, ///< as corners_only, and where three values or more meet, or seams and infinitely sharp edges
    corners_plus2, ///< as corners_plus1, and where seams end, or one of two values is at a corner
    boundaries,    ///< along all seams and boundaries
    all            ///< everywhere: linear inside each face
};

/// A search for the seams of values at the corners of a level, and for the rules of the values there.
template <class T, level Level>
    requires std::equality_comparable<T>
class seam_finder {
public:
    /// Takes a level, values and creases, all of which must outlive this object.
    seam_finder(const Level& level, std::span<const T> values, const creases& sharp, boundary_corner corners,
                face_varying_linear linear)
        : level_(level), values_(values), sharp_(sharp), corners_(corners), linear_(linear)
    {
    }

    /// Returns a mark for each corner. Cost: O(corners), and O(n log n) at a vertex where n spans meet.
    [[nodiscard]] storage<corner_mark> find() const
    {
        storage<corner_mark> marks(level_.corner_count(), corner_mark());
        detail::for_parts(level_.edge_count(), Level::parallel, [&](std::size_t begin, std::size_t end) {
            for (std::size_t e = begin; e < end; ++e)
                mark_seam(level_.edges()[e], marks);
        });
        detail::for_parts(level_.vertex_count(), Level::parallel, [&](std::size_t begin, std::size_t end) {
            for (std::size_t v = begin; v < end; ++v)
                mark_spans(level_.vertices()[v], marks);
        });
        return marks;
    }

private:
    struct known_span {
        corner_span<Level> span;
        bool comes_again = false;                         ///< another span of the vertex has the same value
        std::size_t infinitely_sharp = 0, semi_sharp = 0; ///< edges inside
    };

    [[nodiscard]] const T& value(const corner<Level>& c) const { return values_[c.index()]; }
    void mark_seam(const edge<Level>& e, storage<corner_mark>& marks) const
    {
        if (e.is_boundary())
            return;
        const auto left = e.lcorner(), right = e.rcorner();
        if (not(value(left) == value(right.next()) and value(left.next()) == value(right)))
            marks[left.index()].seam = marks[right.index()].seam = true;
    }

    void mark_spans(const vertex<Level>& v, storage<corner_mark>& marks) const
    {
        bool has_other_rules = differs_along_boundary(v);
        for (const auto c : v.corners())
            has_other_rules = has_other_rules or marks[c.index()].seam;
        if (not has_other_rules)
            return;
        std::vector<known_span> spans;
        for_each_span(v, {marks.data(), marks.size()}, [&](const auto& span) { spans.push_back({span}); });
        for (auto& [span, comes_again, infinite, semi] : spans)
            span.for_inner_edges([&](const auto& e) {
                const double s = sharp_.sharpness(e);
                infinite += s == infinitely_sharp;
                semi += s > 0 and s < infinitely_sharp;
            });
        const std::size_t values = count_values(spans);
        const bool all_stay = all_are_corners(v, spans, values);
        for (const auto& here : spans) {
            corner_rule rule = corner_rule::curve;
            if (all_stay or here.comes_again or here.infinitely_sharp != 0 or
                (here.span.faces == 1 and linear_ != face_varying_linear::none))
                rule = corner_rule::corner;
            else if (depends() and values == 2 and here.semi_sharp == 0 and sharp_.of_vertex(v.index()) == 0 and
                     (spans[0].semi_sharp != 0 or spans[1].semi_sharp != 0))
                rule = corner_rule::dependent;
            here.span.for_corners([&](const auto& c) { marks[c.index()].rule = rule; });
        }
    }

    /// Returns true if the values at a boundary vertex follow other rules than its point even without a seam.
    [[nodiscard]] bool differs_along_boundary(const vertex<Level>& v) const
    {
        return v.is_boundary() and
               (linear_ == face_varying_linear::boundaries or
                (linear_ != face_varying_linear::none and corners_ == boundary_corner::smoothed and v.has_valence(2)));
    }
    /// Returns true if the rule of one value depends on the other values at the vertex.
    [[nodiscard]] bool depends() const
    {
        return linear_ == face_varying_linear::corners_plus1 or linear_ == face_varying_linear::corners_plus2;
    }
    [[nodiscard]] bool all_are_corners(const vertex<Level>& v, const std::vector<known_span>& spans,
                                       std::size_t values) const
    {
        const auto any = [&](const auto& is) { return std::ranges::any_of(spans, is); };
        if (linear_ == face_varying_linear::boundaries or sharp_.of_vertex(v.index()) == infinitely_sharp)
            return true;
        if (not depends() or values == 1)
            return linear_ == face_varying_linear::corners_plus2 and not v.is_boundary();
        return values > 2 or any([](const known_span& s) { return s.infinitely_sharp != 0 or s.comes_again; }) or
               (linear_ == face_varying_linear::corners_plus2 and
                any([](const known_span& s) { return s.span.faces == 1; }));
    }

    /// Returns the number of different values at a vertex, and marks the spans that share one.
    [[nodiscard]] std::size_t count_values(std::vector<known_span>& spans) const
    {
        const auto of = [&](const known_span& s) -> const T& { return value(s.span.first); };
        std::size_t count = 0;
        const auto see = [](known_span& one, known_span& other) { one.comes_again = other.comes_again = true; };
        if constexpr (requires(const T& a) {
                          { a < a } -> std::convertible_to<bool>;
                      }) {
            std::vector<known_span*> order;
            for (auto& s : spans)
                if (of(s) == of(s))
                    order.push_back(&s);
                else // not a number, which equals no other value
                    ++count;
            std::ranges::sort(order, [&](const auto* a, const auto* b) { return of(*a) < of(*b); });
            for (std::size_t i = 0; i < order.size(); ++i)
                if (i > 0 and of(*order[i - 1]) == of(*order[i]))
                    see(*order[i - 1], *order[i]);
                else
                    ++count;
        } else {
            for (auto i = spans.begin(); i != spans.end(); ++i) {
                const auto before = std::find_if(spans.begin(), i, [&](const auto& s) { return of(s) == of(*i); });
                if (before != i)
                    see(*before, *i);
                else
                    ++count;
            }
        }
        return count;
    }

    const Level& level_;
    std::span<const T> values_;
    const creases& sharp_;
    boundary_corner corners_;
    face_varying_linear linear_;
};

} // namespace kith
