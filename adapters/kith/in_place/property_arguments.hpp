// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "carried_values.hpp"

#include <cstddef>
#include <memory>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith {

/// An argument of the dialects that names types of values which kith does not know. Properties of these types are
/// carried by the usual rules: averaged if the type has a mean.
template <class... T>
struct value_types {};

namespace in_place {

/// The properties of one value type, carried by a rule of the caller, or by the usual rule if the type has its own
/// mean.
template <mesh_with_properties M, class Handle, class T, class Rule>
class ruled_properties {
    static constexpr field_on where = kith::detail::kind_of_handle<M, Handle>;

public:
    using handle = Handle;
    using value_type = T;

    /// Reads a property. Returns the name, type and array by which its library knows it, or nothing if no property of
    /// this type has the name.
    std::vector<kith::detail::known_property> read(const M& mesh, const std::vector<Handle>& handles,
                                                   kith::detail::unset_values<M>& unset, const std::string& name,
                                                   const Rule& rule)
    {
        const auto from = property_access<M>::template find<Handle, T>(mesh, name);
        if (not from)
            return {};
        storage<T> values(handles.size());
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = from[handles[i]];
        all_.push_back({name, field<where, T, Rule>(values, rule), unset.template of<Handle, T>(name)});
        const void* array = nullptr;
        if constexpr (requires { from.array(); })
            array = from.array();
        return {{name, typeid(T), array}};
    }
    /// Takes the values to the next level. If `points_stay`, old vertices keep their values.
    template <finished_step Step>
    void advance(const Step& step, bool points_stay)
    {
        for (one& each : all_) {
            field<where, T, Rule> next(each.values.rule());
            if constexpr (where != field_on::edges or Step::numbering_type::has_edges)
                next = each.values.after(step);
            if constexpr (where == field_on::vertices)
                for (std::size_t v = 0; points_stay and v < each.values.size(); ++v)
                    next[v] = each.values[v];
            each.values = std::move(next);
        }
    }
    [[nodiscard]] bool empty() const { return all_.empty(); }
    /// Writes the values. Unless `swaps` is null, adds to it the objects that can exchange the values with others.
    void write(M& mesh, const kith::detail::written_places<Handle>& places,
               std::vector<std::unique_ptr<kith::detail::value_exchange>>* swaps) const
    {
        for (const one& each : all_) {
            auto to = kith::detail::add_unset<Handle>(mesh, each.name, each.nothing);
            for (std::size_t i = 0; i < places.elements.size(); ++i)
                to[places.elements[i]] = i < each.values.size() ? each.values[i] : each.nothing;
            kith::detail::store_nothing(to, places.beside_faces, each.nothing);
            if (swaps != nullptr)
                if (auto swap = kith::detail::exchange_of<M, Handle, T>(to))
                    swaps->push_back(std::move(swap));
        }
    }

private:
    struct one {
        std::string name;
        field<where, T, Rule> values;
        T nothing;
    };
    std::vector<one> all_;
};

/// Carried values, together with values that are carried by rules.
template <class Number, class... Ruled>
struct values_with_rules : carried_values<Number> {
    using carried_values<Number>::carried_values;

    template <finished_step Step>
    void advance(const Step& step, bool points_stay)
    {
        carried_values<Number>::advance(step, points_stay);
        std::apply([&](Ruled&... each) { (each.advance(step, points_stay), ...); }, ruled);
    }

    /// Returns false, since rules of the caller apply to single steps.
    template <scheme Scheme>
    [[nodiscard]] bool may_go_in_patches() const
    {
        return false;
    }

    std::tuple<Ruled...> ruled;
};

/// The lists of ruled properties that an argument of a dialect asks for.
template <class M, class Argument>
struct ruled_for;
template <class M, class Handle, class T, class Rule>
struct ruled_for<M, property_by_rule<Handle, T, Rule>> {
    using type = std::tuple<ruled_properties<M, Handle, T, Rule>>;
};
template <class M, class... T>
struct ruled_for<M, kith::value_types<T...>> {
    template <class Handle, class Value>
    using own_mean = std::conditional_t<
        kith::detail::has_mean_of_its_own<Value, Handle, M>,
        std::tuple<ruled_properties<M, Handle, Value, decltype(kith::detail::rule_of_means<M, Handle>())>>,
        std::tuple<>>;
    using type = decltype(std::tuple_cat(std::declval<own_mean<typename mesh_traits<M>::vertex, T>>()...,
                                         std::declval<own_mean<typename mesh_traits<M>::halfedge, T>>()...));
};
template <class Number, class Tuple>
struct values_for;
template <class Number>
struct values_for<Number, std::tuple<>> {
    using type = carried_values<Number>; // compiled with the schemes
};
template <class Number, class... Ruled>
struct values_for<Number, std::tuple<Ruled...>> {
    using type = values_with_rules<Number, Ruled...>;
};

} // namespace in_place

} // namespace kith
