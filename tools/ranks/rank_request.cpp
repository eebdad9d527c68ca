// SPDX-License-Identifier: BSD-3-Clause
#include "rank_request.hpp"

#include "cli/errors.hpp"
#include "cli/partition_options.hpp"
#include "cli/scheme_options.hpp"
#include "cli/tile_options.hpp"

namespace kith::tool {

namespace {

namespace po = boost::program_options;

mpi::sharing sharing_named(const std::string& name)
{
    if (name == "spmd")
        return mpi::sharing::spmd;
    if (name == "manager")
        return mpi::sharing::manager;
    throw usage_error("--mode: '" + name + "' is not one of spmd, manager");
}

po::options_description options_of_rank_refine()
{
    po::options_description options("Options");
    add_scheme_options(options);
    add_uv_option(options);
    add_repair_options(options);
    add_option<std::string>(options, "output,o", "OUT", "the file to write: .vtu, .ply or .pvtu (one file per tile)");
    add_option<std::string>(
        options, "mode", "MODE", "spmd: each rank has fixed tiles; manager: rank 0 hands out tiles one by one");
    add_option<std::int64_t>(options, "tiles-per-rank", "K", "cut the mesh into K tiles per rank");
    add_option<std::string>(
        options, "memory-per-rank", "BYTES", "cut the mesh into tiles so that each rank needs at most BYTES, e.g. 2G");
    add_option<std::string>(options,
                            "partitioner",
                            "P",
                            "how to cut tiles: metis, block or file:PATH (one part per face, as METIS writes)");
    add_option<std::string>(options, "journal", "DIR", journal_help);
    add_option<std::int64_t>(options, "threads", "N", "threads per rank (default: 1)");
    add_flag(options, "limit", "write limit positions and limit normals of the vertices");
    add_flag(
        options, "cell-origin", "write the tile and rank of each cell; the file then depends on the number of ranks");
    add_flag(options, "verify", "read the output back and compare it with a refinement on one rank");
    add_flag(options, "checksum", "print a checksum of the surface, independent of tiles and ranks");
    add_flag(options,
             "slices",
             "each rank reads its share of a binary PLY file as one tile; for meshes too large for one rank");
    add_option<std::string>(
        options,
        "stats",
        "FILE",
        "write a line of JSON for the work of each rank, and a last one for the seconds of all ranks");
    return options;
}

/// Throws usage_error for options that need the whole mesh on one rank; with --slices no rank has it.
void require_slices_alone(const po::variables_map& values)
{
    for (const char* option : {"mode",
                               "tiles-per-rank",
                               "memory-per-rank",
                               "partitioner",
                               "journal",
                               "verify",
                               "crease-angle",
                               "crease-sharpness",
                               "triangulate",
                               "repair",
                               "weld"})
        if (values.count(option) != 0)
            throw usage_error("--" + std::string(option) +
                              ": needs the whole mesh on one rank; leave out this option or --slices");
}

} // namespace

std::optional<rank_request> rank_request_from(const verb& verb, const std::vector<std::string>& arguments)
{
    const auto values = parse(verb, options_of_rank_refine(), {"[IN]"}, arguments);
    if (not values)
        return std::nullopt;
    const auto text = [&](const char* option, std::string otherwise) {
        return values->count(option) != 0 ? required(*values, option) : otherwise;
    };
    rank_request request;
    request.journal = journal_from(*values);
    if (names_input(*values, {"mode", "threads", "verify", "checksum", "stats"})) {
        request.input = required(*values, "IN");
        request.what = tile_request_from(*values);
    }
    request.sharing = sharing_named(text("mode", "spmd"));
    if (values->count("tiles-per-rank") != 0)
        request.tiles_per_rank = count_from(*values, "tiles-per-rank", most_tiles_per_rank);
    request.threads = count_from(*values, "threads", most_threads);
    request.memory_per_rank = values->count("memory-per-rank") != 0 ? bytes_from(text("memory-per-rank", "")) : 0;
    request.partitioner = partitioner_from(*values);
    request.stats = text("stats", "");
    request.verify = values->count("verify") != 0;
    request.with_checksum = values->count("checksum") != 0;
    request.slices = values->count("slices") != 0;
    if (request.slices)
        require_slices_alone(*values);
    return request;
}

} // namespace kith::tool
