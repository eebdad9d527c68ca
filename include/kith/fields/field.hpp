// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "element_values.hpp"

#include <kith/core/base/message.hpp>
#include <kith/core/base/storage.hpp>
#include <kith/fields/rules/corner_rules.hpp>
#include <kith/fields/rules/edge_rules.hpp>
#include <kith/fields/rules/face_rules.hpp>
#include <kith/fields/rules/vertex_rules.hpp>
#include <kith/numbering/step/level_state.hpp>

#include <concepts>
#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>

namespace kith {

/// A rule that keeps marks of its own beside the values, one for each element, such as where texture coordinates have
/// seams. It has a mark_type of plain bytes. In place of the function of other rules it has:
///
///   std::pair<storage<T>, storage<mark_type>>
///   after(std::span<const T> values, std::span<const mark_type> marks, const auto& step) const;
///
/// In the first step there are no marks; the rule then makes them from the values.
template <class Rule>
concept marking_rule = requires { requires std::is_trivially_copyable_v<typename Rule::mark_type>; };

namespace detail {

template <class Rule, class T, class Step>
concept makes_values = requires(const Rule& rule, std::span<const T> values, const Step& step) {
    { rule.template after<T>(values, step) } -> std::convertible_to<storage<T>>;
};
template <class Rule, class T, class Step, class Mark = typename Rule::mark_type>
concept makes_marks = requires(const Rule& rule, std::span<const T> values, std::span<const Mark> marks,
                               const Step& step) {
    { rule.template after<T>(values, marks, step) } -> std::convertible_to<std::pair<storage<T>, storage<Mark>>>;
};

} // namespace detail

/// A rule by which a field has values of this type after this step.
template <class Rule, class T, class Step>
concept field_rule = finished_step<Step> and ((marking_rule<Rule> and detail::makes_marks<Rule, T, Step>) or
                                              (not marking_rule<Rule> and detail::makes_values<Rule, T, Step>));

/// A field: values on the elements of one kind of a level, by dense number, and a rule by which the elements of the
/// next level inherit. It is state of a level (level_state.hpp): `with_fields` hands it on beside any scheme, and a
/// scheme may have it as a member and read it. A rule is a marking_rule or has
///
///   storage<T> after(std::span<const T> values, const auto& step) const
///
/// which returns the values of the next level; `step` is a step_result. A field without values stays without. Errors:
/// mesh_error if the number of values is not that of the elements. Cost of a step: that of the rule.
template <field_on Where, class T, class Rule>
class field {
public:
    using value_type = T;
    static constexpr field_on where = Where;

    field() : rule_(Rule()) {}
    explicit field(Rule rule) : rule_(std::move(rule)) {}
    /// Takes a copy of any array of values: std::vector, std::span, storage.
    template <class Range>
        requires requires(const Range& range) { std::data(range), std::size(range); }
    explicit field(const Range& values, Rule rule = Rule()) : values_(storage<T>(values)), rule_(std::move(rule))
    {
    }

    /// Takes over an array without a copy.
    explicit field(storage<T>&& values, Rule rule = Rule()) : values_(std::move(values)), rule_(std::move(rule)) {}

    [[nodiscard]] std::size_t size() const { return values_.size(); }
    [[nodiscard]] bool empty() const { return values_.empty(); }
    [[nodiscard]] std::span<const T> values() const { return values_.all(); }
    [[nodiscard]] const T& operator[](std::size_t element) const { return values_[element]; }
    [[nodiscard]] T& operator[](std::size_t element) { return values_[element]; }
    [[nodiscard]] const Rule& rule() const { return *rule_; }

    /// Throws mesh_error if there are values, but not one for each element of the level.
    template <counts_elements Level>
    void require_one_each(const Level& level) const
    {
        values_.require_one_each(level);
    }
    /// Returns the field of the next level.
    template <finished_step Step>
    [[nodiscard]] field after(const Step& step) const
    {
        static_assert(field_rule<Rule, T, Step>,
                      "the rule of a field has after(std::span<const T> values, const auto& step) const, which returns "
                      "storage<T>, for values of this type; a rule that makes means needs kith::affine of them");
        field result(rule());
        if (empty())
            return result;
        values_.require_one_each(step.coarse);
        if constexpr (not field_rule<Rule, T, Step>) {
            return result; // the static_assert has reported it
        } else if constexpr (is_marked) {
            auto [values, marks] = rule().template after<T>(values_.all(), marks_.all(), step);
            result.values_ = decltype(values_)(std::move(values));
            result.marks_ = decltype(marks_)(std::move(marks));
        } else {
            result.values_ = decltype(values_)(rule().template after<T>(values_.all(), step));
        }
        return result;
    }
    /// Returns the field of a part of the level.
    template <std::unsigned_integral Index>
    [[nodiscard]] field of_part(const part_numbers<Index>& part) const
    {
        field result(rule());
        result.values_ = values_.of_part(part);
        if constexpr (is_marked)
            result.marks_ = marks_.of_part(part);
        return result;
    }
    /// Takes over the values of a part.
    template <std::unsigned_integral Index>
    void add_part(const field& more, const part_numbers<Index>& part)
    {
        values_.add_part(more.values_, part);
        if constexpr (is_marked)
            marks_.add_part(more.marks_, part);
    }
    /// Writes the values and marks to a message; unpack() reads them from one.
    template <message_writer Out>
    void pack(Out& out) const
    {
        values_.pack(out);
        if constexpr (is_marked)
            marks_.pack(out);
    }
    template <message_reader In>
    void unpack(In& in)
    {
        values_.unpack(in);
        if constexpr (is_marked)
            marks_.unpack(in);
    }

private:
    static constexpr bool is_marked = marking_rule<Rule>;
    struct no_marks {};
    template <class R>
    struct marks_of {
        using type = no_marks;
    };
    template <marking_rule R>
    struct marks_of<R> {
        using type = element_values<Where, typename R::mark_type>;
    };

    element_values<Where, T> values_;
    [[no_unique_address]] typename marks_of<Rule>::type marks_;
    detail::assignable<Rule> rule_;
};

namespace detail {

template <field_on Where, class Values, class Rule>
auto make_field(const Values& values, Rule rule)
{
    return field<Where, std::remove_cvref_t<decltype(*std::data(values))>, Rule>(values, std::move(rule));
}

} // namespace detail

/// Returns a field from an array of values, one for each element in the order of the dense numbers.
template <class Values, class Rule = from_parent<>>
auto on_faces(const Values& values, Rule rule = Rule())
{
    return detail::make_field<field_on::faces>(values, std::move(rule));
}
template <class Values, class Rule = along_edges<>>
auto on_edges(const Values& values, Rule rule = Rule())
{
    return detail::make_field<field_on::edges>(values, std::move(rule));
}
template <class Values, class Rule = linear_values>
auto on_vertices(const Values& values, Rule rule = Rule())
{
    return detail::make_field<field_on::vertices>(values, std::move(rule));
}
template <class Values, class Rule = linear_in_faces>
auto on_corners(const Values& values, Rule rule = Rule())
{
    return detail::make_field<field_on::corners>(values, std::move(rule));
}

} // namespace kith
