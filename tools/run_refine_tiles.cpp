// SPDX-License-Identifier: BSD-3-Clause
#include "run_refine_tiles.hpp"

#include "errors.hpp"
#include "journal.hpp"
#include "json.hpp"
#include "mesh_format.hpp"
#include "partition_options.hpp"
#include "refine_tiles.hpp"
#include "tile_options.hpp"

#include <cstdint>
#include <iostream>
#include <optional>
#include <string>

namespace kith::tool {

namespace {

namespace po = boost::program_options;

void print(const tile_request& request, const std::string& journal, const tiled_result& result, bool as_json)
{
    const bool is_complete = result.finished_tiles == result.tiles;
    const auto& [counts, tiles, finished_tiles, checksum] = result;
    if (as_json) {
        json_object object;
        object.add("scheme", request.scheme_name)
            .add("tiles", tiles)
            .add("finished_tiles", finished_tiles)
            .add("levels", request.levels)
            .add("vertices", counts.vertices)
            .add("edges", counts.edges)
            .add("faces", counts.faces)
            .add("output", is_complete ? request.output : journal);
        std::cout << object.text();
    } else if (is_complete) {
        std::cout << request.output << ": " << counts.vertices << " vertices, " << counts.edges << " edges, "
                  << counts.faces << " faces, checksum " << std::hex << checksum.bits << std::dec;
    } else {
        std::cout << journal << ": " << finished_tiles << " of " << tiles << " tiles are finished";
    }
    std::cout << '\n';
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
    for (const char* option : {"mesh", "limit", "memory-limit"})
        if (values.count(option) != 0)
            throw usage_error("--" + std::string(option) + " and tiles do not go together; leave one of them out");
    const std::string journal = journal_from(values);
    std::optional<tile_range> only;
    if (values.count("only") != 0)
        only = tile_range_from(required(values, "only"));
    if (only and journal.empty())
        throw usage_error("--only: name with --journal where the tiles are kept");
    tile_request request;
    std::uint64_t tiles = 1;
    std::string partitioner = "metis";
    if (names_input(values, {"only", "threads", "json"})) {
        request = tile_request_from(values);
        tiles = count_from(values, "tiles");
        partitioner = partitioner_from(values);
        require_reach(request);
        read_control(request, required(values, "IN"));
    } else {
        request = request_with_control(kept_recipe(journal));
    }
    const auto make_parts = [&] { return make_partition(partitioner, request.control, tiles); };
    const tiled_result result = refine_tiles(request, journal, only, make_parts);
    print(request, journal, result, values.count("json") != 0);
    return 0;
}

} // namespace kith::tool
