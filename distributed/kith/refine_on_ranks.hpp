// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/base/error.hpp>
#include <kith/mpi/communicator.hpp>
#include <kith/mpi/in_agreement.hpp>
#include <kith/mpi/session.hpp>
#include <kith/part/partition.hpp>
#include <kith/part/phase_seconds.hpp>
#include <kith/ranks/deal_tiles.hpp>
#include <kith/ranks/hand_out_tiles.hpp>
#include <kith/ranks/require_tiles.hpp>
#include <kith/ranks/runs_of_ranks.hpp>
#include <kith/ranks/tile_generation.hpp>
#include <kith/ranks/work_done.hpp>
#include <kith/tile/cut_tiles.hpp>
#include <kith/tile/numbered_tile.hpp>
#include <kith/tile/pack.hpp>
#include <kith/tile/require_control.hpp>
#include <kith/tile/tiles_at_once.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace kith::mpi {

/// A control mesh refined in tiles on all ranks; it lies on rank 0, or its tiles are on their ranks already. Refinement
/// itself sends nothing.
template <class Point, std::unsigned_integral Index, reaching_scheme Scheme>
class rank_refinement {
public:
    using tile_type = tile<Point, Index>;
    using kept_type = kept_tile<tile_type, Scheme>;

    /// Collective. `mesh` and `parts` are read on rank 0 only, where the mesh must outlive this object; `scheme` has
    /// the same options on all ranks; its state of the control mesh (creases) counts on rank 0. `last_rings`: the last
    /// level keeps its edges and so many rings of shadows; without it only the owned faces are kept, in half of the
    /// memory. Errors: phase_error for everything that `refine` refuses, for a mesh of face-vertex lists only, for a
    /// partition of another mesh and for counts beyond 64 bits.
    rank_refinement(communicator& comm, const basic_mesh<Point, Index>& mesh, const Scheme& scheme, int levels,
                    const partition& parts, std::optional<int> last_rings = std::nullopt)
        : comm_(comm), scheme_(scheme), last_(last_rings ? connect::everything : connect::faces)
    {
        std::vector<std::byte> setting;
        in_agreement(comm, [&] {
            if (not comm.is_root())
                return;
            kith::detail::require_control(mesh, scheme_, levels);
            const phase_timer timer(seconds_[phase::cut]);
            cutter_.emplace(mesh, scheme_, parts.part_of, parts.parts);
            packer out;
            out.add(cutter_->counts()).add(std::uint64_t(parts.parts));
            out.add_array(pack(cutter_->cut_rim(ring_schedule(scheme, levels, 1)[0])));
            setting = out.take();
        });
        setting = comm.broadcast(std::move(setting));
        in_agreement(comm, [&] {
            unpacker in(setting);
            const auto counts = in.get<whole_counts>();
            tiles_ = in.get<std::uint64_t>();
            auto rim = unpack<Point, Index>(in.get_array<std::vector<std::byte>>(), scheme);
            whole_.emplace(counts, std::move(rim.part), std::move(rim.scheme), levels, last_rings.value_or(0));
        });
    }

    /// Collective. From tiles of level 0 that lie on their ranks already, with ring_schedule(scheme, levels,
    /// last_rings)[0] rings of shadows: read_tiles makes them of a file that is too large for one rank. State of
    /// the scheme (creases) is that of the whole mesh, by its numbers, as far as the tiles of this rank go.
    /// Errors: phase_error for tiles that are not numbered from 0 on, each once, faces that the scheme does not take,
    /// counts beyond 64 bits, and schemes whose numbers need more than a tile can tell: of the boundary, if the mesh
    /// has one, and of marked edges (4-8).
    rank_refinement(communicator& comm, std::vector<numbered_tile<tile_type>> tiles, const whole_counts& counts,
                    const Scheme& scheme, int levels, std::optional<int> last_rings = std::nullopt)
        : comm_(comm)
        , scheme_(scheme)
        , last_(last_rings ? connect::everything : connect::faces)
        , held_(std::move(tiles))
        , is_taken_(held_->size(), 0)
    {
        tiles_ = require_all_tiles(comm, *held_);
        const int generation = generation_of_tiles(comm, *held_);
        in_agreement(comm, [&] {
            kith::detail::require_levels<Scheme>(levels);
            const std::string name(scheme_name<Scheme>());
            if constexpr (marks_edges<Scheme>)
                throw mesh_error(name + ": its marked edges are counted where a whole mesh is cut; cut it on one rank");
            if (numbers_boundary<Scheme> and counts.corners != 2 * counts.edges)
                throw mesh_error(name +
                                 ": its numbers depend on the boundary, and the mesh has one; cut it on one rank");
            require_tiles(*held_, scheme_);
            if constexpr (not marks_edges<Scheme>)
                for (const auto& [number, part] : *held_)
                    runs_.append(control_runs_of<Scheme>(part));
            tile_type no_rim;
            no_rim.mesh = {{}, {}, generation};
            auto there = kith::detail::scheme_of_tile(scheme_, no_rim);
            whole_.emplace(counts, std::move(no_rim), std::move(there), levels, last_rings.value_or(0));
        });
    }

    /// Collective. The same from tiles of level 0 that have a scheme each, whose state (fields, creases) is numbered as
    /// the tile is; of `scheme` the options count. Errors: as above.
    rank_refinement(communicator& comm, std::vector<kept_type> tiles, const whole_counts& counts, const Scheme& scheme,
                    int levels, std::optional<int> last_rings = std::nullopt)
        : rank_refinement(comm, parts_of(tiles), counts, scheme, levels, last_rings)
    {
        for (auto& kept : tiles)
            held_schemes_.push_back(std::move(kept.scheme));
    }

    /// Local. The numbering of all levels.
    [[nodiscard]] const whole_levels<Scheme>& whole() const { return *whole_; }
    [[nodiscard]] std::uint64_t tiles() const { return tiles_; }

    /// Collective. Who descends from whom, over all levels and by the numbers of the whole mesh: the same on all ranks,
    /// and local from then on, wherever the tiles are moved. Errors: phase_error for lack of memory. Cost:
    /// runs_of_ranks, of which a mesh of one degree has one; O(boundary) memory.
    [[nodiscard]] whole_lineage<columns_type<Scheme>> lineage()
    {
        control_runs runs = runs_;
        in_agreement(comm_, [&] {
            if (cutter_)
                runs = cutter_->runs();
        });
        return whole_->lineage(runs_of_ranks(comm_, runs));
    }

    /// Collective. Refines all tiles, each on one rank, and calls `use(number, tile)` there with the last level, which
    /// `use` may move away; a third argument is the scheme for the next level, if this one keeps its edges. Tiles that
    /// lay on their ranks are refined there, once. A rank with several threads refines up to `most_at_once` of its
    /// tiles at once (tiles_at_once), and calls `use` on these threads. Errors: phase_error, of the first that has one.
    template <class Use>
    work_done refine(sharing how, const Use& use, std::size_t most_at_once = 1)
    {
        std::vector<std::uint64_t> all(tiles_);
        std::iota(all.begin(), all.end(), 0);
        return refine(how, all, use, most_at_once);
    }
    /// Collective. The same for some of the tiles, by their numbers, which are the same on all ranks. Errors: as above,
    /// and phase_error for a number that no tile has, and one that lay on its rank and has been refined.
    template <class Use>
    work_done refine(sharing how, const std::vector<std::uint64_t>& numbers, const Use& use,
                     std::size_t most_at_once = 1)
    {
        in_agreement(comm_, [&] {
            for (const std::uint64_t number : numbers)
                if (number >= tiles())
                    throw mesh_error("tile " + std::to_string(number) + " was asked for; there are " +
                                     std::to_string(tiles()) + ", numbered from 0");
            for (std::size_t i = 0; i < is_taken_.size(); ++i)
                if (is_taken_[i] != 0 and std::ranges::find(numbers, (*held_)[i].number) != numbers.end())
                    throw mesh_error("tile " + std::to_string((*held_)[i].number) +
                                     " lay on its rank and is used up; give its level 0 to another rank_refinement");
        });
        most_at_once_ = most_at_once;
        work_done done{.seconds = std::exchange(seconds_, {})};
        if (held_)
            refine_held(numbers, use, done);
        else if (how == sharing::spmd or comm_.size() == 1)
            refine_dealt(numbers, use, done);
        else
            refine_handed_out(numbers, use, done);
        done.seconds += std::exchange(seconds_, {});
        return done;
    }

    /// Collective. Refines all tiles as above and hands over each level of each, from level 0 to the last, with its
    /// scheme (creases, fields) as it is there: keep(kept_tile), which may move it away. All have their edges and the
    /// shadows that later levels need. Two levels of a tile are in memory, and those that are kept.
    /// Errors: as above, and phase_error where `last_rings` was left out: then the last level has no scheme.
    template <std::invocable<kept_type> Keep>
    work_done refine_levels(sharing how, const Keep& keep, std::size_t most_at_once = 1)
    {
        in_agreement(comm_, [&] {
            if (last_ != connect::everything)
                throw mesh_error(
                    "levels are handed over with their edges and their schemes, and without rings of shadows the "
                    "last one has neither; give last_rings, 0 or more, to rank_refinement");
        });
        return refine(how, keep, most_at_once);
    }
    /// Collective. Refines all tiles and returns all levels of those of this rank. Errors: as above.
    [[nodiscard]] std::vector<kept_type> keep_levels(sharing how)
    {
        std::vector<kept_type> result;
        refine_levels(how, [&](kept_type&& kept) { result.push_back(std::move(kept)); });
        return result;
    }

private:
    static std::vector<numbered_tile<tile_type>> parts_of(std::vector<kept_type>& tiles)
    {
        std::vector<numbered_tile<tile_type>> result;
        for (auto& kept : tiles)
            result.push_back({kept.number, std::move(kept.part)});
        return result;
    }

    static constexpr const char* no_memory = "there is not enough memory for a tile; use more tiles or fewer levels";

    template <class Use>
    void refine_dealt(const std::vector<std::uint64_t>& numbers, const Use& use, work_done& done)
    {
        auto mine = deal_tiles(comm_, numbers.size(), [&](std::uint64_t t) { return cut(numbers[t]); });
        refine_here(mine.size(), [&](std::size_t i) {
            refine_one(numbers[std::size_t(comm_.rank()) + i * std::size_t(comm_.size())],
                       unpack<Point, Index>(std::exchange(mine[i], {}), scheme_),
                       use,
                       done);
        });
    }
    template <class Use>
    void refine_held(const std::vector<std::uint64_t>& numbers, const Use& use, work_done& done)
    {
        refine_here(held_->size(), [&](std::size_t i) {
            auto& [number, part] = (*held_)[i];
            if (std::ranges::find(numbers, number) == numbers.end())
                return;
            is_taken_[i] = 1;
            auto mine = held_schemes_.empty() ? kith::detail::scheme_of_tile(scheme_, part)
                                              : std::move(held_schemes_[i]);
            refine_one(number, {std::move(part), std::move(mine)}, use, done);
        });
    }
    std::vector<std::byte> cut(std::uint64_t number)
    {
        const phase_timer timer(seconds_[phase::cut]);
        return pack(cutter_->cut(number, whole_->rings(0)));
    }
    /// Refines the tiles of this rank, which speaks to no other meanwhile.
    template <class Refine>
    void refine_here(std::size_t tiles, const Refine& refine_tile)
    {
        MPI_Pcontrol(1); // for profilers: from here to the next there is nothing to see
        const std::string problem = problem_of(
            [&] {
                at_once_ = tiles_at_once(tiles, most_at_once_);
                for_each_at_once(tiles, at_once_, refine_tile);
            },
            no_memory);
        MPI_Pcontrol(0);
        comm_.agree(problem);
    }

    template <class Use>
    void refine_handed_out(const std::vector<std::uint64_t>& numbers, const Use& use, work_done& done)
    {
        const auto by_size = [&] { // the largest first
            auto order = numbers;
            std::ranges::stable_sort(order, std::greater(), [&](auto t) { return cutter_->faces(t).size(); });
            return order;
        };
        const auto refine_some = [&](const std::vector<packed_tile>& tiles) {
            at_once_ = tiles_at_once(tiles.size(), most_at_once_);
            for_each_at_once(tiles.size(), at_once_, [&](std::size_t i) {
                refine_one(tiles[i].first, unpack<Point, Index>(tiles[i].second, scheme_), use, done);
            });
        };
        in_agreement(comm_, [&] {
            if (comm_.is_root())
                hand_out_tiles(comm_, by_size(), [&](std::uint64_t t) { return cut(t); });
            else
                ask_for_tiles(comm_, tiles_at_once(SIZE_MAX, most_at_once_), no_memory, refine_some);
        });
    }

    template <class Use>
    void refine_one(std::uint64_t number, tile_job<tile_type, Scheme> job, const Use& use, work_done& done)
    {
        const work_done more = refine_counted(number, std::move(job), *whole_, last_, use, at_once_);
        const std::lock_guard lock(adding_);
        done += more;
    }

    communicator& comm_;
    Scheme scheme_;
    connect last_;
    std::optional<tile_cutter<Point, Index, Scheme>> cutter_; // on rank 0
    std::optional<std::vector<numbered_tile<tile_type>>> held_;
    std::vector<unsigned char> is_taken_; // of each of these
    std::vector<Scheme> held_schemes_;    // of the tiles that lay on their ranks, where they had one each
    control_runs runs_;                   // of tiles that lay on their ranks
    std::optional<whole_levels<Scheme>> whole_;
    std::uint64_t tiles_ = 0;
    std::size_t most_at_once_ = 1, at_once_ = 1;
    phase_seconds seconds_; // to cut
    std::mutex adding_;     // what threads have done
};

} // namespace kith::mpi
