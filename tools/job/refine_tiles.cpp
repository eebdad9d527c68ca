// SPDX-License-Identifier: BSD-3-Clause
#include "refine_tiles.hpp"

#include "available_memory.hpp"
#include "limit_surface.hpp"
#include "tile_attributes.hpp"
#include "tile_output.hpp"
#include "cli/errors.hpp"
#include "cli/terminal.hpp"

#include <kith/fields/with_fields.hpp>
#include <kith/refine_in_tiles.hpp>
#include <kith/tiles/number/largest_degree.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <iostream>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <unistd.h>

namespace kith::tool {

namespace {

/// The sums over finished tiles, to which the threads that refine tiles add.
struct sums {
    std::mutex mutex;
    std::uint64_t tiles = 0, faces = 0;
    mesh_checksum checksum{};
    phase_seconds seconds;

    std::uint64_t count()
    {
        const std::lock_guard lock(mutex);
        return tiles;
    }
    void add(const finished_tile& tile, const phase_seconds& spent, std::size_t threads)
    {
        const std::lock_guard lock(mutex);
        ++tiles;
        faces += tile.faces;
        checksum += tile.checksum;
        seconds.add(spent, threads);
    }
};

/// Refines and writes a missing tile, or checks a finished one. Returns its record.
template <class Refinement>
finished_tile finish(Refinement& refinement, const tile_request& request, tile_output& file, std::size_t number,
                     bool is_finished, phase_seconds& spent)
{
    if (not is_finished)
        if (const auto meanwhile = file.finished(number)) // by another job
            return *meanwhile;
    const global_counts counts = refinement.whole().counts(request.levels);
    const auto bytes_of_level = double(24 * counts.vertices + 8 * counts.edges); // shown where it is the only tile
    auto job = shown("refining", share_of_memory(bytes_of_level), [&] {
        auto result = refinement.refine_job(number, last_rings(request) ? connect::everything : connect::faces, spent);
        if (request.limit)
            timed(spent[phase::refine],
                  [&] { move_to_limit(result.part, result.scheme.plain(), has_corner_normals(request)); });
        return result;
    });
    auto& part = job.part;
    const auto values = timed(spent[phase::refine],
                              [&] { return tile_attributes(request).values_of(job.scheme.field()); });
    const phase_timer timer(spent[phase::write]);
    const shown_phase writing("writing", share_of_output(double(file.size())));
    if (is_finished) {
        const auto damage = file.damage(part, values, number);
        if (not damage)
            return *file.finished(number);
        std::cerr << "kith: note: tile " + std::to_string(number) + " is damaged, " + *damage +
                         " is wrong; the tile is written again\n";
    }
    return file.write(part, values, {std::uint32_t(number), 0});
}

template <class Scheme>
tiled_result refine_by(const Scheme& scheme, const tile_request& request, const tiling& how, const found_recipe& kept,
                       const tile_range& range)
{
    sums done;
    auto made = [&] {
        const phase_timer timer(done.seconds[phase::cut]);
        const shown_phase cutting("cutting tiles");
        return std::make_unique<tiled_refinement<std::array<double, 3>, std::uint32_t, Scheme>>(
            request.control, scheme, request.levels, kept.value.parts, last_rings(request).value_or(0));
    }();
    auto& refinement = *made;
    const bool with_checksum = how.with_checksum or how.verify;
    tiled_result result{refinement.whole().counts(request.levels), refinement.tiles(), 0, std::nullopt, {}};
    output_request output = output_of(request);
    output.journal = how.journal;
    output.with_checksum = with_checksum;
    output.verify = how.verify;
    tile_output file(output,
                     {.counts = result.counts,
                      .largest_degree = largest_degree(request.control, scheme, request.levels),
                      .tiles = result.tiles,
                      .recipe = how.journal.empty() ? 0 : checksum_of(kept.value),
                      .process = std::uint64_t(getpid())});
    if (not file.begin(kept)) { // another job has given it its name
        result.finished_tiles = result.tiles;
        return result;
    }
    const auto finished = file.finished();
    std::vector<std::size_t> numbers;
    for (std::size_t t = 0; t < refinement.tiles(); ++t) {
        const bool is_finished = not finished.empty() and finished[t];
        if (is_finished and not how.verify)
            done.add(*finished[t], {}, 1);
        else if (is_finished or (t >= range.first and t <= range.last))
            numbers.push_back(t);
    }
    const stopwatch since;
    const double before = done.seconds.sum();
    const std::size_t at_once = tiles_at_once(numbers.size());
    std::optional<shown_phase> refining;
    if (numbers.size() > 1)
        refining.emplace("refining tiles", [&, before = std::size_t(done.tiles)] {
            return double(done.count() - before) / double(numbers.size());
        });
    for_each_at_once(numbers.size(), at_once, [&](std::size_t i) {
        phase_seconds spent;
        const bool is_finished = not finished.empty() and finished[numbers[i]];
        const auto tile = finish(refinement, request, file, numbers[i], is_finished, spent);
        done.add(tile, spent, at_once);
    });
    refining.reset();
    done.seconds[phase::wait] += std::max(0., since.seconds() - (done.seconds.sum() - before));
    result.finished_tiles = done.tiles;
    if (with_checksum or not how.journal.empty())
        result.checksum = done.checksum;
    if (result.finished_tiles == result.tiles and done.faces != result.counts.faces)
        throw std::logic_error("the tiles have " + std::to_string(done.faces) + " faces, not " +
                               std::to_string(result.counts.faces) + "; this is an error in kith");
    timed(done.seconds[phase::write], [&] {
        const bool is_complete = result.finished_tiles == result.tiles;
        const byte_sum found = is_complete ? file.sum_of_share(0, 1) : byte_sum();
        file.close();
        if (is_complete)
            file.commit(found);
    });
    result.seconds = done.seconds;
    return result;
}

} // namespace

tile_range tile_range_from(const std::string& text)
{
    tile_range range;
    const char* const end = text.data() + text.size();
    auto read = std::from_chars(text.data(), end, range.first);
    range.last = range.first;
    if (read.ec == std::errc() and std::string_view(read.ptr, end).starts_with(".."))
        read = std::from_chars(read.ptr + 2, end, range.last);
    if (read.ec != std::errc() or read.ptr != end or range.last < range.first)
        throw usage_error("--only: '" + text + "' is not a range of tiles; write e.g. 100..199 or 7");
    return range;
}

void require_reach(const tile_request& request)
{
    const auto check = []<class Scheme>(const Scheme&) {
        if constexpr (not reaching_scheme<Scheme>)
            throw usage_error(not_in_tiles(scheme_name<Scheme>(), needs_closed<Scheme>) +
                              "; leave out --tiles and write .off, .obj, .ply or .stl");
    };
    std::visit(check, request.scheme);
}

tiled_result refine_tiles(const tile_request& request, const tiling& how)
{
    require_reach(request);
    give_back_what_is_freed();
    double partitioning = 0;
    const found_recipe kept = timed(partitioning, [&] {
        const shown_phase cutting("partitioning");
        return how.journal.empty() ? found_recipe{recipe{.parts = how.make_parts()}}
               : how.kept          ? found_recipe{*how.kept, true}
                                   : recipe_for(how.journal, request, how.make_parts);
    });
    const partition& parts = kept.value.parts;
    const tile_range range = how.only.value_or(tile_range{0, parts.parts - 1});
    if (range.last >= parts.parts)
        throw usage_error("--only: tile " + std::to_string(range.last) + " does not exist, there are " +
                          std::to_string(parts.parts) + ", numbered from 0");
    const std::uint64_t wanted = how.verify ? parts.parts : range.last - range.first + 1;
    require_memory(request.scheme,
                   request.control,
                   request.levels,
                   parts,
                   how.partitioner,
                   how.memory,
                   tiling_of(request, tiles_at_once(wanted)),
                   "--tiles");
    auto result = std::visit(
        [&]<class Scheme>(const Scheme& scheme) -> tiled_result {
            if constexpr (reaching_scheme<Scheme>)
                return refine_by(with_fields(scheme, request.attributes), request, how, kept, range);
            else
                return {};
        },
        request.scheme);
    result.seconds[phase::partition] += partitioning;
    return result;
}

} // namespace kith::tool
