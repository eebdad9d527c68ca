// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/engine/refine_in_patches.hpp>
#include <kith/step/step.hpp>

#include <optional>

namespace kith {

/// Returns the level after `level`, in patches of a level some steps before, and in `ids` the numbering of the step to
/// it. Returns nothing if that is slower, and if that level is not in memory or the points of a level after it were
/// moved. `levels` is a store of native meshes that has level 0 and `level` in memory.
template <class Mesh, scheme Scheme, class Store>
std::optional<Mesh> next_in_patches([[maybe_unused]] const Store& levels, [[maybe_unused]] int level,
                                    [[maybe_unused]] numbering_of<Scheme, typename Mesh::index_type>& ids)
{
#ifdef KITH_HAS_LANES
    if constexpr (patchable_scheme<Scheme, typename Mesh::point_type, typename Mesh::index_type>) {
        using refinement = patch_refinement<typename Mesh::point_type, typename Mesh::index_type, Scheme>;
        const auto &control = levels.entry_at(0), &coarse = levels.entry_at(level);
        const refinement patches(control.here->mesh, control.scheme, level + 1, connect::everything);
        if (not patches.is_worth_looking())
            return {};
        const auto& begin = levels.entry_at(patches.begin());
        for (int later = patches.begin() + 1; later <= level; ++later)
            if (levels.entry_at(later).is_moved)
                return {};
        if (not begin.here)
            return {};
        auto fine = patches.refine_from(begin.here->mesh, begin.scheme);
        if (fine)
            ids = with_native_level<Scheme>(coarse.here->mesh, [&](const auto& elements) {
                return numbering_of<Scheme, typename Mesh::index_type>(
                    elements, columns_of(coarse.scheme, coarse.here->mesh.generation()));
            });
        return fine;
    }
#endif
    return {};
}

} // namespace kith
