// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "field.hpp"

#include <kith/core/base/for_parts.hpp>
#include <kith/engine/neighbourhood/descents.hpp>
#include <kith/engine/neighbourhood/face_children.hpp>
#include <kith/engine/patch/patched_level.hpp>
#include <kith/fields/rules/corner_rules.hpp>
#include <kith/fields/rules/edge_rules.hpp>
#include <kith/fields/rules/linear_masks.hpp>
#include <kith/fields/rules/vertex_rules.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith {

/// True for a field at vertices, of numbers or arrays of up to four, that goes by the masks of a scheme with patches.
/// Patches treat its values as points with fewer or more coordinates.
template <class Field, class Scheme, class Index>
inline constexpr bool is_masked_in_patches = false;
template <class T, class Scheme, class Index>
    requires patchable_scheme<Scheme, T, Index>
inline constexpr bool is_masked_in_patches<field<field_on::vertices, T, by_mask>, Scheme, Index> = true;

/// A rule of values at corners that may be linear inside faces, and tells whether it is.
template <class Rule>
concept linear_corner_rule = requires(const Rule& rule) {
    { rule.is_linear_in_faces() } -> std::convertible_to<bool>;
};

/// True for a field whose new elements inherit, without a change, from the elements from which they descend. Values at
/// corners follow from the face from which their face comes.
template <class Field, class Scheme, class Index>
inline constexpr bool is_inherited_in_patches = false;
template <field_on Where, class T, class Rule, class Scheme, class Index>
    requires faces_descend_from_faces<Scheme, Index> and patchable_scheme<Scheme, double, Index>
inline constexpr bool is_inherited_in_patches<field<Where, T, Rule>, Scheme, Index> =
    (Where == field_on::corners and (std::same_as<Rule, along_sides> or linear_corner_rule<Rule>)) or
    (Where == field_on::edges and std::same_as<Rule, along_edges<>>) or
    (Where == field_on::vertices and std::same_as<Rule, from_vertex<>>);
template <class T, class Born, class Scheme, class Index>
    requires faces_descend_from_faces<Scheme, Index> and patchable_scheme<Scheme, double, Index>
inline constexpr bool
    is_inherited_in_patches<field<field_on::faces, T, from_parent<std::identity, Born>>, Scheme, Index> = true;

/// True for fields, and for bundles that list the types of theirs, all of which may go through several steps at once.
template <class Fields, class Scheme, class Index>
inline constexpr bool go_in_patches = false;
template <class State, class Scheme, class Index>
inline constexpr bool goes_in_patches = is_masked_in_patches<State, Scheme, Index> or
                                        is_inherited_in_patches<State, Scheme, Index>;
template <class State, class Scheme, class Index>
    requires requires { typename State::fields; }
inline constexpr bool goes_in_patches<State, Scheme, Index> = go_in_patches<typename State::fields, Scheme, Index>;
template <class... State, class Scheme, class Index>
inline constexpr bool go_in_patches<std::tuple<State...>, Scheme, Index> = sizeof...(State) != 0 and
                                                                           (goes_in_patches<State, Scheme, Index> and
                                                                            ...);

#ifdef KITH_HAS_LANES

/// A carrier of fields through the last steps of a refinement at once, to the bits of one step after the other.
template <std::unsigned_integral Index, scheme Scheme>
class fields_in_patches {
public:
    /// Takes the level with which the plan begins, which has this connectivity, generation and scheme. Precondition:
    /// the counts of the level are those of the plan. Cost: that of a step around a face.
    fields_in_patches(const connectivity<Index>& level, int generation, const Scheme& scheme, const patch_plan& plan,
                      connect last_level)
        : level_(level), generation_(generation), scheme_(scheme), plan_(plan), last_level_(last_level)
    {
        if constexpr (faces_descend_from_faces<Scheme, Index> and patchable_scheme<Scheme, double, Index>)
            children_ = recorder_of<double, Index, Scheme>(scheme, plan, generation, {})
                            ->children_of_faces(level, generation);
    }

    /// Returns true if a field, of a type that goes_in_patches, can be taken. Corners need faces whose children have
    /// nothing from other faces, and values on edges need edges of the last level.
    template <field_on Where, class T, class Rule>
    [[nodiscard]] bool can_take(const field<Where, T, Rule>& values) const
    {
        if constexpr (Where == field_on::corners and linear_corner_rule<Rule>)
            return values.empty() or (children_ and values.rule().is_linear_in_faces());
        else if constexpr (Where == field_on::edges)
            return values.empty() or (children_ and last_level_ == connect::everything);
        else
            return values.empty() or children_ or Where == field_on::faces or
                   is_masked_in_patches<field<Where, T, Rule>, Scheme, Index>;
    }
    template <class Bundle>
        requires requires { typename Bundle::fields; }
    [[nodiscard]] bool can_take(const Bundle& bundle) const
    {
        bool result = true;
        bundle.for_each_field([&](const auto& each) { result = result and can_take(each); });
        return result;
    }

    /// Returns a field at the last level. Precondition: can_take(values). Cost: that of the masks of the last level, or
    /// of writing its values.
    template <field_on Where, class T, class Rule>
    [[nodiscard]] field<Where, T, Rule> last(const field<Where, T, Rule>& values) const
    {
        using field_type = field<Where, T, Rule>;
        if (values.empty())
            return values;
        if constexpr (is_masked_in_patches<field_type, Scheme, Index>)
            return field_type(masked(values), values.rule());
        else if constexpr (Where == field_on::vertices)
            return field_type(inherited<T>(values.values(), plan_.last().vertices, vertex_columns()), values.rule());
        else if constexpr (Where == field_on::edges)
            return field_type(inherited<T>(values.values(), plan_.last().edges, edge_columns()), values.rule());
        else if constexpr (Where == field_on::faces)
            return field_type(of_faces(values), values.rule());
        else if constexpr (std::same_as<Rule, along_sides>)
            return field_type(at_corners(values, corner_labels<T>(*children_)), values.rule());
        else
            return field_type(at_corners(values, linear_corners<T>(*children_)), values.rule());
    }
    template <class Bundle>
        requires requires { typename Bundle::fields; }
    [[nodiscard]] Bundle last(const Bundle& bundle) const
    {
        return bundle.carried([&](const auto& each) { return last(each); });
    }

private:
    /// The columns by which a new element inherits from an element of its own kind.
    using columns = std::vector<tuple_kind>;

    static columns vertex_columns() { return {tuple_kind::v}; }
    [[nodiscard]] columns edge_columns() const
    {
        columns result;
        if (children_->middles_lie_along_edges)
            result.push_back(tuple_kind::e);
        if (children_->ends_lie_along_edges)
            result.push_back(tuple_kind::ve);
        return result;
    }

    template <class T>
    [[nodiscard]] storage<T> masked(const field<field_on::vertices, T, by_mask>& values) const
    {
        storage<T> result(plan_.last().vertices);
        const face_classes<Index> classes(level_, plan_.rings, state_marks<Index>(level_, scheme_));
        const basic_mesh<T, Index> mesh(storage<T>(values.values()), connectivity<Index>(level_), generation_);
        make_patches(mesh, classes, scheme_, plan_, strategy_costs::without_choice())->fill(mesh, {result.data()});
        return result;
    }
    template <class T, class Rule>
    [[nodiscard]] storage<T> of_faces(const field<field_on::faces, T, Rule>& values) const
    {
        storage<T> result(plan_.last().faces);
        for (const descent& way : descents_of(tuple_kind::f, plan_.bases, degree))
            for (std::size_t f = 0; f < values.size(); ++f)
                std::fill_n(result.begin() + way.first + way.each * f, way.each, values[f]);
        return result;
    }
    /// Returns values of vertices or edges, inherited if they descend from one of their kind by these columns alone.
    template <class T>
    [[nodiscard]] storage<T> inherited(std::span<const T> values, std::size_t size, const columns& along) const
    {
        const tuple_kind made = along == vertex_columns() ? tuple_kind::v : tuple_kind::e;
        storage<T> result(size);
        std::ranges::fill(result, detail::value_of_nothing<T>());
        std::vector<descent> ways{{made, made, 0, 1}};
        for (const column_bases& step : plan_.bases) {
            std::vector<descent> next;
            for (const descent& way : ways)
                for (const tuple_kind kind : along)
                    if (step.count(made, kind) != 0) {
                        const std::uint64_t each = kind == tuple_kind::ve ? 2 : 1;
                        next.push_back({made, kind, step.base(made, kind) + each * way.first, each * way.each});
                    }
            ways = std::move(next);
        }
        for (const descent& way : ways)
            for (std::size_t i = 0; i < values.size(); ++i)
                std::fill_n(result.begin() + way.first + way.each * i, way.each, values[i]);
        return result;
    }

    /// The labels of the corners of a face, and of the corners of its children.
    template <class T>
    class corner_labels {
    public:
        explicit corner_labels(const face_children&) {}
        void at_face(const T* corners) { corners_ = corners; }
        [[nodiscard]] T at_child(const face_children::child& child, std::size_t k) const
        {
            return child.along[k] == 0 ? detail::value_of_nothing<T>() : corners_[child.along[k] - 1];
        }

    private:
        const T* corners_ = nullptr;
    };
    /// The values at the corners of a face and of its children, if they are linear inside the face.
    template <class T>
    class linear_corners {
        using masks = detail::linear_masks_of<T, std::remove_cvref_t<decltype(numbering_of<Scheme, Index>().vertices)>>;

    public:
        explicit linear_corners(const face_children& children)
            : tuples_(children.tuples), values_(children.tuples.size())
        {
        }
        void at_face(const T* corners)
        {
            detail::blend<T> sum(corners[0]);
            for (std::size_t k = 1; k < degree; ++k)
                sum.add(corners[k]);
            const T mean = sum.over(degree);
            for (std::size_t i = 0; i < tuples_.size(); ++i)
                values_[i] = value(tuples_[i], corners, mean);
        }
        [[nodiscard]] const T& at_child(const face_children::child& child, std::size_t k) const
        {
            return values_[child.vertices[k]];
        }

    private:
        [[nodiscard]] T value(const tuple_in_face& tuple, const T* corners, const T& mean) const
        {
            const T &here = corners[tuple.corner], &next = corners[(tuple.corner + 1) % degree];
            const T& before = corners[(tuple.corner + degree - 1) % degree];
            switch (tuple.kind) {
            case tuple_kind::v: return here;
            case tuple_kind::e: return masks::middle(here, next);
            case tuple_kind::ve: return tuple.is_first ? masks::third(here, next) : masks::third(next, here);
            case tuple_kind::f: return mean;
            case tuple_kind::vf: return masks::in_face(here, mean);
            case tuple_kind::ef: return masks::middle(masks::middle(here, next), mean);
            default: return masks::of_three(here, masks::middle(here, tuple.is_first ? next : before), mean);
            }
        }

        std::span<const tuple_in_face> tuples_;
        std::vector<T> values_;
    };

    /// Returns the values at the corners of the last level. A copy of `maker` makes each step down, depth first.
    template <class T, class Rule, class Maker>
    [[nodiscard]] storage<T> at_corners(const field<field_on::corners, T, Rule>& values, const Maker& maker) const
    {
        storage<T> result(degree * plan_.last().faces);
        detail::for_parts(
            level_.faces, detail::is_worth_threads(plan_.last().faces), [&](std::size_t begin, std::size_t end) {
                std::vector<Maker> makers(plan_.bases.size(), maker);
                std::vector<std::array<T, degree>> corners(plan_.bases.size());
                const auto descend = [&](const auto& again, std::size_t face, const T* here, std::size_t step) -> void {
                    makers[step].at_face(here);
                    for (const face_children::child& child : children_->children) {
                        const std::size_t number = plan_.bases[step].base(tuple_kind::f, child.born.kind) +
                                                   child.tuple_of(face, degree);
                        const bool is_last = step + 1 == plan_.bases.size();
                        T* const to = is_last ? result.data() + degree * number : corners[step].data();
                        for (std::size_t k = 0; k < degree; ++k)
                            to[k] = makers[step].at_child(child, k);
                        if (not is_last)
                            again(again, number, to, step + 1);
                    }
                };
                for (std::size_t f = begin; f < end; ++f)
                    descend(descend, f, values.values().data() + degree * f, 0);
            });
        return result;
    }

    static constexpr std::size_t degree = numbering_of<Scheme, Index>::common_degree;

    const connectivity<Index>& level_;
    int generation_;
    const Scheme& scheme_;
    const patch_plan& plan_;
    connect last_level_;
    std::optional<face_children> children_;
};

#endif

} // namespace kith
