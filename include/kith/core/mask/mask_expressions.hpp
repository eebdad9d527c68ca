// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "value_space.hpp"

#include <concepts>
#include <cstddef>
#include <utility>

/// The expression types of masks: one type for each way to combine operands, made by the functions of mask.hpp. Each is
/// evaluated over `Values`, which defines the value of an operand and how values are added and scaled. The types have
/// constructors: g++ 12 copies aggregates through memory, so that a step would take 1.8 times as long.
namespace kith {

/// The base class of all masks.
struct mask_base {};

/// The mask that an operation forms from a and b.
template <class A, class B, class Operation>
struct mask_operation : mask_base {
    A a;
    B b;

    mask_operation(A a, B b) : a(std::move(a)), b(std::move(b)) {}

    template <value_space Values>
    [[nodiscard]] typename Values::sum evaluate(const Values& values) const
    {
        return Operation::evaluate(values, a, b);
    }
};

/// The operation that adds two masks.
struct sum_of_two {
    template <value_space Values, class A, class B>
    [[nodiscard]] static typename Values::sum evaluate(const Values& values, const A& a, const B& b)
    {
        auto total = a.evaluate(values);
        Values::add(total, b.evaluate(values));
        return total;
    }
};

/// The weight 1/n.
struct one_over {
    double n;
};

/// Returns a weight in the scalar type of an evaluation. The quotient 1/n is computed in that type, so that it is exact
/// over exact numbers.
template <class Scalar, class Weight>
[[nodiscard]] Scalar weight_as(const Weight& weight)
{
    return static_cast<Scalar>(weight);
}
template <class Scalar>
[[nodiscard]] Scalar weight_as(const one_over& weight)
{
    return Scalar(1) / Scalar(weight.n);
}

/// The operation that multiplies a mask by a weight.
struct weighted_mask {
    template <value_space Values, class Mask, class Weight>
    [[nodiscard]] static typename Values::sum evaluate(const Values& values, const Mask& mask, const Weight& weight)
    {
        auto result = mask.evaluate(values);
        Values::scale(result, weight_as<typename Values::scalar>(weight));
        return result;
    }
};

/// The sum over a range. The range is never empty, since every element of a mesh has neighbours.
template <class Range>
struct mask_range_sum : mask_base {
    Range range;

    explicit mask_range_sum(Range range) : range(std::move(range)) {}

    template <value_space Values>
    [[nodiscard]] typename Values::sum evaluate(const Values& values) const
    {
        std::size_t count = 0;
        return evaluate(values, count);
    }
    template <value_space Values>
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

/// The sum over a range, divided by the number of its operands. The range is never empty.
template <class Range>
struct mask_average : mask_base {
    mask_range_sum<Range> total;

    explicit mask_average(Range range) : total(std::move(range)) {}

    template <value_space Values>
    [[nodiscard]] typename Values::sum evaluate(const Values& values) const
    {
        std::size_t count = 0;
        auto result = total.evaluate(values, count);
        Values::scale(result, weight_as<typename Values::scalar>(one_over{double(count)}));
        return result;
    }
};

namespace detail {

/// Returns the sum of weight_of(entry) times the value of operand_of(entry) over a list, added from the left.
template <value_space Values, class List, class OperandOf, class WeightOf>
[[nodiscard]] typename Values::sum sum_of_terms(const Values& values, const List& list, const OperandOf& operand_of,
                                                const WeightOf& weight_of)
{
    const auto term = [&](const auto& entry) {
        typename Values::sum result = operand_of(entry).evaluate(values);
        Values::scale(result, static_cast<typename Values::scalar>(weight_of(entry)));
        return result;
    };
    auto i = list.begin();
    const auto end = list.end();
    typename Values::sum total = term(*i);
    for (++i; not(i == end); ++i)
        Values::add(total, term(*i));
    return total;
}

} // namespace detail

/// The operation that sums weight_of(i) times the i-th operand of a range.
struct weighted_operands {
    template <value_space Values, class Range, class WeightOf>
    [[nodiscard]] static typename Values::sum evaluate(const Values& values, const Range& range,
                                                       const WeightOf& weight_of)
    {
        std::size_t count = 0;
        return detail::sum_of_terms(
            values,
            range,
            [](const auto& operand) -> const auto& { return operand; },
            [&](const auto&) { return weight_of(count++); });
    }
};

/// The sum over a list of operands with their weights. The list must outlive the mask.
template <class List>
struct mask_list_sum : mask_base {
    const List* list;

    explicit mask_list_sum(const List& list) : list(&list) {}

    template <value_space Values>
    [[nodiscard]] typename Values::sum evaluate(const Values& values) const
    {
        return detail::sum_of_terms(
            values,
            *list,
            [](const auto& entry) -> const auto& { return entry.first; },
            [](const auto& entry) { return entry.second; });
    }
};

/// A mask with a sum that is already computed, for use as an operand. The sum must outlive the mask.
template <class Sum>
struct mask_of_sum : mask_base {
    const Sum* total;

    explicit mask_of_sum(const Sum& total) : total(&total) {}

    template <value_space Values>
    [[nodiscard]] Sum evaluate(const Values&) const
    {
        return *total;
    }
};

/// A placeholder for weights that a formula does not use.
struct no_weights {};

/// The mask of a formula over a vertex and the sum of its ring, with weights by the number of operands. The ring is
/// walked once.
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

    template <value_space Values>
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

} // namespace kith
