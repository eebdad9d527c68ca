// SPDX-License-Identifier: BSD-3-Clause
#include "tile_options.hpp"

#include "errors.hpp"
#include "scheme_options.hpp"
#include "job/tile_output.hpp"

#include <kith/io/format/mesh_format.hpp>

#include <algorithm>

namespace kith::tool {

namespace po = boost::program_options;

std::string journal_from(const po::variables_map& values)
{
    if (values.count("journal") == 0)
        return {};
    const std::string directory = required(values, "journal");
    if (directory.empty())
        throw usage_error("--journal: name a directory");
    return directory;
}

bool names_input(const po::variables_map& values, std::initializer_list<std::string_view> beside_journal)
{
    if (values.count("IN") != 0 or values.count("journal") == 0) {
        (void)required(values, "IN");
        return true;
    }
    for (const auto& [name, value] : values)
        if (name != "journal" and std::ranges::find(beside_journal, name) == beside_journal.end())
            throw usage_error("--" + name + ": without IN, the journal sets this option; leave it out or name IN");
    return false;
}

tile_request tile_request_from(const po::variables_map& values)
{
    tile_request request;
    request.output = output_of(values);
    require_tile_format(request.output);
    request.scheme_name = required(values, "scheme");
    request.words = scheme_words_of(values);
    request.scheme = make_scheme(request.scheme_name, request.words);
    request.levels = levels_of(values);
    request.linear = linear_from(values, request.scheme);
    request.with_origin = values.count("cell-origin") != 0;
    if (request.with_origin and extension_of(request.output) == ".ply")
        throw usage_error("--cell-origin: " + request.output + " cannot hold it; write .vtu or .pvtu");
    request.limit = values.count("limit") != 0;
    request.repair = input_repair_from(values);
    return request;
}

} // namespace kith::tool
