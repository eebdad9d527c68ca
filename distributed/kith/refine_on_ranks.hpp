// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/error.hpp>
#include <kith/mpi/communicator.hpp>
#include <kith/mpi/collective_phase.hpp>
#include <kith/mpi/ranks/deal_tiles.hpp>
#include <kith/mpi/ranks/hand_out_tiles.hpp>
#include <kith/mpi/ranks/held_tiles.hpp>
#include <kith/mpi/ranks/runs_of_ranks.hpp>
#include <kith/mpi/ranks/work_done.hpp>
#include <kith/mpi/session.hpp>
#include <kith/tiles/part/partition.hpp>
#include <kith/tiles/part/phase_seconds.hpp>
#include <kith/tiles/part/require_control.hpp>
#include <kith/tiles/part/scheme_members.hpp>
#include <kith/tiles/part/tiles_at_once.hpp>
#include <kith/tiles/refine/cut_tiles.hpp>
#include <kith/tiles/refine/numbered_tile.hpp>
#include <kith/tiles/refine/pack.hpp>
#include <kith/tiles/refine/plan_tile.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace kith::mpi {

/// A control mesh that is refined in tiles on all ranks. The mesh lies on rank 0, or its tiles already lie on their
/// ranks. The refinement itself sends nothing.
template <class Point, std::unsigned_integral Index, reaching_scheme Scheme>
class rank_refinement {
public:
    using tile_type = tile<Point, Index>;
    using kept_type = kept_tile<tile_type, Scheme>;

    /// Cuts the tiles out of `mesh`. Only rank 0 reads `mesh`, `parts` and the state (creases) of `scheme`; `mesh` must
    /// outlive this object there. All ranks give the same options. With `last_rings` the last level keeps its edges and
    /// `last_rings` rings of ghosts; without it only the owned faces are kept, in half of the memory. `memory_limit` is
    /// in bytes per rank, for the tiles refined at once, without state and control mesh. Collective.
    /// Errors: phase_error for everything that `refine` refuses; for a mesh of face-vertex lists only; for a partition
    /// of another mesh; for counts beyond 64 bits; for options that differ between ranks; for a tile too large for the
    /// limit.
    rank_refinement(communicator& comm, const basic_mesh<Point, Index>& mesh, const Scheme& scheme, int levels,
                    const partition& parts, std::optional<int> last_rings = std::nullopt,
                    std::uint64_t memory_limit = no_limit)
        : rank_refinement(comm, scheme, levels, last_rings, memory_limit)
    {
        auto setting = collective_phase(comm, [&] {
            packer out;
            if (not comm.is_root())
                return out.take();
            kith::detail::require_control(mesh, scheme_, levels);
            const phase_timer timer(seconds_[phase::cut]);
            cutter_.emplace(mesh, scheme_, parts.part_of, parts.parts);
            out.add(cutter_->counts()).add(std::uint64_t(parts.parts)).add(cutter_->largest());
            out.add_array(pack(cutter_->cut_rim(ring_schedule(scheme, levels, 1)[0])));
            return out.take();
        });
        setting = comm.broadcast(std::move(setting));
        collective_phase(comm, [&] {
            unpacker in(setting);
            const auto counts = in.get<global_counts>();
            tiles_ = in.get<std::uint64_t>();
            const auto [faces, corners] = in.get<std::array<std::uint64_t, 2>>();
            auto rim = unpack<Point, Index>(in.get_array<std::vector<std::byte>>(), scheme);
            whole_.emplace(counts, std::move(rim.part), std::move(rim.scheme), levels, last_rings.value_or(0));
            memory_.emplace(*whole_, without_state(), sizeof(Point), sizeof(Index), last_rings);
            largest_ = memory_->size_of(double(faces), double(corners));
            memory_->require(largest_, 1, limit_);
        });
    }

    /// Takes tiles of level 0 that already lie on their ranks, such as those of read_tiles, with at least one ring of
    /// ghosts. Missing rings of ring_schedule(scheme, levels, last_rings)[0] are fetched. State (creases) is that of
    /// the whole mesh, as far as the tiles of this rank reach. Collective. Errors: phase_error as above; for tiles not
    /// numbered from 0 on, each once; for one without a complete ring; for missing rings of a state without add_part;
    /// and for schemes whose numbers need more than tiles know: the boundary, if the mesh has one, and marked edges
    /// (4-8).
    rank_refinement(communicator& comm, std::vector<numbered_tile<tile_type>> tiles, const global_counts& counts,
                    const Scheme& scheme, int levels, std::optional<int> last_rings = std::nullopt,
                    std::uint64_t memory_limit = no_limit)
        : rank_refinement(comm, scheme, levels, last_rings, memory_limit)
    {
        hold(std::move(tiles), counts, levels, last_rings);
    }

    /// Takes tiles as above, each with its scheme, whose state (fields, creases) has the numbers of the tile. Only the
    /// options of `scheme` are used. Collective.
    rank_refinement(communicator& comm, std::vector<kept_type> tiles, const global_counts& counts, const Scheme& scheme,
                    int levels, std::optional<int> last_rings = std::nullopt, std::uint64_t memory_limit = no_limit)
        : rank_refinement(comm, scheme, levels, last_rings, memory_limit)
    {
        hold(std::move(tiles), counts, levels, last_rings);
    }

    /// Returns the numbering of all levels. Local.
    [[nodiscard]] const global_levels_of<Scheme>& whole() const { return *whole_; }
    [[nodiscard]] std::uint64_t tiles() const { return tiles_; }

    /// Returns the ancestors and descendants over all levels, in the numbers of the whole mesh, the same on all ranks.
    /// All use of them is local, wherever tiles are moved. Collective. Errors: phase_error for lack of memory. Cost:
    /// that of runs_of_ranks (a mesh of one face degree has one run), and O(boundary) memory.
    [[nodiscard]] global_lineage<columns_type<Scheme>> lineage()
    {
        const auto runs = collective_phase(comm_, [&] {
            return held_ ? held_->runs() : cutter_ ? cutter_->runs() : control_runs();
        });
        const auto all = runs_of_ranks(comm_, runs);
        return collective_phase(comm_, [&] { return whole_->lineage(all); });
    }

    /// Refines all tiles, each on one rank, and calls `use(number, tile)` there with the last level, which `use` may
    /// move away. A third argument is the scheme for the next level, if edges are kept. Tiles that already lay on their
    /// ranks are refined there, once. A rank refines, and calls `use`, on up to `most_at_once` threads (tiles_at_once).
    /// Collective. Errors: phase_error, of the lowest rank that has one.
    template <class Use>
    work_done refine(sharing how, const Use& use, std::size_t most_at_once = 1)
    {
        const auto all = collective_phase(comm_, [&] {
            std::vector<std::uint64_t> numbers(tiles_);
            std::iota(numbers.begin(), numbers.end(), 0);
            return numbers;
        });
        return refine(how, all, use, most_at_once);
    }
    /// Refines the tiles with these numbers, which are the same on all ranks. Collective. Errors: as above, and
    /// phase_error for a number without a tile, and for a tile that lay on its rank and has been refined.
    template <class Use>
    work_done refine(sharing how, const std::vector<std::uint64_t>& numbers, const Use& use,
                     std::size_t most_at_once = 1)
    {
        require_same_tiles(comm_, numbers, std::uint64_t(how));
        collective_phase(comm_, [&] {
            for (const std::uint64_t number : numbers)
                if (number >= tiles())
                    throw mesh_error("tile " + std::to_string(number) + " does not exist; there are " +
                                     std::to_string(tiles()) + ", numbered from 0");
            if (held_)
                held_->require_there(numbers);
            memory_->require(largest_, tiles_at_once(numbers.size(), most_at_once), limit_);
        });
        tile_worker worker(*whole_, last_, use, most_at_once);
        if (held_)
            refine_held(numbers, worker);
        else if (how == sharing::spmd or comm_.size() == 1)
            refine_dealt(numbers, worker);
        else
            refine_handed_out(numbers, worker);
        work_done done = worker.done();
        done.seconds += std::exchange(seconds_, {});
        return done;
    }

    /// Refines all tiles and hands over each level, from 0 to the last, with its scheme (creases, fields):
    /// keep(kept_tile), which may move it away. All have their edges and the ghosts that later levels need. Two levels
    /// of a tile are in memory, and the levels that `keep` stores. Collective. Errors: as above, and phase_error
    /// without `last_rings`, as the last level then has no scheme.
    template <std::invocable<kept_type> Keep>
    work_done refine_levels(sharing how, const Keep& keep, std::size_t most_at_once = 1)
    {
        collective_phase(comm_, [&] {
            if (last_ != connect::everything)
                throw mesh_error("without last_rings the last level has neither edges nor a scheme, so it cannot be "
                                 "handed over; give last_rings, 0 or more, to rank_refinement");
        });
        return refine(how, keep, most_at_once);
    }
    /// Refines all tiles and returns all levels of the tiles of this rank. Collective. Errors: as above, and
    /// phase_error if the levels need more than the memory limit.
    [[nodiscard]] std::vector<kept_type> keep_levels(sharing how)
    {
        collective_phase(comm_,
                         [&] { memory_->require_levels(largest_, tiles_, std::uint64_t(comm_.size()), limit_); });
        std::vector<kept_type> result;
        refine_levels(how, [&](kept_type&& kept) { result.push_back(std::move(kept)); });
        return result;
    }

private:
    static constexpr std::uint64_t no_limit = std::numeric_limits<std::uint64_t>::max();

    rank_refinement(communicator& comm, const Scheme& scheme, int levels, std::optional<int> last_rings,
                    std::uint64_t memory_limit)
        : comm_(comm), scheme_(scheme), last_(last_rings ? connect::everything : connect::faces), limit_(memory_limit)
    {
        kith::detail::require_named_state<Scheme>();
        require_same_refinement(comm, scheme, std::uint64_t(levels), last_rings);
        collective_phase(comm, [&] { kith::detail::require_levels<Scheme>(levels); });
    }
    template <class Tiles>
    void hold(Tiles tiles, const global_counts& counts, int levels, std::optional<int> last_rings)
    {
        held_.emplace(comm_, std::move(tiles), counts, scheme_);
        tiles_ = held_->count();
        collective_phase(comm_, [&] {
            tile_type no_rim;
            no_rim.mesh = {{}, {}, held_->generation()};
            auto there = kith::detail::scheme_of_tile(scheme_, no_rim);
            whole_.emplace(counts, std::move(no_rim), std::move(there), levels, last_rings.value_or(0));
            memory_.emplace(*whole_, without_state(), sizeof(Point), sizeof(Index), last_rings);
        });
        held_->require_rings(comm_, scheme_, whole_->rings(0));
        collective_phase(comm_, [&] {
            largest_ = held_->largest();
            memory_->require(largest_, 1, limit_);
        });
    }
    [[nodiscard]] Scheme without_state() const { return kith::detail::scheme_of_part(scheme_, part_numbers<Index>()); }

    static constexpr const char* no_memory = "there is not enough memory for a tile; use more tiles or fewer levels";

    template <class Worker>
    void refine_dealt(const std::vector<std::uint64_t>& numbers, Worker& worker)
    {
        auto mine = deal_tiles(comm_, numbers.size(), [&](std::uint64_t t) { return cut(numbers[t]); });
        refine_here([&] {
            worker.refine(mine.size(), [&](std::size_t i) {
                return std::pair(numbers[std::size_t(comm_.rank()) + i * std::size_t(comm_.size())],
                                 unpack<Point, Index>(std::exchange(mine[i], {}), scheme_));
            });
        });
    }
    template <class Worker>
    void refine_held(const std::vector<std::uint64_t>& numbers, Worker& worker)
    {
        refine_here([&] {
            const auto mine = held_->among(numbers);
            worker.refine(mine.size(), [&](std::size_t i) {
                return std::pair(held_->tiles()[mine[i]].number, held_->take(mine[i], scheme_));
            });
        });
    }
    std::vector<std::byte> cut(std::uint64_t number)
    {
        const phase_timer timer(seconds_[phase::cut]);
        return pack(cutter_->cut(number, whole_->rings(0)));
    }
    /// Refines the tiles of this rank, without communication.
    template <class Refine>
    void refine_here(const Refine& refine_tiles)
    {
        MPI_Pcontrol(1); // for profilers: no communication from here to the next call
        const std::string problem = problem_of(refine_tiles, no_memory);
        MPI_Pcontrol(0);
        comm_.agree(problem);
    }
    template <class Worker>
    void refine_handed_out(const std::vector<std::uint64_t>& numbers, Worker& worker)
    {
        const auto by_size = [&] { // the largest first
            auto order = numbers;
            std::ranges::stable_sort(order, std::greater(), [&](auto t) { return cutter_->faces(t).size(); });
            return order;
        };
        const auto refine_some = [&](const std::vector<packed_tile>& tiles) {
            worker.refine(tiles.size(), [&](std::size_t i) {
                return std::pair(tiles[i].first, unpack<Point, Index>(tiles[i].second, scheme_));
            });
        };
        collective_phase(comm_, [&] {
            if (comm_.is_root())
                hand_out_tiles(comm_, by_size(), [&](std::uint64_t t) { return cut(t); });
            else
                ask_for_tiles(comm_, tiles_at_once(SIZE_MAX, worker.most_at_once()), no_memory, refine_some);
        });
    }

    communicator& comm_;
    Scheme scheme_;
    connect last_;
    std::optional<tile_cutter<Point, Index, Scheme>> cutter_; // on rank 0
    std::optional<held_tiles<tile_type, Scheme>> held_;
    std::optional<global_levels_of<Scheme>> whole_;
    std::optional<tile_memory<Scheme>> memory_;
    tile_size largest_{}; // of all tiles, or of the tiles that already lay on this rank
    std::uint64_t limit_;
    std::uint64_t tiles_ = 0;
    phase_seconds seconds_; // to cut tiles
};

// Deduces for a scheme without reach a type that refuses it in one sentence.
template <class Point, std::unsigned_integral Index, scheme Scheme, class... Rest>
rank_refinement(communicator&, const basic_mesh<Point, Index>&, const Scheme&, int, const partition&, Rest...)
    -> rank_refinement<Point, Index, kith::detail::refused_in_tiles<Scheme>>;
template <class Tiles, scheme Scheme, class... Rest>
rank_refinement(communicator&, const Tiles&, const global_counts&, const Scheme&, int, Rest...)
    -> rank_refinement<double, std::uint32_t, kith::detail::refused_in_tiles<Scheme>>;

} // namespace kith::mpi
