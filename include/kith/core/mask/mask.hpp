// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mask_expressions.hpp"
#include "value_space.hpp"

#include <kith/core/base/affine.hpp>
#include <kith/core/base/diagnostics.hpp>

#include <concepts>
#include <cstddef>
#include <type_traits>

namespace kith {

/// A mask is a lazy affine combination: `0.375 * (a + b) + 0.125 * (c + d)`, `average(f.vertices())`. Nothing is
/// computed or allocated until it is assigned; what it is evaluated over (points, stencil rows, hashes, any type with
/// an `affine`) is decided there. The operands are vertices of the coarse level and associations that name vertices of
/// the fine level. Its order of operations is the order in the text, so equal texts give equal bits.
template <class T>
concept mask = std::derived_from<std::remove_cvref_t<T>, mask_base>;

/// What gives masks one after the other: the vertices of a face, the neighbours of a vertex.
template <class R>
concept mask_range = requires(const R& range) {
    { *range.begin() } -> mask;
    range.begin() == range.end();
};

namespace diagnostics {

/// In place of a mask that is none.
struct any_mask : mask_base {
    template <value_space Values>
    [[nodiscard]] typename Values::sum evaluate(const Values&) const
    {
        return {};
    }
};

/// A point that its own library does not add, so that a sum of such points is meant to be a mask.
template <class T>
concept point_without_sum = not mask<T> and not std::is_arithmetic_v<T> and affine_value<T> and
                            not requires(const T& a) { a + a; };

/// Masks, elements and ranges of them, so that functions of others with the same names are left alone.
template <class T>
concept of_a_mesh = mask<T> or requires { typename T::handle_type; };
template <class T>
concept of_meshes = of_a_mesh<T> or requires(const T& range) {
    { *range.begin() } -> mask;
} or requires(const T& range) { typename decltype(*range.begin())::handle_type; };

} // namespace diagnostics

/// What has masks evaluated over values that it knows: an association space.
template <class S>
concept mask_evaluator = requires(const S& space, const diagnostics::any_mask& mask) {
    requires weight_number<typename S::scalar> and std::copyable<typename S::sum>; // of its values
    { space.evaluate(mask) } -> std::convertible_to<typename S::sum>;              // of any mask
};

/// Masks are added, subtracted, and scaled by numbers; nothing is computed before they are evaluated. Cost: O(1).
template <mask A, mask B>
[[nodiscard]] auto operator+(const A& a, const B& b)
{
    return mask_operation<A, B, sum_of_two>(a, b);
}

/// The weight, a number or what becomes one in the scalar type of the values, stands on the left.
template <class Weight, mask A>
    requires(not mask<Weight>)
[[nodiscard]] auto operator*(const Weight& weight, const A& a)
{
    return mask_operation<A, Weight, weighted_mask>(a, weight);
}

/// Refused: no product of masks is affine, and a weight on the right is to stand on the left.
template <mask A, class B>
[[nodiscard]] auto operator*(const A& a, const B&)
{
    static_cast<void>(diagnostics::product<mask<A>>());
    return a;
}

/// a times 1/n, which is formed in the scalar type of the values.
template <mask A>
[[nodiscard]] auto operator/(const A& a, double n)
{
    return mask_operation<A, one_over, weighted_mask>(a, one_over{n});
}

/// a + (-1) b.
template <mask A, mask B>
[[nodiscard]] auto operator-(const A& a, const B& b)
{
    return a + -1. * b;
}

/// a + b + c + ...
template <mask A>
[[nodiscard]] const A& sum(const A& a)
{
    return a;
}
template <mask A, mask B, mask... More>
[[nodiscard]] auto sum(const A& a, const B& b, const More&... more)
{
    return sum(a + b, more...);
}
template <mask_range Range>
[[nodiscard]] auto sum(const Range& range)
{
    return mask_range_sum<Range>(range);
}

/// The i-th operand times weights[i]; the weights must outlive the mask.
template <mask_range Range, class Weight>
[[nodiscard]] auto sum(const Range& range, const Weight* weights)
{
    const auto weight_of = [weights](std::size_t i) { return weights[i]; };
    return mask_operation<Range, decltype(weight_of), weighted_operands>(range, weight_of);
}
/// The i-th operand times weight_of(i).
template <mask_range Range, std::invocable<std::size_t> WeightOf>
[[nodiscard]] auto sum(const Range& range, const WeightOf& weight_of)
{
    return mask_operation<Range, WeightOf, weighted_operands>(range, weight_of);
}
/// The sum over a list of pairs (operand, weight); the list must outlive the mask.
template <class List>
[[nodiscard]] auto weighted(const List& list)
{
    return mask_list_sum<List>(list);
}

/// formula(n, center, sum) where `sum` is that of a range of n operands: the formula of a paper for the new place of a
/// vertex,
///
///   around(v, ring, [](auto n, auto v, auto sum) { return (n - 2) / n * v + 1 / (n * n) * sum; })
///
/// n is in the scalar type of the evaluation, so that the weights are, too.
template <mask Center, mask_range Range, class Formula>
[[nodiscard]] auto around(const Center& center, const Range& ring, const Formula& formula)
{
    return mask_ring<Center, Range, no_weights, Formula>(center, ring, nullptr, formula);
}
/// The same for formulas with a weight that depends on n: formula(n, w, center, sum) where w is weights(n), such as
/// those of by_valence. They must outlive the mask.
template <mask Center, mask_range Range, std::invocable<std::size_t> Weights, class Formula>
[[nodiscard]] auto around(const Center& center, const Range& ring, const Weights& weights, const Formula& formula)
{
    return mask_ring<Center, Range, Weights, Formula>(center, ring, &weights, formula);
}

/// The mean of the operands, with weight 1/n each.
template <mask A, mask B, mask... More>
[[nodiscard]] auto average(const A& a, const B& b, const More&... more)
{
    return sum(a, b, more...) / double(2 + sizeof...(More));
}
template <mask_range Range>
[[nodiscard]] auto average(const Range& range)
{
    return mask_average<Range>(range);
}

// Mistakes, each told in one sentence.

template <mask A>
[[nodiscard]] auto average(const A& a)
{
    static_cast<void>(diagnostics::average_of_one<mask<A>>());
    return a;
}
template <diagnostics::of_meshes A, class... More>
    requires((not mask<A> and not mask_range<A>) or (sizeof...(More) > 0 and not(mask<A> and ... and mask<More>)))
[[nodiscard]] auto average(const A&, const More&...)
{
    static_cast<void>(diagnostics::sum_of_other_things<diagnostics::of_meshes<A>>());
    return diagnostics::any_mask();
}
template <diagnostics::point_without_sum Point, class... Points>
[[nodiscard]] auto average(const Point&, const Points&...)
{
    static_cast<void>(diagnostics::points_in_a_mask<(sizeof(Point) > 0)>());
    return diagnostics::any_mask();
}
template <diagnostics::point_without_sum Point, class... Points>
[[nodiscard]] auto sum(const Point&, const Points&...)
{
    static_cast<void>(diagnostics::points_in_a_mask<(sizeof(Point) > 0)>());
    return diagnostics::any_mask();
}
template <class A, class B>
    requires((mask<A> or mask<B>) and not(mask<A> and mask<B>))
[[nodiscard]] auto operator+(const A&, const B&)
{
    static_cast<void>(diagnostics::sum_of_other_things<(mask<A> or mask<B>)>());
    return diagnostics::any_mask();
}
template <diagnostics::of_meshes A, class... More>
    requires(not mask_range<A> and not(mask<A> and ... and mask<More>))
[[nodiscard]] auto sum(const A&, const More&...)
{
    static_cast<void>(diagnostics::sum_of_other_things<diagnostics::of_meshes<A>>());
    return diagnostics::any_mask();
}

} // namespace kith
