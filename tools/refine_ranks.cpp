// SPDX-License-Identifier: BSD-3-Clause
#include "refine_ranks.hpp"

#include "errors.hpp"
#include "journal.hpp"
#include "partition_options.hpp"
#include "rank_stats.hpp"
#include "tile_output.hpp"

#include <kith/refine.hpp>
#include <kith/tiles_of_slices.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <unistd.h>

namespace kith::tool {

namespace {

/// How many tiles there must be so that refining one stays within the memory of a rank: the last level twice, once with
/// what shadows add to it and once with its ids. The surface may have more elements than the 32-bit index of a tile counts,
/// which takes half of the bytes of the index that it is planned with.
template <class Scheme>
std::uint64_t tiles_for(const rank_request& request, const Scheme& scheme, const basic_mesh<>& control)
{
    const auto last = plan(count(control.topology()), scheme, request.what.levels, control.generation(), 24, 8).back();
    const double bytes_of_points = 24 * double(last.counts.vertices);
    const double bytes_of_tile = 2.5 * (bytes_of_points + (double(last.least_bytes) - bytes_of_points) / 2);
    return std::uint64_t(
        std::clamp(bytes_of_tile / double(request.memory_per_rank) + 1, 1., double(control.face_count())));
}

template <class Scheme>
partition partition_for(const rank_request& request, const Scheme& scheme, int ranks)
{
    auto tiles = request.tiles_per_rank * std::uint64_t(ranks);
    if (request.memory_per_rank != 0)
        tiles = std::max(tiles, tiles_for(request, scheme, request.what.control));
    return make_partition(request.partitioner, request.what.control, tiles);
}

/// Reads what is refined on rank 0; without IN the others hear of it from there.
void read_request(mpi::communicator& comm, rank_request& request)
{
    std::vector<std::byte> settings;
    mpi::in_agreement(comm, [&] {
        if (not comm.is_root())
            return;
        if (not request.input.empty()) {
            read_control(request.what, request.input);
            return;
        }
        recipe kept = kept_recipe(request.journal);
        request.what = request_with_control(kept);
        settings = pack_recipe({.settings = kept.settings, .output = kept.output});
    });
    if (not request.input.empty())
        return;
    settings = comm.broadcast(std::move(settings));
    mpi::in_agreement(comm, [&] {
        if (not comm.is_root())
            request.what = request_from(unpack_recipe(settings));
    });
}

/// Begins the output on rank 0, tells all ranks which tiles are missing there, and gives what is finished.
mpi::work_done begin(mpi::communicator& comm, tile_output& output, std::uint64_t tiles,
                     std::vector<std::uint64_t>& missing)
{
    mpi::work_done finished;
    mpi::in_agreement(comm, [&] {
        if (not comm.is_root())
            return;
        output.begin();
        const auto known = output.finished();
        for (std::uint64_t t = 0; t < tiles; ++t)
            if (known.empty() or not known[t])
                missing.push_back(t);
            else
                finished += {.owned_faces = known[t]->faces, .checksum = known[t]->checksum};
    });
    const auto message = comm.broadcast(packer().add_array(missing).take());
    missing = unpacker(message).get_array<std::vector<std::uint64_t>>();
    mpi::in_agreement(comm, [&] { output.open(); });
    return finished;
}

/// Collective: a number that rank 0 has, on all ranks.
std::uint64_t number_on_root(mpi::communicator& comm, std::uint64_t number)
{
    return comm.sum(std::array{comm.is_root() ? number : 0})[0];
}

/// Collective: where the journal is; rank 0 has the recipe.
std::optional<journal_place> shared_place(mpi::communicator& comm, const std::string& journal, const recipe& kept,
                                          std::uint64_t tiles)
{
    if (journal.empty())
        return std::nullopt;
    return journal_place{journal, tiles, number_on_root(comm, comm.is_root() ? checksum_of(kept) : 0)};
}

/// Refines, and writes the surface. `kept` is on rank 0.
template <class Scheme>
void write_surface(mpi::communicator& comm, const rank_request& request, const Scheme& scheme, const recipe& kept,
                   mpi::rank_refinement<std::array<double, 3>, std::uint32_t, Scheme>& refinement)
{
    const tile_request& what = request.what;
    const whole_counts counts = refinement.whole().counts(what.levels);

    const auto place = shared_place(comm, request.journal, kept, refinement.tiles());
    const std::uint64_t process = number_on_root(comm, std::uint64_t(getpid()));
    std::optional<tile_output> made;
    mpi::in_agreement(comm, [&] {
        made.emplace(what.output, counts, refinement.tiles(), what.levels, what.with_origin, place, process);
    });
    tile_output& output = *made;
    mpi::work_done done, all;
    try {
        mpi::in_agreement(comm, [&] { comm.is_root() ? begin_journal(request.journal, kept, what.output) : void(); });
        std::vector<std::uint64_t> missing;
        const mpi::work_done finished = begin(comm, output, refinement.tiles(), missing);
        done = refinement.refine(request.sharing, missing, [&](std::uint64_t number, const auto& part) {
            output.write(part, {std::uint32_t(number), std::uint32_t(comm.rank())});
        });
        mpi::in_agreement(comm, [&] { output.close(); });
        const auto sums = comm.sum(std::array{done.owned_faces, done.checksum.bits});
        all = {.owned_faces = sums[0], .checksum = {sums[1]}};
        all += finished;
        mpi::in_agreement(comm, [&] {
            if (not comm.is_root())
                return;
            if (all.owned_faces != counts.faces)
                throw std::logic_error("the tiles have " + std::to_string(all.owned_faces) + " faces, not " +
                                       std::to_string(counts.faces) + "; this is an error in kith");
            if (request.verify and
                checksum(refine(what.control, scheme, what.levels, {connect::faces})) != all.checksum)
                throw std::logic_error("the checksum differs from that of one rank; this is an error in kith");
            output.commit();
        });
    } catch (...) {
        if (comm.is_root())
            output.abandon();
        throw;
    }
    if (not request.stats.empty())
        write_stats(comm, request.stats, done);
    if (comm.is_root())
        std::cout << what.output << ": " << counts.vertices << " vertices, " << counts.edges << " edges, "
                  << counts.faces << " faces, checksum " << std::hex << all.checksum.bits << std::dec
                  << (request.verify ? ", verified" : "") << '\n';
}

template <class Scheme>
void refine_by(mpi::communicator& comm, const rank_request& request, const Scheme& scheme)
{
    recipe kept; // on rank 0
    mpi::in_agreement(comm, [&] {
        if (not comm.is_root())
            return;
        const auto make = [&] { return partition_for(request, scheme, comm.size()); };
        kept = request.journal.empty() ? recipe{.parts = make()} : recipe_for(request.journal, request.what, make);
    });
    mpi::rank_refinement refinement(comm, request.what.control, scheme, request.what.levels, kept.parts);
    write_surface(comm, request, scheme, kept, refinement);
}

template <class Scheme>
void refine_slices(mpi::communicator& comm, const rank_request& request, const Scheme& scheme)
{
    const int levels = request.what.levels;
    int rings = 1;
    mpi::in_agreement(comm, [&] { rings = std::max(rings, ring_schedule(scheme, levels)[0]); });
    auto read = mpi::read_tiles(comm, request.input, rings);
    mpi::rank_refinement refinement(comm, std::move(read.tiles), read.counts, scheme, levels);
    write_surface(comm, request, scheme, {}, refinement);
}

} // namespace

void refine_ranks(mpi::communicator& comm, rank_request& request)
{
    if (not request.slices)
        read_request(comm, request);
    std::visit(
        [&]<class Scheme>(const Scheme& scheme) {
            if constexpr (reaching_scheme<Scheme>)
                request.slices ? refine_slices(comm, request, scheme) : refine_by(comm, request, scheme);
            else
                throw usage_error(std::string(kith::scheme_name<Scheme>()) + // on all ranks
                                  " has no reach, so no tiles; use kith refine");
        },
        request.what.scheme);
}

} // namespace kith::tool
