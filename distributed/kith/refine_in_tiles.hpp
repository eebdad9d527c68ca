// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/tiles/part/partition.hpp>
#include <kith/tiles/part/phase_seconds.hpp>
#include <kith/tiles/part/require_control.hpp>
#include <kith/tiles/part/scheme_members.hpp>
#include <kith/tiles/part/tiles_at_once.hpp>
#include <kith/tiles/refine/cut_tiles.hpp>
#include <kith/tiles/refine/refine_tile.hpp>

#include <cstddef>
#include <mutex>
#include <utility>

namespace kith {

/// A control mesh that is refined part by part on one machine. Only the tiles that are being refined are in memory, so
/// that a surface may be larger than the memory. The bits and the numbers are those of `refine`.
template <class Point, std::unsigned_integral Index, reaching_scheme Scheme>
class tiled_refinement {
public:
    /// Prepares the refinement of `mesh`, which must outlive this object. `last_rings` is the number of rings of ghosts
    /// on the last level, for tiles that keep their edges there. Errors: mesh_error for everything that `refine`
    /// refuses except lack of memory; for a mesh of face-vertex lists only; for a partition of another mesh; and for
    /// more elements than 64 bits can number. Cost: that of the control mesh, and of refining its boundary.
    tiled_refinement(const basic_mesh<Point, Index>& mesh, const Scheme& scheme, int levels, const partition& parts,
                     int last_rings = 0)
        : cutter_(checked(mesh, scheme, levels), scheme, parts.part_of, parts.parts)
        , whole_(whole_of(cutter_, scheme, levels, last_rings))
    {
        detail::require_named_state<Scheme>();
    }
    /// Rejects a temporary mesh, which would be destroyed before its tiles are cut.
    tiled_refinement(const basic_mesh<Point, Index>&& mesh, const Scheme& scheme, int levels, const partition& parts,
                     int last_rings = 0) = delete;

    /// Returns the numbering of all levels.
    [[nodiscard]] const global_levels_of<Scheme>& whole() const { return whole_; }
    [[nodiscard]] std::size_t tiles() const { return cutter_.parts(); }

    /// Returns the ancestors and descendants over all levels, in the numbers of the whole mesh. Cost: O(control mesh).
    [[nodiscard]] auto lineage() const { return whole_.lineage(cutter_.runs()); }

    /// Returns the last level of one part, with its edges if `last` is connect::everything. Several threads may call
    /// this at once, each for a part of its own (see for_each_at_once). Errors: as `refine`.
    [[nodiscard]] tile<Point, Index> refine(std::size_t part, connect last = connect::faces)
    {
        phase_seconds seconds;
        return refine(part, last, seconds);
    }
    /// Returns the same tile and adds the time to cut the part and to refine it to `seconds`.
    [[nodiscard]] tile<Point, Index> refine(std::size_t part, connect last, phase_seconds& seconds)
    {
        return std::move(refine_job(part, last, seconds).part);
    }
    /// Returns the same tile with the scheme for the next level, if the tile keeps its edges.
    [[nodiscard]] tile_job<tile<Point, Index>, Scheme> refine_job(std::size_t part, connect last,
                                                                  phase_seconds& seconds)
    {
        auto job = cut(part, seconds);
        const phase_timer timer(seconds[phase::refine]);
        kith::refine(job, whole_, last, [](const auto&) {});
        return job;
    }
    /// Hands over all levels of one part, from level 0 to the last, each with its scheme (creases, fields) on that
    /// level: keep(kept_tile), which may move it away. All levels have their edges and the ghosts that later levels
    /// need. Errors: as `refine`. Cost: as refine_job; two levels are in memory, and the levels that `keep` stores.
    template <std::invocable<kept_tile<tile<Point, Index>, Scheme>> Keep>
    void refine_levels(std::size_t part, const Keep& keep)
    {
        phase_seconds seconds;
        kith::refine_levels(part, cut(part, seconds), whole_, keep);
    }

private:
    tile_job<tile<Point, Index>, Scheme> cut(std::size_t part, phase_seconds& seconds)
    {
        const std::lock_guard lock(cutting_);
        const phase_timer timer(seconds[phase::cut]);
        return cutter_.cut(part, whole_.rings(0));
    }
    static const basic_mesh<Point, Index>& checked(const basic_mesh<Point, Index>& mesh, const Scheme& scheme,
                                                   int levels)
    {
        detail::require_control(mesh, scheme, levels);
        return mesh;
    }
    static global_levels_of<Scheme> whole_of(tile_cutter<Point, Index, Scheme>& cutter, const Scheme& scheme,
                                             int levels, int last_rings)
    {
        auto rim = cutter.cut_rim(ring_schedule(scheme, levels, 1)[0]);
        return {cutter.counts(), std::move(rim.part), std::move(rim.scheme), levels, last_rings};
    }

    std::mutex cutting_;
    tile_cutter<Point, Index, Scheme> cutter_;
    global_levels_of<Scheme> whole_;
};

// Deduces for a scheme without reach a type that refuses it in one sentence.
template <class Point, std::unsigned_integral Index, scheme Scheme, class... Rest>
tiled_refinement(const basic_mesh<Point, Index>&, const Scheme&, int, const partition&, Rest...)
    -> tiled_refinement<Point, Index, detail::refused_in_tiles<Scheme>>;

} // namespace kith
