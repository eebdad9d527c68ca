// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.hpp"
#include "errors.hpp"
#include "json.hpp"
#include "partition_options.hpp"
#include "scheme_options.hpp"
#include "terminal.hpp"
#include "job/back_end.hpp"
#include "job/holes.hpp"
#include "job/job_memory.hpp"
#include "job/limit_surface.hpp"
#include "job/mesh_input.hpp"
#include "job/plan_ranks.hpp"

#include <kith/core/level/to_native.hpp>
#include <kith/plan.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iomanip>
#include <iostream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace kith::tool {

namespace {

namespace po = boost::program_options;

/// The levels and bytes that one refinement needs, besides the program itself.
struct planned_job {
    std::vector<planned_level> levels;
    std::uint64_t bytes = 0;
    std::string why; ///< a sentence on how the last level is made; empty if not asked for
};

/// A column of a table: its heading, which may begin with blanks, and its entries.
struct table_column {
    std::string heading;
    std::vector<std::uint64_t> entries{};

    /// Returns the width of the column in characters. At least two blanks stand before the longest entry.
    [[nodiscard]] std::size_t width() const
    {
        std::size_t result = heading.size();
        for (const std::uint64_t entry : entries)
            result = std::max(result, std::to_string(entry).size() + 2);
        return result;
    }
};

/// Prints columns of the same length, aligned to the right.
void print_columns(const std::vector<table_column>& columns)
{
    const auto print_row = [&](const auto& text_of) {
        for (const table_column& column : columns)
            std::cout << std::setw(int(column.width())) << text_of(column);
        std::cout << '\n';
    };
    print_row([](const table_column& column) { return column.heading; });
    for (std::size_t row = 0; row < columns.front().entries.size(); ++row)
        print_row([&](const table_column& column) { return std::to_string(column.entries[row]); });
}

void print_table(const planned_job& job)
{
    const auto& levels = job.levels;
    std::vector<table_column> columns{
        {"level"}, {"        vertices"}, {"           edges"}, {"           faces"}, {"           bytes"}};
    for (std::size_t level = 0; level < levels.size(); ++level) {
        const auto& [counts, bytes, least_bytes] = levels[level];
        const std::array<std::uint64_t, 5> row{level, counts.vertices, counts.edges, counts.faces, bytes};
        for (std::size_t i = 0; i < row.size(); ++i)
            columns[i].entries.push_back(row[i]);
    }
    print_columns(columns);
    std::cout << "refining needs " << job.bytes << " bytes at once; keeping all levels needs "
              << peak_bytes(levels, true) << '\n';
    if (not job.why.empty())
        std::cout << job.why << '\n';
}

void print_json(const planned_job& job)
{
    const auto& levels = job.levels;
    auto objects = json::array();
    for (const auto& [counts, bytes, least_bytes] : levels)
        objects.push_back(
            {{"vertices", counts.vertices}, {"edges", counts.edges}, {"faces", counts.faces}, {"bytes", bytes}});
    json result{{"levels", objects}, {"bytes_at_once", job.bytes}, {"bytes_of_all_levels", peak_bytes(levels, true)}};
    if (not job.why.empty())
        result["why"] = job.why;
    std::cout << text_of(result) << '\n';
}

void print_table(const planned_ranks& plan)
{
    std::cout << "rings of ghosts on level 0: " << plan.rings << '\n';
    std::vector<table_column> columns{{" rank"},
                                      {"  tiles"},
                                      {"     faces"},
                                      {"    ghosts"},
                                      {"  message bytes"},
                                      {"      last faces"},
                                      {"     tile bytes"},
                                      {"    output bytes"}};
    for (std::size_t rank = 0; rank < plan.ranks.size(); ++rank) {
        const planned_rank& r = plan.ranks[rank];
        const std::array<std::uint64_t, 8> row{
            rank, r.tiles, r.faces, r.ghosts, r.message_bytes, r.last_faces, r.tile_bytes, r.output_bytes};
        for (std::size_t i = 0; i < row.size(); ++i)
            columns[i].entries.push_back(row[i]);
    }
    print_columns(columns);
    std::cout << "refining the largest tile needs " << plan.largest_tile_bytes << " bytes at once\n";
}

void print_json(const planned_ranks& plan)
{
    auto objects = json::array();
    for (const planned_rank& r : plan.ranks)
        objects.push_back({{"tiles", r.tiles},
                           {"faces", r.faces},
                           {"ghosts", r.ghosts},
                           {"message_bytes", r.message_bytes},
                           {"last_faces", r.last_faces},
                           {"tile_bytes", r.tile_bytes},
                           {"output_bytes", r.output_bytes}});
    std::cout << text_of({{"rings", plan.rings}, {"bytes_at_once", plan.largest_tile_bytes}, {"ranks", objects}})
              << '\n';
}

void print_ranks(const po::variables_map& values, const tile_request& request)
{
    const std::uint64_t ranks = count_from(values, "ranks", most_ranks);
    const std::uint64_t per_rank = values.count("tiles-per-rank") != 0
                                       ? count_from(values, "tiles-per-rank", most_tiles_per_rank)
                                       : usual_tiles_per_rank(request, ranks);
    const partition parts = shown("partitioning", {}, [&] {
        return make_partition(partitioner_from(values), request.control, ranks * per_rank);
    });
    const planned_ranks plan = shown("planning ranks", {}, [&] { return plan_ranks(request, parts, ranks); });
    if (values.count("json") != 0)
        print_json(plan);
    else
        print_table(plan);
}

} // namespace

int run_plan(const verb& verb, const std::vector<std::string>& arguments)
{
    po::options_description options("Options");
    add_scheme_options(options);
    add_repair_options(options);
    add_option<std::string>(options, "mesh", "MESH", "predict the memory for this kind of mesh: " + mesh_kind_names());
    add_flag(options, "limit", "include the memory for --limit of `kith refine`");
    add_option<std::int64_t>(options, "ranks", "N", "predict the work of each of N ranks of kith-mpi instead");
    add_option<std::int64_t>(options, "tiles-per-rank", "K", "with --ranks: K tiles per rank");
    add_option<std::string>(options, "partitioner", "P", "how to cut tiles: metis, block or file:PATH");
    add_flag(options, "why", "tell how `kith refine` would make the last level, and why");
    add_flag(options, "json", "print JSON");
    const auto values = parse(verb, options, {"IN"}, arguments);
    if (not values)
        return 0;
    const int levels = levels_of(*values);
    scheme_words words = scheme_words_of(*values);
    any_scheme scheme = make_scheme(required(*values, "scheme"), words);
    for (const char* option : {"tiles-per-rank", "partitioner"})
        if (values->count(option) != 0 and values->count("ranks") == 0)
            throw usage_error("--" + std::string(option) + ": needs --ranks; name the number of ranks as well");
    if (values->count("mesh") != 0 and values->count("ranks") != 0)
        throw usage_error(
            "--mesh and --ranks do not go together, since ranks refine native tiles; leave one of them out");
    const bool tells_why = values->count("why") != 0;
    if (tells_why and values->count("ranks") != 0)
        throw usage_error("--why: tells of one process; leave --ranks out");
    control_mesh input = read_mesh(required(*values, "IN"), input_repair_from(*values));
    give_creases(scheme, input, words);
    const bool limit = values->count("limit") != 0;
    if (values->count("ranks") != 0) {
        tile_request request{.scheme = scheme, .levels = levels, .output = "out.vtu", .limit = limit};
        take_control(request, input);
        print_ranks(*values, request);
        return 0;
    }
    const bool has_holes = not holes_of(input.tags, input.mesh).empty();
    attribute_fields attributes(input.attributes, input.mesh);
    const basic_mesh<> control = prepared(scheme, std::move(input.mesh), attributes);
    require_scheme_takes(scheme, control);
    const auto fits = [&](const auto& s) {
        return plan_what_fits(count(control.topology()), s, levels, control.generation());
    };
    const partial_plan planned = std::visit(fits, scheme);
    const job_kind kind{.mesh = mesh_kind_from(*values),
                        .limit = limit,
                        .corner_normals = limit and has_sides(scheme),
                        .holes = has_holes,
                        .attributes = count_of(input.attributes)};
    planned_job job{planned.levels, job_bytes(planned.levels, kind, is_reordered(scheme, control, levels)), {}};
    if (tells_why and planned.problem.empty()) {
        const refine_request request{
            .scheme = scheme, .levels = levels, .memory = {}, .limit = limit, .attributes = std::move(attributes)};
        job.why = explain(strategy_of(kind.mesh, control, request));
    }
    if (values->count("json") != 0)
        print_json(job);
    else
        print_table(job);
    if (not planned.problem.empty())
        throw mesh_error(required(*values, "scheme") + ": " + planned.problem + "; refine at most " +
                         std::to_string(planned.levels.size() - 1) +
                         " times, or refine in tiles with `kith refine --tiles`");
    return 0;
}

} // namespace kith::tool
