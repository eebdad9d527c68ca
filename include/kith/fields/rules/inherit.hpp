// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/for_parts.hpp>
#include <kith/core/base/storage.hpp>
#include <kith/fields/property/unset_values.hpp>
#include <kith/numbering/association/columns.hpp>
#include <kith/numbering/association/numbering.hpp>
#include <kith/numbering/step/children.hpp>
#include <kith/numbering/step/level_state.hpp>

#include <concepts>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>

namespace kith {

/// The value of elements that inherit nothing: T(), or zero if T() is uninitialized.
struct no_value {};

namespace detail {

/// Returns the value of a new element that inherits from none: a constant, or what a function returns. The function
/// gets the element that made the new one and the values of the level.
template <class T, class Born, element Element>
T born_value(const Born& born, const Element& element, std::span<const T> values)
{
    if constexpr (std::same_as<Born, no_value>)
        return value_of_nothing<T>();
    else if constexpr (std::invocable<const Born&, const Element&, std::span<const T>>)
        return T(std::invoke(born, element, values));
    else {
        static_assert(std::convertible_to<const Born&, T>,
                      "`born` of a rule of a field is a value, or a function of (const auto& element, values) that "
                      "returns one for a vertex, an edge, a face or a corner");
        return T(born);
    }
}

/// A holder of a rule that can be assigned. A rule that cannot be assigned itself, since its functions capture
/// something, is shared.
template <class Rule>
class assignable {
    static constexpr bool is_shared = not std::is_copy_assignable_v<Rule>;

public:
    explicit assignable(Rule rule) : rule_(kept(std::move(rule))) {}
    [[nodiscard]] const Rule& operator*() const
    {
        if constexpr (is_shared)
            return *rule_;
        else
            return rule_;
    }

private:
    static auto kept(Rule rule)
    {
        if constexpr (is_shared)
            return std::make_shared<const Rule>(std::move(rule));
        else
            return rule;
    }

    std::conditional_t<is_shared, std::shared_ptr<const Rule>, Rule> rule_;
};

/// Calls f.operator()<kind>(id, tuple) for each new element that has a column in `list`, on several threads.
template <level Level, element_ids Ids, class... Columns, class F>
void for_new_elements(const Level& coarse, const Ids& ids, const std::tuple<Columns...>& list, const F& f)
{
    const auto in_column = [&]<tuple_kind K, class W, class D>(const column<K, W, D>&) {
        for_parts(tuple_count(coarse, K), Level::parallel, [&](std::size_t begin, std::size_t end) {
            for (std::size_t tuple = begin; tuple < end; ++tuple)
                if (const auto id = ids.template id<K>(tuple); id != ids.none)
                    f.template operator()<K>(std::size_t(id), tuple);
        });
    };
    std::apply([&](const auto&... c) { (in_column(c), ...); }, list);
}
/// Calls f(corner, tuple) for each corner of the next level, on several threads. The tuple is the one that made its
/// face.
template <level Level, level_numbering Numbering, class F>
void for_new_corners(const Level& fine, const Numbering& ids, const F& f)
{
    for_parts(fine.face_count(), fine.parallel, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto face = ids.faces.origin(i);
            for (const auto c : fine.faces()[i].corners())
                f(c, face);
        }
    });
}
template <finished_step Step>
auto columns_of_step(const Step& step)
{
    return columns_of(step.scheme, step.generation);
}

/// Writes the values of the new elements of a kind. An element whose parent is of that kind, too, inherits from it by
/// `rule.inherit`, if the condition inherits(id, parent) holds or none is given. All other elements have `rule.born`.
template <element_kind Kind, class T, class Rule, finished_step Step, class... Inherits>
void inherit_values(storage<T>& result, std::span<const T> values, const Rule& rule, const Step& step,
                    const Inherits&... inherits)
{
    const auto fill = [&](const auto& ids, const auto& columns) {
        for_new_elements(step.coarse, ids, columns.list, [&]<tuple_kind K>(std::size_t id, std::size_t tuple) {
            constexpr bool may_inherit = parent_kind(K) == Kind;
            if constexpr (may_inherit) {
                const std::size_t old = parent(step.coarse, K, tuple);
                if ((inherits(id, old) and ...)) {
                    result[id] = T(std::invoke(rule.inherit, values[old]));
                    return;
                }
            }
            // If all elements with such parents inherit, `born` need not be a function of them.
            if constexpr (not may_inherit or sizeof...(Inherits) != 0)
                result[id] = born_value<T>(rule.born, tuple_element<K>(step.coarse, tuple), values);
        });
    };
    const auto columns = columns_of_step(step);
    if constexpr (Kind == element_kind::vertex)
        fill(step.ids.vertices, columns.vertices);
    else if constexpr (Kind == element_kind::edge)
        fill(step.ids.edges, columns.edges);
    else
        fill(step.ids.faces, columns.faces);
}

} // namespace detail

} // namespace kith
