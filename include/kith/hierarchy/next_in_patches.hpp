// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/level/to_native.hpp>
#include <kith/engine/last_level.hpp>
#include <kith/engine/refine_in_patches.hpp>
#include <kith/fields/values_in_patches.hpp>
#include <kith/numbering/step/step.hpp>

#include <optional>
#include <type_traits>
#include <utility>

namespace kith {

/// Returns the level after `level`, made in patches of an earlier level, and in `ids` the numbering of the step to it.
/// Returns nothing if that is slower. Returns nothing, too, if that level is not in memory, or if the points of a level
/// after it were moved. `levels` is a store of native meshes that has level 0 and `level` in memory.
template <class Mesh, scheme Scheme, class Store>
std::optional<Mesh> next_in_patches([[maybe_unused]] const Store& levels, [[maybe_unused]] int level,
                                    [[maybe_unused]] numbering_of<Scheme, typename Mesh::index_type>& ids)
{
#ifdef KITH_HAS_LANES
    if constexpr (patchable_scheme<Scheme, typename Mesh::point_type, typename Mesh::index_type>) {
        using refinement = patch_refinement<typename Mesh::point_type, typename Mesh::index_type, Scheme>;
        const auto &control = levels.entry_at(0), &coarse = levels.entry_at(level);
        refinement patches(control.here->mesh, control.scheme, level + 1, connect::everything);
        if (not patches.is_worth_looking())
            return {};
        const auto& begin = levels.entry_at(patches.begin());
        for (int later = patches.begin() + 1; later <= level; ++later)
            if (levels.entry_at(later).is_moved)
                return {};
        if (not begin.here)
            return {};
        native_last_level<typename Mesh::point_type, typename Mesh::index_type> last(connect::everything);
        if (not patches.refine_from(begin.here->mesh, begin.scheme, last))
            return {};
        ids = with_native_level<Scheme>(coarse.here->mesh, [&](const auto& elements) {
            return numbering_of<Scheme, typename Mesh::index_type>(
                elements, columns_of(coarse.scheme, coarse.here->mesh.generation()));
        });
        return last.take();
    }
#endif
    return {};
}

/// Returns a field of level `from` at level `to`. Its last steps are made at once if that is a gain. by_levels(first,
/// last, field) carries it level by level. `levels` is a store of levels on any mesh.
/// Errors: those of by_levels. Cost: that of the rule.
template <scheme Scheme, class Store, class Field, class ByLevels>
Field carry_in_patches([[maybe_unused]] const Store& levels, int from, int to, Field values, const ByLevels& by_levels)
{
#ifdef KITH_HAS_LANES
    using index = typename std::remove_cvref_t<decltype(levels.elements(from))>::index_type;
    if constexpr (goes_in_patches<Field, Scheme, index>) {
        const auto native = [&](int level) -> decltype(auto) {
            return native_of(levels.at(level).here->mesh, levels.elements(level), levels.generation(level));
        };
        const auto& control = native(from);
        const auto begin_at = [&](int begin) {
            if (values.empty() or begin == to or levels.entry_at(begin).here == nullptr)
                return false;
            values = by_levels(from, begin, std::move(values));
            from = begin;
            return true;
        };
        if constexpr (is_masked_in_patches<Field, Scheme, index>) {
            using value = typename Field::value_type;
            patch_refinement<value, index, Scheme> patches(
                control.topology(), control.generation(), levels.at(from).scheme, to - from, connect::nothing);
            if (patches.is_worth_looking() and begin_at(from + patches.begin())) {
                const auto& level = native(from);
                const basic_mesh<value, index> points(
                    storage<value>(values.values()), connectivity<index>(level.topology()), level.generation());
                last_values<value> last;
                if (patches.refine_from(points, levels.at(from).scheme, last))
                    return Field(last.take(), values.rule());
            }
        } else {
            const auto plan = plan_patches(count(control.topology()),
                                           control.topology().degree,
                                           levels.at(from).scheme,
                                           to - from,
                                           control.generation());
            if (plan and not are_patches_ruled_out() and begin_at(from + plan->begin)) {
                const auto& level = native(from);
                const auto& scheme = levels.at(from).scheme;
                if (plan->has_counts_of(level.topology(), scheme, level.generation()))
                    if (const fields_in_patches in_patches(
                            level.topology(), level.generation(), scheme, *plan, connect::everything);
                        in_patches.can_take(values))
                        return in_patches.last(values);
            }
        }
    }
#endif
    return by_levels(from, to, std::move(values));
}

} // namespace kith
