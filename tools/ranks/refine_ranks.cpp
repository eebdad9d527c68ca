// SPDX-License-Identifier: BSD-3-Clause
#include "refine_ranks.hpp"

#include "rank_memory.hpp"
#include "rank_stats.hpp"
#include "slice_attributes.hpp"
#include "cli/errors.hpp"
#include "cli/partition_options.hpp"
#include "cli/run_stats.hpp"
#include "cli/terminal.hpp"
#include "job/available_memory.hpp"
#include "job/back_end.hpp"
#include "job/journal.hpp"
#include "job/limit_surface.hpp"
#include "job/mesh_input.hpp"
#include "job/tile_attributes.hpp"
#include "job/tile_output.hpp"

#include <kith/fields/with_fields.hpp>
#include <kith/mpi/slices/tiles_of_slices.hpp>
#include <kith/refine.hpp>
#include <kith/tiles/number/largest_degree.hpp>
#include <kith/tiles/part/checksum.hpp>
#include <kith/tiles/part/tiles_at_once.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <mutex>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <unistd.h>

namespace kith::tool {

namespace {

tiling_kind tiling_of(const rank_request& request)
{
    return tiling_of(request.what, tiles_at_once(SIZE_MAX, request.threads));
}

/// Returns a partition into the requested or usual number of tiles, or into more if the memory per rank requires it.
partition partition_for(const rank_request& request, int ranks)
{
    const tile_request& what = request.what;
    const std::uint64_t per_rank = request.tiles_per_rank ? *request.tiles_per_rank
                                                          : usual_tiles_per_rank(what, std::uint64_t(ranks));
    std::uint64_t tiles = per_rank * std::uint64_t(ranks);
    if (request.memory_per_rank != 0)
        tiles = std::max(tiles,
                         tiles_that_fit(what.scheme,
                                        what.control,
                                        what.levels,
                                        request.partitioner,
                                        request.memory_per_rank,
                                        tiling_of(request)));
    return make_partition(request.partitioner, what.control, tiles);
}

/// Reads the request on rank 0 and, without IN, sends it to the other ranks. Returns the recipe of a journal, on rank 0
/// only.
std::optional<recipe> read_request(mpi::communicator& comm, rank_request& request, phase_seconds& seconds)
{
    std::vector<std::byte> settings;
    std::optional<recipe> kept;
    mpi::collective_phase(comm, [&] {
        if (not comm.is_root())
            return;
        const phase_timer timer(seconds[phase::read]);
        if (not request.input.empty()) {
            read_control(request.what, request.input);
            return;
        }
        kept = kept_recipe(request.journal);
        request.what = request_with_control(*kept);
        settings = pack_recipe({.settings = kept->settings, .output = kept->output});
    });
    settings = comm.broadcast(std::move(settings));
    const auto kinds = comm.broadcast(pack_kinds(request.what.kinds));
    const auto corners = comm.broadcast(packer().add_array(request.what.words.boundary_corners).take());
    mpi::collective_phase(comm, [&] {
        if (not comm.is_root() and request.input.empty()) {
            request.what = request_from(unpack_recipe(settings));
        } else if (not comm.is_root()) { // the file may say it
            request.what.words.boundary_corners = unpacker(corners).get_array<std::string>();
            request.what.scheme = make_scheme(request.what.scheme_name, request.what.words);
        }
        request.what.kinds = unpack_kinds(kinds);
    });
    return kept;
}

/// The state of the output when the job begins, and the work that is left.
struct begun {
    bool is_over = false;                ///< true if another job has given the output its name
    std::vector<std::uint64_t> numbers;  ///< numbers of the tiles to refine
    std::vector<std::uint64_t> finished; ///< tiles among `numbers` that are finished, and only checked
    std::uint64_t faces = 0;             ///< faces of the tiles that are left out, and their checksum; on rank 0
    mesh_checksum checksum{};
};

/// Begins the output on rank 0 and sends all ranks the work that is left.
begun begin(mpi::communicator& comm, tile_output& output, std::uint64_t tiles, const found_recipe& kept, bool verify)
{
    begun result;
    mpi::collective_phase(comm, [&] {
        if (not comm.is_root())
            return;
        result.is_over = not output.begin(kept);
        if (result.is_over)
            return;
        const auto known = output.finished();
        for (std::uint64_t t = 0; t < tiles; ++t) {
            const bool is_finished = not known.empty() and known[t];
            if (is_finished and verify)
                result.finished.push_back(t);
            if (not is_finished or verify)
                result.numbers.push_back(t);
            else
                result.faces += known[t]->faces, result.checksum += known[t]->checksum;
        }
    });
    const auto message = comm.broadcast(
        packer().add(result.is_over).add_array(result.numbers).add_array(result.finished).take());
    unpacker in(message);
    result.is_over = in.get<bool>();
    result.numbers = in.get_array<std::vector<std::uint64_t>>();
    result.finished = in.get_array<std::vector<std::uint64_t>>();
    if (not result.is_over)
        mpi::collective_phase(comm, [&] { output.open(); });
    return result;
}

/// Returns the number of rank 0 on all ranks. Collective.
std::uint64_t number_on_root(mpi::communicator& comm, std::uint64_t number)
{
    return comm.sum(std::array{comm.is_root() ? number : 0})[0];
}

/// Returns the largest of the numbers of all ranks. Collective.
std::uint64_t largest_on_all(mpi::communicator& comm, std::size_t number)
{
    return std::uint64_t(comm.maximum(std::array{double(number)})[0]);
}

void print(mpi::communicator& comm, const rank_request& request, const global_counts& counts,
           const std::optional<mesh_checksum>& checksum)
{
    mpi::collective_phase(comm, [&] {
        if (not comm.is_root())
            return;
        std::ostringstream line;
        line << request.what.output << ": " << counts.vertices << " vertices, " << counts.edges << " edges, "
             << counts.faces << " faces";
        if (checksum)
            line << ", checksum " << std::hex << checksum->bits;
        if (request.verify)
            line << ", verified";
        print_result(std::cout, line.str(), request.what.output);
    });
}

template <class Scheme>
mesh_checksum checksum_on_one_rank(const tile_request& what, const Scheme& scheme)
{
    if (not what.limit)
        return checksum(refine(what.control, scheme, what.levels, {connect::faces}));
    return checksum(
        refine_native(what.control,
                      {.scheme = scheme, .levels = what.levels, .memory = {.bytes = ~std::uint64_t(0)}, .limit = true})
            .mesh);
}

/// Refines and writes the surface. `kept` is on rank 0. `largest_degree` is that of the last level, as far as this rank
/// knows the control mesh. `seconds` holds the time spent so far.
template <class Scheme>
void write_surface(mpi::communicator& comm, const rank_request& request, const Scheme& scheme, const found_recipe& kept,
                   mpi::rank_refinement<std::array<double, 3>, std::uint32_t, Scheme>& refinement,
                   std::size_t largest_degree, phase_seconds& seconds)
{
    const tile_request& what = request.what;
    const global_counts counts = refinement.whole().counts(what.levels);
    const bool with_checksum = request.with_checksum or request.verify or not request.journal.empty();

    const std::uint64_t recipe_sum = comm.is_root() and not request.journal.empty() ? checksum_of(kept.value) : 0;
    const output_surface surface{.counts = counts,
                                 .largest_degree = largest_on_all(comm, largest_degree),
                                 .tiles = refinement.tiles(),
                                 .recipe = number_on_root(comm, recipe_sum),
                                 .process = number_on_root(comm, std::uint64_t(getpid()))};
    const bool with_corner_normals = number_on_root(comm, has_corner_normals(what) ? 1 : 0) != 0; // it has the creases
    std::optional<tile_output> made;
    mpi::collective_phase(comm, [&] {
        output_request output = output_of(what);
        output.with_corner_normals = with_corner_normals;
        output.journal = request.journal;
        output.with_checksum = with_checksum;
        output.verify = request.verify;
        made.emplace(output, surface);
    });
    const memory_limit memory = memory_of_ranks(comm, request);
    mpi::collective_phase(comm, [&] {
        if (comm.is_root() and not request.slices)
            require_memory(what.scheme,
                           what.control,
                           what.levels,
                           kept.value.parts,
                           request.partitioner,
                           memory,
                           tiling_of(request),
                           "--tiles-per-rank",
                           std::uint64_t(comm.size()));
    });
    tile_output& output = *made;
    const begun job = begin(comm, output, refinement.tiles(), kept, request.verify);
    if (job.is_over) {
        print(comm, request, counts, std::nullopt);
        return;
    }
    std::mutex adding;
    mesh_checksum sum;
    std::atomic<std::size_t> tiles_here = 0;
    const auto write = [&](std::uint64_t number, auto part, const Scheme& scheme_there) {
        if (what.limit)
            move_to_limit(part, scheme_there.plain(), with_corner_normals);
        const auto values = tile_attributes(what).values_of(scheme_there.field());
        finished_tile tile;
        std::optional<std::string> damage;
        const bool is_finished = std::ranges::binary_search(job.finished, number);
        if (is_finished)
            damage = output.damage(part, values, number);
        if (damage)
            std::cerr << "kith-mpi: note: tile " + std::to_string(number) + " is damaged, " + *damage +
                             " is wrong; the tile is written again\n";
        if (is_finished and not damage)
            tile = {owned_count(part.face_marks), checksum(part)};
        else
            tile = output.write(part, values, {std::uint32_t(number), std::uint32_t(comm.rank())});
        ++tiles_here;
        const std::lock_guard lock(adding);
        sum += tile.checksum;
    };
    std::optional<shown_phase> refining; // on rank 0, as far as it has come: others do as much
    if (comm.is_root())
        refining.emplace("refining tiles",
                         [&, all = double(job.numbers.size()) / comm.size()] { return double(tiles_here) / all; });
    const mpi::work_done done = refinement.refine(request.sharing, job.numbers, write, request.threads);
    refining.reset();
    const auto sums = comm.sum(std::array{done.owned_faces, sum.bits});
    const mesh_checksum all{sums[1] + job.checksum.bits};
    seconds += done.seconds;
    byte_sum found;
    mpi::collective_phase(comm, [&] {
        const phase_timer timer(seconds[phase::write]);
        found = output.sum_of_share(std::uint64_t(comm.rank()), std::uint64_t(comm.size()));
        output.close();
    });
    found.bits = comm.sum(std::array{found.bits})[0];
    mpi::collective_phase(comm, [&] {
        if (not comm.is_root())
            return;
        if (sums[0] + job.faces != counts.faces)
            throw std::logic_error("the tiles have " + std::to_string(sums[0] + job.faces) + " faces, not " +
                                   std::to_string(counts.faces) + "; this is an error in kith");
        if (request.verify and checksum_on_one_rank(what, scheme.plain()) != all)
            throw std::logic_error("the surface differs from that of one rank; this is an error in kith");
        timed(seconds[phase::write], [&] { output.commit(found); });
    });
    for (const phase p : {phase::send, phase::wait})
        seconds[p] += comm.seconds()[p];
    if (not request.stats.empty())
        write_rank_stats(comm, request.stats, done, seconds);
    print(comm, request, counts, with_checksum ? std::optional(all) : std::nullopt);
}

template <class Scheme>
void refine_by(mpi::communicator& comm, const rank_request& request, const Scheme& scheme, std::optional<recipe> given,
               phase_seconds& seconds)
{
    found_recipe kept; // on rank 0
    mpi::collective_phase(comm, [&] {
        if (not comm.is_root())
            return;
        const phase_timer timer(seconds[phase::partition]);
        const auto make = [&] { return partition_for(request, comm.size()); };
        if (request.journal.empty())
            kept.value = {.parts = make()};
        else if (given)
            kept = {std::move(*given), true};
        else
            kept = recipe_for(request.journal, request.what, make);
    });
    mpi::rank_refinement refinement(
        comm, request.what.control, scheme, request.what.levels, kept.value.parts, last_rings(request.what));
    std::size_t degree = 0;
    mpi::collective_phase(comm, [&] {
        if (comm.is_root())
            degree = largest_degree(request.what.control, scheme, request.what.levels);
    });
    write_surface(comm, request, scheme, kept, refinement, degree, seconds);
}

template <class Scheme>
void refine_slices(mpi::communicator& comm, rank_request& request, const Scheme& scheme, phase_seconds& seconds)
{
    const tile_request& what = request.what;
    mpi::require_readable_on_all(comm, request.input);
    std::optional<slice_attributes> attributes;
    int rings = 1;
    mpi::collective_phase(comm, [&] {
        attributes.emplace(request.what, request.input);
        rings = std::max(rings, ring_schedule(scheme, what.levels, last_rings(what).value_or(0))[0]);
    });
    auto read = timed(seconds[phase::read], [&] { return mpi::read_tiles(comm, request.input, rings); });
    mpi::collective_phase(comm, [&] {
        if (comm.is_root())
            note_losses(request.input, attributes->not_kept());
    });
    using scheme_here = with_fields<Scheme, attribute_fields>;
    std::vector<kept_tile<tile<std::array<double, 3>>, scheme_here>> tiles;
    std::size_t degree = 0;
    mpi::collective_phase(comm, [&] {
        const phase_timer timer(seconds[phase::read]);
        for (auto& [number, part] : read.tiles) {
            degree = std::max(degree, largest_degree(part, scheme, what.levels));
            scheme_here here(scheme, attributes->of_tile(part));
            tiles.push_back({number, 0, std::move(part), std::move(here)});
        }
    });
    const scheme_here whole(scheme, what.attributes);
    mpi::rank_refinement refinement(comm, std::move(tiles), read.counts, whole, what.levels, last_rings(what));
    write_surface(comm, request, whole, {}, refinement, degree, seconds);
}

} // namespace

void refine_ranks(mpi::communicator& comm, rank_request& request)
{
    give_back_what_is_freed();
    phase_seconds seconds;
    std::optional<recipe> kept;
    if (not request.slices)
        kept = read_request(comm, request, seconds);
    std::visit(
        [&]<class Scheme>(const Scheme& scheme) {
            if constexpr (reaching_scheme<Scheme>)
                request.slices
                    ? refine_slices(comm, request, scheme, seconds)
                    : refine_by(comm, request, with_fields(scheme, request.what.attributes), std::move(kept), seconds);
            else
                throw usage_error(not_in_tiles(kith::scheme_name<Scheme>(), kith::needs_closed<Scheme>) +
                                  "; use kith refine"); // on all ranks
        },
        request.what.scheme);
}

} // namespace kith::tool
