// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/base/affine.hpp>
#include <kith/base/refused.hpp>

#include <concepts>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace kith {

/// A mask is a lazy affine combination: `3./8 * (a + b) + 1./8 * (c + d)`, `average(f.vertices())`. Nothing is
/// computed or allocated until it is assigned; what it is evaluated *over* (points, stencil rows, hashes, any type with
/// an `affine`) is decided there. The operands are vertices of the coarse level and associations that name vertices of
/// the fine level. Its order of operations is the order in the text, so equal texts give equal bits.
struct mask_base {};

template <class T>
concept mask = std::derived_from<std::remove_cvref_t<T>, mask_base>;

template <class R>
concept mask_range = requires(const R& range) {
    { *range.begin() } -> mask;
    range.begin() == range.end();
};

namespace refused {

/// In place of a mask that is none.
struct any_mask : mask_base {
    template <class Values>
    [[nodiscard]] typename Values::sum evaluate(const Values&) const
    {
        return {};
    }
};

/// Masks, elements and ranges of them, so that functions of others with the same names are left alone.
template <class T>
concept of_a_mesh = mask<T> or requires { typename T::handle_type; };
template <class T>
concept of_meshes = of_a_mesh<T> or requires(const T& range) {
    { *range.begin() } -> mask;
} or requires(const T& range) { typename decltype(*range.begin())::handle_type; };

} // namespace refused

template <class A, class B>
struct mask_sum : mask_base {
    A a;
    B b;

    mask_sum(A a, B b) : a(std::move(a)), b(std::move(b)) {}

    template <class Values>
    [[nodiscard]] typename Values::sum evaluate(const Values& values) const
    {
        auto total = a.evaluate(values);
        Values::add(total, b.evaluate(values));
        return total;
    }
};

/// The weight 1/n, formed in the scalar type of the evaluation, so that it is exact over exact numbers.
struct one_over {
    double n;

    template <class Scalar>
    [[nodiscard]] Scalar as() const
    {
        return Scalar(1) / Scalar(n);
    }
};

template <class A, class Weight>
struct mask_scaled : mask_base {
    A a;
    Weight weight;

    mask_scaled(A a, Weight weight) : a(std::move(a)), weight(std::move(weight)) {}

    template <class Values>
    [[nodiscard]] typename Values::sum evaluate(const Values& values) const
    {
        auto total = a.evaluate(values);
        if constexpr (std::same_as<Weight, one_over>)
            Values::scale(total, weight.template as<typename Values::scalar>());
        else
            Values::scale(total, static_cast<typename Values::scalar>(weight));
        return total;
    }
};

/// The sum over a range; never empty, since no element of a mesh is without neighbours.
template <class Range>
struct mask_range_sum : mask_base {
    Range range;

    explicit mask_range_sum(Range range) : range(std::move(range)) {}

    template <class Values>
    [[nodiscard]] typename Values::sum evaluate(const Values& values) const
    {
        std::size_t count = 0;
        return evaluate(values, count);
    }
    template <class Values>
    [[nodiscard]] typename Values::sum evaluate(const Values& values, std::size_t& count) const
    {
        auto i = range.begin();
        const auto end = range.end();
        typename Values::sum total = (*i).evaluate(values);
        for (++i, ++count; not(i == end); ++i, ++count)
            Values::add(total, (*i).evaluate(values));
        return total;
    }
};

template <class Range>
struct mask_average : mask_base {
    mask_range_sum<Range> total;

    explicit mask_average(Range range) : total(std::move(range)) {}

    template <class Values>
    [[nodiscard]] typename Values::sum evaluate(const Values& values) const
    {
        std::size_t count = 0;
        auto result = total.evaluate(values, count);
        Values::scale(result, one_over{double(count)}.as<typename Values::scalar>());
        return result;
    }
};

/// The sum of weight_of(i) times the i-th operand.
template <class Range, class WeightOf>
struct mask_weighted_sum : mask_base {
    Range range;
    WeightOf weight_of;

    mask_weighted_sum(Range range, WeightOf weight_of) : range(std::move(range)), weight_of(std::move(weight_of)) {}

    template <class Values>
    [[nodiscard]] typename Values::sum evaluate(const Values& values) const
    {
        std::size_t count = 0;
        const auto term = [&](const auto& operand) {
            typename Values::sum result = operand.evaluate(values);
            Values::scale(result, static_cast<typename Values::scalar>(weight_of(count++)));
            return result;
        };
        auto i = range.begin();
        const auto end = range.end();
        typename Values::sum total = term(*i);
        for (++i; not(i == end); ++i)
            Values::add(total, term(*i));
        return total;
    }
};

/// The same over a list of operands with their weights. The list must outlive the mask.
template <class List>
struct mask_list_sum : mask_base {
    const List* list;

    explicit mask_list_sum(const List& list) : list(&list) {}

    template <class Values>
    [[nodiscard]] typename Values::sum evaluate(const Values& values) const
    {
        const auto term = [&](const auto& entry) {
            typename Values::sum result = entry.first.evaluate(values);
            Values::scale(result, static_cast<typename Values::scalar>(entry.second));
            return result;
        };
        auto i = list->begin();
        typename Values::sum total = term(*i);
        for (++i; i != list->end(); ++i)
            Values::add(total, term(*i));
        return total;
    }
};

/// A sum that is there already, as an operand.
template <class Sum>
struct mask_of_sum : mask_base {
    const Sum* total;

    explicit mask_of_sum(const Sum& total) : total(&total) {}

    template <class Values>
    [[nodiscard]] Sum evaluate(const Values&) const
    {
        return *total;
    }
};

/// In place of weights that a formula does not ask for.
struct no_weights {};

/// A formula of a vertex and the sum around it, weighted by how many operands there are: the ring is walked once.
template <class Center, class Range, class Weights, class Formula>
struct mask_ring : mask_base {
    Center center;
    mask_range_sum<Range> ring;
    const Weights* weights;
    Formula formula;

    mask_ring(Center center, Range ring, const Weights* weights, Formula formula)
        : center(std::move(center)), ring(std::move(ring)), weights(weights), formula(std::move(formula))
    {
    }

    template <class Values>
    [[nodiscard]] typename Values::sum evaluate(const Values& values) const
    {
        std::size_t count = 0;
        const typename Values::sum total = ring.evaluate(values, count);
        const typename Values::scalar n(static_cast<double>(count));
        const mask_of_sum<typename Values::sum> sum(total);
        if constexpr (std::same_as<Weights, no_weights>)
            return formula(n, center, sum).evaluate(values);
        else
            return formula(n, (*weights)(count), center, sum).evaluate(values);
    }
};

template <mask A, mask B>
[[nodiscard]] auto operator+(const A& a, const B& b)
{
    return mask_sum<A, B>(a, b);
}

template <class Weight, mask A>
    requires(not mask<Weight>)
[[nodiscard]] auto operator*(const Weight& weight, const A& a)
{
    return mask_scaled<A, Weight>(a, weight);
}

template <mask A, class B>
[[nodiscard]] auto operator*(const A& a, const B&)
{
    static_cast<void>(refused::product<mask<A>>());
    return a;
}

template <mask A>
[[nodiscard]] auto operator/(const A& a, double n)
{
    return mask_scaled<A, one_over>(a, one_over{n});
}

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
    return mask_weighted_sum<Range, decltype(weight_of)>(range, weight_of);
}
/// The i-th operand times weight_of(i).
template <mask_range Range, std::invocable<std::size_t> WeightOf>
[[nodiscard]] auto sum(const Range& range, const WeightOf& weight_of)
{
    return mask_weighted_sum<Range, WeightOf>(range, weight_of);
}
/// The sum over a list of pairs (operand, weight); the list must outlive the mask.
template <class List>
[[nodiscard]] auto weighted(const List& list)
{
    return mask_list_sum<List>(list);
}

/// formula(n, center, sum) where `sum` is that of a range of n operands: the formula of a paper for the new place of a vertex,
///
///   around(v, ring, [](auto n, auto v, auto sum) { return (n - 2) / n * v + 1 / (n * n) * sum; })
///
/// n is in the scalar type of the evaluation, so that the weights are, too.
template <mask Center, mask_range Range, class Formula>
[[nodiscard]] auto around(const Center& center, const Range& ring, const Formula& formula)
{
    return mask_ring<Center, Range, no_weights, Formula>(center, ring, nullptr, formula);
}
/// The same for formulas with a weight that depends on n: formula(n, w, center, sum) where w is weights(n), such as those of
/// by_valence. They must outlive the mask.
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
    static_cast<void>(refused::average_of_one<mask<A>>());
    return a;
}
template <refused::of_meshes A, class... More>
    requires((not mask<A> and not mask_range<A>) or (sizeof...(More) > 0 and not(mask<A> and ... and mask<More>)))
[[nodiscard]] auto average(const A&, const More&...)
{
    static_cast<void>(refused::sum_of_other_things<refused::of_meshes<A>>());
    return refused::any_mask();
}
template <class A, class B>
    requires(mask<A> or mask<B>) and (not mask<A> or not mask<B>)
[[nodiscard]] auto operator+(const A&, const B&)
{
    static_cast<void>(refused::sum_of_other_things<(mask<A> or mask<B>)>());
    return refused::any_mask();
}
template <refused::of_meshes A, class... More>
    requires(not mask_range<A> and not(mask<A> and ... and mask<More>))
[[nodiscard]] auto sum(const A&, const More&...)
{
    static_cast<void>(refused::sum_of_other_things<refused::of_meshes<A>>());
    return refused::any_mask();
}

} // namespace kith
