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
/// computed or allocated until it is assigned. The assignment decides over which values it is evaluated: points,
/// stencil rows, hashes, any type with an `affine`. The operands are vertices of the coarse level and associations that
/// name vertices of the fine level. The order of operations is that of the text, so equal texts give equal bits.
template <class T>
concept mask = std::derived_from<std::remove_cvref_t<T>, mask_base>;

/// A range of masks, such as the vertices of a face or the neighbours of a vertex.
template <class R>
concept mask_range = requires(const R& range) {
    { *range.begin() } -> mask;
    range.begin() == range.end();
};

namespace diagnostics {

/// A placeholder for an expression that is not a valid mask.
struct any_mask : mask_base {
    template <value_space Values>
    [[nodiscard]] typename Values::sum evaluate(const Values&) const
    {
        return {};
    }
};

/// A point type whose own library does not define a sum, so that a sum of these points is meant to be a mask.
template <class T>
concept point_without_sum = not mask<T> and not std::is_arithmetic_v<T> and affine_value<T> and
                            not requires(const T& a) { a + a; };

/// A mask or an element; `of_meshes` adds their ranges. The constraint leaves functions of other libraries with the
/// same names alone.
template <class T>
concept of_a_mesh = mask<T> or requires { typename T::handle_type; };
template <class T>
concept of_meshes = of_a_mesh<T> or requires(const T& range) {
    { *range.begin() } -> mask;
} or requires(const T& range) { typename decltype(*range.begin())::handle_type; };

} // namespace diagnostics

/// An evaluator of masks over values that it knows, such as an association space.
template <class S>
concept mask_evaluator = requires(const S& space, const diagnostics::any_mask& mask) {
    requires weight_number<typename S::scalar> and std::copyable<typename S::sum>; // of its values
    { space.evaluate(mask) } -> std::convertible_to<typename S::sum>;              // of any mask
};

/// Returns the mask a + b. Masks can be added, subtracted and scaled by numbers; nothing is computed until they are
/// evaluated. Cost: O(1).
template <mask A, mask B>
[[nodiscard]] auto operator+(const A& a, const B& b)
{
    return mask_operation<A, B, sum_of_two>(a, b);
}

/// Returns the mask `weight` times a. The weight is a number, or converts to the scalar type of the values; it stands
/// on the left.
template <class Weight, mask A>
    requires(not mask<Weight>)
[[nodiscard]] auto operator*(const Weight& weight, const A& a)
{
    return mask_operation<A, Weight, weighted_mask>(a, weight);
}

/// Reports an error at compile time: a product of masks is not affine, and a weight has to stand on the left.
template <mask A, class B>
[[nodiscard]] auto operator*(const A& a, const B&)
{
    static_cast<void>(diagnostics::product<mask<A>>());
    return a;
}

/// Returns the mask a times 1/n, where 1/n is computed in the scalar type of the values.
template <mask A>
[[nodiscard]] auto operator/(const A& a, double n)
{
    return mask_operation<A, one_over, weighted_mask>(a, one_over{n});
}

/// Returns the mask a + (-1) b.
template <mask A, mask B>
[[nodiscard]] auto operator-(const A& a, const B& b)
{
    return a + -1. * b;
}

/// Returns the mask a + b + c + ..., or the sum of the masks in a range.
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

/// Returns the sum over the operands, the i-th times weights[i]. The weights must outlive the mask.
template <mask_range Range, class Weight>
[[nodiscard]] auto sum(const Range& range, const Weight* weights)
{
    const auto weight_of = [weights](std::size_t i) { return weights[i]; };
    return mask_operation<Range, decltype(weight_of), weighted_operands>(range, weight_of);
}
/// Returns the sum over the operands, the i-th times weight_of(i).
template <mask_range Range, std::invocable<std::size_t> WeightOf>
[[nodiscard]] auto sum(const Range& range, const WeightOf& weight_of)
{
    return mask_operation<Range, WeightOf, weighted_operands>(range, weight_of);
}
/// Returns the weighted sum over a list of pairs (operand, weight). The list must outlive the mask.
template <class List>
[[nodiscard]] auto weighted(const List& list)
{
    return mask_list_sum<List>(list);
}

/// Returns the mask formula(n, center, sum), where `sum` is the sum of a ring of n operands. The formula is that of a
/// paper for the new place of a vertex:
///
///   around(v, ring, [](auto n, auto v, auto sum) { return (n - 2) / n * v + 1 / (n * n) * sum; })
///
/// n has the scalar type of the evaluation, and so have the weights.
template <mask Center, mask_range Range, class Formula>
[[nodiscard]] auto around(const Center& center, const Range& ring, const Formula& formula)
{
    return mask_ring<Center, Range, no_weights, Formula>(center, ring, nullptr, formula);
}
/// Returns the mask formula(n, w, center, sum), where w is weights(n), a weight that depends on n, such as one of
/// by_valence. The weights must outlive the mask.
template <mask Center, mask_range Range, std::invocable<std::size_t> Weights, class Formula>
[[nodiscard]] auto around(const Center& center, const Range& ring, const Weights& weights, const Formula& formula)
{
    return mask_ring<Center, Range, Weights, Formula>(center, ring, &weights, formula);
}

/// Returns the mean of the operands, each with weight 1/n.
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

// The overloads below report mistakes at compile time, each with one message.

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
