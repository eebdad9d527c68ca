// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "field.hpp"

#include <kith/engine/refine_in_patches.hpp>
#include <kith/neighbourhood/descents.hpp>
#include <kith/patch/patched_level.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <functional>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>

namespace kith {

/// A field of numbers, or arrays of up to four, at vertices that goes by the masks of a scheme with patches. To patches
/// its values are points with fewer or more coordinates.
template <class Field, class Scheme, class Index>
inline constexpr bool is_masked_in_patches = false;
template <class T, class Scheme, class Index>
    requires patchable_scheme<Scheme, T, Index>
inline constexpr bool is_masked_in_patches<field<field_on::vertices, T, by_mask>, Scheme, Index> = true;

/// A field of labels: faces have what the face has from which they descend, without a change.
template <class Field, class Scheme, class Index>
inline constexpr bool is_label_in_patches = false;
template <class T, class Born, class Scheme, class Index>
    requires faces_descend_from_faces<Scheme, Index>
inline constexpr bool is_label_in_patches<field<field_on::faces, T, from_parent<std::identity, Born>>, Scheme, Index> =
    true;

/// Fields all of which go through several steps at once.
template <class Fields, class Scheme, class Index>
inline constexpr bool go_in_patches = false;
template <class... Field, class Scheme, class Index>
inline constexpr bool go_in_patches<std::tuple<Field...>, Scheme, Index> =
    sizeof...(Field) != 0 and
    ((is_masked_in_patches<Field, Scheme, Index> or is_label_in_patches<Field, Scheme, Index>) and ...);

#ifdef KITH_HAS_LANES

/// Returns the field of the last level of a plan from that of the level with which the plan begins, which has this
/// connectivity, generation and scheme. Precondition: the counts of the level are those of the plan. Cost: that of the
/// masks of the last level, or of writing its labels.
template <field_on Where, class T, class Rule, std::unsigned_integral Index, scheme Scheme>
    requires go_in_patches<std::tuple<field<Where, T, Rule>>, Scheme, Index>
field<Where, T, Rule> after_patches(const field<Where, T, Rule>& values, const connectivity<Index>& level,
                                    int generation, const Scheme& scheme, const patch_plan& plan)
{
    if (values.empty())
        return values;
    storage<T> last(Where == field_on::vertices ? plan.last().vertices : plan.last().faces);
    if constexpr (Where == field_on::vertices) {
        const face_classes<Index> classes(level, plan.rings, state_marks<Index>(level, scheme));
        const basic_mesh<T, Index> mesh(storage<T>(values.values()), connectivity<Index>(level), generation);
        make_patches(mesh, classes, scheme, plan, patch_costs::without_choice())->fill(mesh, {last.data()});
    } else {
        for (const descent& way :
             descents_of(tuple_kind::f, plan.bases, numbering_of<Scheme, std::uint32_t>::common_degree))
            for (std::size_t f = 0; f < values.size(); ++f)
                std::fill_n(last.begin() + (way.first + way.each * f), way.each, values[f]);
    }
    return field<Where, T, Rule>(std::move(last), values.rule());
}

#endif

} // namespace kith
