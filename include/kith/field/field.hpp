// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "corner_rules.hpp"
#include "edge_rules.hpp"
#include "face_rules.hpp"
#include "vertex_rules.hpp"

#include <kith/base/error.hpp>
#include <kith/base/storage.hpp>

#include <concepts>
#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>

namespace kith {

/// The elements on which a field has its values.
enum class field_on : unsigned char { vertices, edges, faces, corners };

/// A field: a value for each element of one kind of a level, by its dense number, and a rule by which the elements of the next
/// level inherit. It is state of a level (level_state.hpp): `with_fields` hands it on beside any scheme, and a scheme may have
/// it as a member and read it. A rule has
///
///   storage<T> after(std::span<const T> values, const auto& step) const     those of the next level; step: made_step
///
/// A field without values stays without. Errors: mesh_error where the number of values is not that of the elements. Cost of a
/// step: that of the rule.
template <field_on Where, class T, class Rule>
class field {
public:
    using value_type = T;
    static constexpr field_on where = Where;

    field() : rule_(Rule()) {}
    explicit field(Rule rule) : rule_(std::move(rule)) {}
    /// Takes any array of values: std::vector, std::span, storage.
    template <class Range>
        requires requires(const Range& range) { std::data(range), std::size(range); }
    explicit field(const Range& values, Rule rule = {}) : values_(values), rule_(std::move(rule))
    {
    }

    [[nodiscard]] std::size_t size() const { return values_.size(); }
    [[nodiscard]] bool empty() const { return values_.empty(); }
    [[nodiscard]] std::span<const T> values() const { return {values_.data(), values_.size()}; }
    [[nodiscard]] const T& operator[](std::size_t element) const { return values_[element]; }
    [[nodiscard]] T& operator[](std::size_t element) { return values_[element]; }
    [[nodiscard]] const Rule& rule() const { return *rule_; }

    /// That of the next level.
    template <finished_step Step>
    [[nodiscard]] field after(const Step& step) const
    {
        field result(rule());
        if (empty())
            return result;
        if (size() != count_on(step.coarse))
            throw mesh_error("a field has " + std::to_string(size()) + " values, the level has " +
                             std::to_string(count_on(step.coarse)) + " " + name() + "; give it one for each");
        result.values_ = rule().template after<T>(values(), step);
        return result;
    }
    /// That of a part of the level.
    template <std::unsigned_integral Index>
    [[nodiscard]] field of_part(const part_numbers<Index>& part) const
    {
        field result(rule());
        if (empty())
            return result;
        result.values_ = storage<T>(count_on(part));
        for_each_in(part, [&](std::size_t here, std::size_t there) {
            if (there >= size())
                throw mesh_error("a field has " + std::to_string(size()) + " values, none for number " +
                                 std::to_string(there) + " of the " + name() + "; give it one for each");
            result.values_[here] = values_[there];
        });
        return result;
    }
    /// Takes over the values of a part.
    template <std::unsigned_integral Index>
    void add_part(const field& more, const part_numbers<Index>& part)
    {
        if (more.empty())
            return;
        std::size_t end = size();
        for_each_in(part, [&](std::size_t, std::size_t there) { end = std::max(end, there + 1); });
        if (end != size()) {
            storage<T> longer(end);
            std::copy(values_.begin(), values_.end(), longer.begin());
            std::fill(longer.begin() + size(), longer.end(), T());
            values_ = std::move(longer);
        }
        for_each_in(part, [&](std::size_t here, std::size_t there) { values_[there] = more[here]; });
    }
    /// As a message, and from one.
    template <class Out>
    void pack(Out& out) const
    {
        if constexpr (are_plain())
            out.add_array(values_);
    }
    template <class In>
    void unpack(In& in)
    {
        if constexpr (are_plain())
            values_ = in.template get_array<storage<T>>();
    }

private:
    static constexpr const char* name()
    {
        return std::array{"vertices", "edges", "faces", "corners"}[std::size_t(Where)];
    }
    static constexpr bool are_plain()
    {
        constexpr bool are = std::is_trivially_copyable_v<T>;
        static_assert(are,
                      "the values of a field that is sent to other ranks are plain bytes, trivially copyable; others, "
                      "such as std::string, stay on one");
        return are;
    }
    /// Of a level or of a part of one.
    template <counts_elements Level>
    static std::size_t count_on(const Level& level)
    {
        if constexpr (Where == field_on::vertices)
            return level.vertex_count();
        else if constexpr (Where == field_on::edges)
            return level.edge_count();
        else if constexpr (Where == field_on::faces)
            return level.face_count();
        else
            return level.corner_count();
    }
    /// Calls f(number in the part, number in the level).
    template <std::unsigned_integral Index, class F>
    static void for_each_in(const part_numbers<Index>& part, const F& f)
    {
        const auto in_list = [&](std::span<const Index> list) {
            for (std::size_t i = 0; i < list.size(); ++i)
                f(i, std::size_t(list[i]));
        };
        if constexpr (Where == field_on::vertices)
            in_list(part.vertices);
        else if constexpr (Where == field_on::edges)
            in_list(part.edges);
        else if constexpr (Where == field_on::faces)
            in_list(part.faces);
        else
            part.for_each_corner(f);
    }

    storage<T> values_;
    detail::assignable<Rule> rule_;
};

namespace detail {

template <field_on Where, class Values, class Rule>
auto make_field(const Values& values, Rule rule)
{
    return field<Where, std::remove_cvref_t<decltype(*std::data(values))>, Rule>(values, std::move(rule));
}

} // namespace detail

/// A field from an array of values, one for each element in the order of the dense numbers.
template <class Values, class Rule = from_parent<>>
auto on_faces(const Values& values, Rule rule = {})
{
    return detail::make_field<field_on::faces>(values, std::move(rule));
}
template <class Values, class Rule = along_edges<>>
auto on_edges(const Values& values, Rule rule = {})
{
    return detail::make_field<field_on::edges>(values, std::move(rule));
}
template <class Values, class Rule = linear_values>
auto on_vertices(const Values& values, Rule rule = {})
{
    return detail::make_field<field_on::vertices>(values, std::move(rule));
}
template <class Values, class Rule = linear_in_faces>
auto on_corners(const Values& values, Rule rule = {})
{
    return detail::make_field<field_on::corners>(values, std::move(rule));
}

} // namespace kith
