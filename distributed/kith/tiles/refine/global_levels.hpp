// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tile_step.hpp"

#include <kith/engine/neighbourhood/scheme_forecast.hpp>
#include <kith/tiles/number/column_facts.hpp>
#include <kith/tiles/number/corners_at_vertices.hpp>
#include <kith/tiles/number/global_lineage.hpp>
#include <kith/tiles/number/global_numbering.hpp>
#include <kith/tiles/part/reach.hpp>

#include <concepts>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace kith {

/// The data on the whole mesh that all tiles of a refinement need, level by level: the counts of elements, their
/// numbering, and the rings of ghosts. They are the same on every rank. They are made without communication, from the
/// counts of the control mesh and the faces along its boundary.
template <declared_columns Columns>
class global_levels {
    static_assert(
        std::tuple_size_v<decltype(Columns::edges.list)> != 0,
        "the edges of a tile need numbers in the whole mesh, which matching cannot give; let the scheme's columns "
        "declare new_edges");

public:
    /// Makes the data of levels 0 to `levels`. `rim` is a tile that owns all faces of level 0 that touch the boundary,
    /// with at least ring_schedule(scheme, levels, 1)[0] rings; `scheme` is the scheme of this tile. `rim` may be empty
    /// if the mesh is closed or the numbers do not depend on the boundary (numbers_boundary). Its generation must be
    /// that of the control mesh even then.
    /// Errors: mesh_error when there are more elements than global_id can number.
    /// Cost: that of refining the boundary.
    template <tile_like Tile, reaching_scheme Scheme>
        requires std::same_as<columns_type<Scheme>, Columns>
    global_levels(const global_counts& control, Tile rim, Scheme scheme, int levels, int last_rings = 0)
        : rings_(ring_schedule(scheme, levels, last_rings)), counts_{control}
    {
        const auto rim_rings = ring_schedule(
            scheme, levels, 1); // one ring at the end, so that the whole boundary is complete
        const int generation = rim.mesh.generation();
        corners_.emplace_back();
        for (int level = 0; level < levels; ++level) {
            numberings_.emplace_back(counts_.back(), columns_of(scheme, generation + level), rim);
            counts_.push_back(numberings_.back().counts());
            if (rim.mesh.face_count() != 0) {
                Scheme next_scheme = scheme;
                auto step = detail::refined_tile(rim, next_scheme, numberings_.back());
                step.keep_boundary();
                Tile next = step.trim(rim_rings[std::size_t(level) + 1],
                                      [&](const auto& part) { detail::restrict_state(scheme, next_scheme, part); });
                corners_.emplace_back(next);
                if constexpr (numbers_corners_at_vertices<Columns>)
                    corners_.back().number(next);
                rim = std::move(next);
            } else {
                detail::advance_without_elements<decltype(rim.mesh)>(scheme, generation + level);
                corners_.emplace_back();
            }
        }
    }

    [[nodiscard]] int levels() const { return int(numberings_.size()); }
    [[nodiscard]] const global_counts& counts(int level) const { return counts_[std::size_t(level)]; }
    [[nodiscard]] int rings(int level) const { return rings_[std::size_t(level)]; }
    [[nodiscard]] const global_numbering<Columns>& numbering(int level) const
    {
        return numberings_[std::size_t(level)];
    }
    [[nodiscard]] const corners_at_vertices& corners(int level) const { return corners_[std::size_t(level)]; }

    /// Returns the ancestors and descendants over all levels, by numbers. `control` has all runs of the control mesh.
    /// Cost: O(boundary).
    [[nodiscard]] global_lineage<Columns> lineage(const control_runs& control) const
    {
        return {counts_, numberings_, corners_, control.joined()};
    }

private:
    std::vector<int> rings_;
    std::vector<global_counts> counts_;
    std::vector<global_numbering<Columns>> numberings_;
    std::vector<corners_at_vertices> corners_;
};

template <tile_like Tile, reaching_scheme Scheme, class... Rest>
global_levels(const global_counts&, Tile, Scheme, Rest...) -> global_levels<columns_type<Scheme>>;

/// The data on the whole mesh for the tiles of a scheme.
template <reaching_scheme Scheme>
using global_levels_of = global_levels<columns_type<Scheme>>;

} // namespace kith
