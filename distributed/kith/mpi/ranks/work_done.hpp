// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/tiles/part/phase_seconds.hpp>
#include <kith/tiles/part/tile.hpp>
#include <kith/tiles/part/tiles_at_once.hpp>
#include <kith/tiles/refine/refine_tile.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <utility>

namespace kith::mpi {

/// The ways in which tiles come to ranks. `spmd`: tiles are dealt out at the beginning, the t-th to rank t modulo
/// ranks. `manager`: rank 0 hands them out, the largest first, to ranks that ask; it refines only when it is alone.
enum class sharing : unsigned char { spmd, manager };

/// The work that a rank has done.
struct work_done {
    std::uint64_t tiles = 0;
    std::uint64_t owned_faces = 0;  ///< on the last level
    std::uint64_t kept_faces = 0;   ///< on all levels that were made, including ghosts; patches skip some levels
    std::uint64_t useful_faces = 0; ///< owned faces on the same levels
    phase_seconds seconds{};        ///< to cut, refine and use tiles; to send and wait see communicator::seconds

    work_done& operator+=(const work_done& more)
    {
        tiles += more.tiles;
        owned_faces += more.owned_faces;
        kept_faces += more.kept_faces;
        useful_faces += more.useful_faces;
        seconds += more.seconds;
        return *this;
    }
};

/// Refines tile `number` of level 0 and hands it over: use(number, tile) or use(number, tile, scheme) with the last
/// level; if `use` takes a kept_tile, it gets every level. Returns the work done. Each of the `at_once` tiles that are
/// refined at the same time gets its share of the seconds. Errors and cost: those of the steps.
template <tile_like Tile, reaching_scheme Scheme, class Use>
work_done refine_counted(std::uint64_t number, tile_job<Tile, Scheme> job, const global_levels_of<Scheme>& whole,
                         connect last, const Use& use, std::size_t at_once)
{
    work_done done{.tiles = 1};
    const auto count = [&](const Tile& part) {
        done.kept_faces += part.mesh.face_count();
        done.useful_faces += owned_count(part.face_marks);
    };
    phase_seconds spent;
    if constexpr (std::invocable<const Use&, kept_tile<Tile, Scheme>>) {
        timed(spent[phase::refine], [&] {
            kith::refine_levels(number, std::move(job), whole, [&](kept_tile<Tile, Scheme> kept) {
                if (kept.level > 0)
                    count(kept.part);
                done.owned_faces = owned_count(kept.part.face_marks);
                use(std::move(kept));
            });
        });
    } else {
        timed(spent[phase::refine], [&] { kith::refine(job, whole, last, count); });
        done.owned_faces = owned_count(job.part.face_marks);
        timed(spent[phase::write], [&] {
            if constexpr (std::invocable<const Use&, std::uint64_t, Tile, const Scheme&>)
                use(number, std::move(job.part), std::as_const(job.scheme));
            else
                use(number, std::move(job.part));
        });
    }
    done.seconds.add(spent, at_once);
    return done;
}

/// A worker that refines tiles on the threads of this rank, hands them to `use` and adds up the work. Local.
template <declared_columns Columns, class Use>
class tile_worker {
public:
    /// Takes `last` and `use` as refine_counted does. `whole` and `use` must outlive this object.
    tile_worker(const global_levels<Columns>& whole, connect last, const Use& use, std::size_t most_at_once)
        : whole_(whole), last_(last), use_(use), most_at_once_(most_at_once)
    {
    }
    [[nodiscard]] std::size_t most_at_once() const { return most_at_once_; }
    [[nodiscard]] const work_done& done() const { return done_; }

    /// Refines `tiles` tiles; job(i) returns the number of the i-th one and its tile_job.
    /// Errors: those of the steps, of `job` and of `use`.
    template <std::invocable<std::size_t> Job>
    void refine(std::size_t tiles, const Job& job)
    {
        const std::size_t at_once = tiles_at_once(tiles, most_at_once_);
        for_each_at_once(tiles, at_once, [&](std::size_t i) {
            auto [number, here] = job(i);
            const work_done more = refine_counted(number, std::move(here), whole_, last_, use_, at_once);
            const std::lock_guard lock(adding_);
            done_ += more;
        });
    }

private:
    const global_levels<Columns>& whole_;
    connect last_;
    const Use& use_;
    std::size_t most_at_once_;
    work_done done_;
    std::mutex adding_;
};

} // namespace kith::mpi
