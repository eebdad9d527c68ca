// SPDX-License-Identifier: BSD-3-Clause
#include "run_refine_tiles.hpp"

#include "errors.hpp"
#include "json.hpp"
#include "partition_options.hpp"
#include "run_stats.hpp"
#include "tile_options.hpp"
#include "job/job_memory.hpp"
#include "job/journal.hpp"
#include "job/refine_tiles.hpp"

#include <kith/io/format/mesh_format.hpp>
#include <kith/tiles/part/tiles_at_once.hpp>

#include <cstdint>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

namespace kith::tool {

namespace {

namespace po = boost::program_options;

std::string result_line(const tile_request& request, const tiling& how, const tiled_result& result, bool as_json,
                        bool with_seconds)
{
    const bool is_complete = result.finished_tiles == result.tiles;
    const auto& [counts, tiles, finished_tiles, checksum, seconds] = result;
    std::ostringstream out;
    if (as_json) {
        json object{{"scheme", request.scheme_name},
                    {"tiles", tiles},
                    {"finished_tiles", finished_tiles},
                    {"levels", request.levels},
                    {"vertices", counts.vertices},
                    {"edges", counts.edges},
                    {"faces", counts.faces},
                    {"output", is_complete ? request.output : how.journal}};
        if (is_complete and checksum) {
            std::ostringstream digits;
            digits << std::hex << checksum->bits;
            object["checksum"] = digits.str();
        }
        if (how.verify)
            object["verified"] = true;
        if (with_seconds)
            object["seconds"] = json_of(seconds);
        out << text_of(object);
    } else if (is_complete) {
        out << request.output << ": " << counts.vertices << " vertices, " << counts.edges << " edges, " << counts.faces
            << " faces";
        if (checksum)
            out << ", checksum " << std::hex << checksum->bits;
    } else {
        out << how.journal << ": " << finished_tiles << " of " << tiles << " tiles are finished";
    }
    if (how.verify and not as_json)
        out << ", verified";
    return out.str();
}

/// Returns a partition into the usual number of tiles, or into more if the memory limit requires it.
partition usual_partition(const tile_request& request, const std::string& partitioner, const memory_limit& memory)
{
    partition parts = make_partition(partitioner, request.control, usual_tiles_per_rank(request));
    const auto kind = tiling_of(request, tiles_at_once(SIZE_MAX));
    if (tiled_job_bytes(request.scheme, request.control, request.levels, parts, kind) <= memory.bytes)
        return parts;
    const std::uint64_t more = tiles_that_fit(
        request.scheme, request.control, request.levels, partitioner, memory.bytes, kind);
    return more > parts.parts ? make_partition(partitioner, request.control, more) : parts;
}

} // namespace

bool is_tile_format_only(const po::variables_map& values)
{
    if (values.count("output") == 0)
        return false;
    const std::string extension = extension_of(values["output"].as<std::string>());
    return extension == ".vtu" or extension == ".pvtu";
}

int run_refine_tiles(const po::variables_map& values)
{
    if (values.count("mesh") != 0)
        throw usage_error(
            "--mesh and tiles do not go together; " +
            (values.count("tiles") != 0 or not is_tile_format_only(values)
                 ? "leave one of them out"
                 : required(values, "output") +
                       " is written in tiles, so leave out the option or write .off, .obj, .ply or .stl"));
    tiling how{.journal = journal_from(values), .only = {}, .make_parts = {}};
    if (values.count("only") != 0)
        how.only = tile_range_from(required(values, "only"));
    if (how.only and how.journal.empty())
        throw usage_error("--only: needs --journal; name the directory of the tiles as well");
    how.verify = values.count("verify") != 0;
    how.with_checksum = values.count("checksum") != 0;
    tile_request request;
    std::optional<std::uint64_t> tiles;
    std::string partitioner = "metis";
    double reading = 0;
    if (names_input(values, {"only", "threads", "json", "memory-limit", "stats", "verify", "checksum"})) {
        request = tile_request_from(values);
        if (values.count("tiles") != 0)
            tiles = count_from(values, "tiles");
        partitioner = partitioner_from(values);
        require_reach(request);
        timed(reading, [&] { read_control(request, required(values, "IN")); });
    } else {
        const phase_timer timer(reading);
        how.kept = kept_recipe(how.journal);
        request = request_with_control(*how.kept);
    }
    if (values.count("tiles") != 0 and extension_of(request.output) == ".ply" and values.count("binary") == 0)
        std::cerr << "kith: note: " << request.output
                  << " is binary, since tiles are written at fixed byte positions\n";
    how.partitioner = partitioner;
    how.memory = memory_limit_from(values);
    how.make_parts = [&] {
        return tiles ? make_partition(partitioner, request.control, *tiles)
                     : usual_partition(request, partitioner, how.memory);
    };
    tiled_result result = refine_tiles(request, how);
    result.seconds[phase::read] += reading;
    const bool with_seconds = values.count("stats") != 0;
    if (with_seconds)
        write_stats(required(values, "stats"), result.seconds);
    const bool is_complete = result.finished_tiles == result.tiles;
    print_result(std::cout,
                 result_line(request, how, result, values.count("json") != 0, with_seconds),
                 is_complete ? request.output : "the finished part of " + how.journal);
    return 0;
}

} // namespace kith::tool
