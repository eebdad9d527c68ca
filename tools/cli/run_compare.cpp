// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.hpp"
#include "errors.hpp"
#include "json.hpp"
#include "shortest_text.hpp"
#include "terminal.hpp"
#include "compare/bitwise_compare.hpp"
#include "compare/mesh_compare.hpp"
#include "job/mesh_input.hpp"

#include <cmath>
#include <iostream>

namespace kith::tool {

namespace {

namespace po = boost::program_options;

double tolerance_of(const po::variables_map& values)
{
    if (values.count("tolerance") == 0)
        throw usage_error("--tolerance or --bitwise is missing");
    const double tolerance = values["tolerance"].as<double>();
    if (not(tolerance >= 0) or std::isinf(tolerance))
        throw usage_error(
            "--tolerance: " + (std::isfinite(tolerance) ? shortest_text(tolerance) : std::to_string(tolerance)) +
            " is not a distance; give a number of 0 or more");
    return tolerance;
}

std::string verdict(const comparison& result)
{
    if (result.equal())
        return "equal";
    if (result.unmatched_vertices != 0)
        return "different, vertices without partner: " + std::to_string(result.unmatched_vertices);
    if (result.unmatched_faces != 0)
        return "different, faces without partner: " + std::to_string(result.unmatched_faces);
    return "different, vertices that coincide are joined to other faces";
}

int compare_bitwise(const polygon_soup& a, const polygon_soup& b, bool as_json)
{
    const std::string difference = first_difference(a, b);
    if (as_json)
        std::cout << text_of({{"equal", difference.empty()}, {"difference", difference}});
    else
        std::cout << (difference.empty() ? "equal, bit for bit" : "different, " + difference);
    std::cout << '\n';
    return difference.empty() ? 0 : 1;
}

} // namespace

int run_compare(const verb& verb, const std::vector<std::string>& arguments)
{
    po::options_description options("Options");
    add_option<double>(options, "tolerance,t", "T", "treat vertices farther apart than T as different");
    add_flag(options, "bitwise", "require the same numbering and the same bits of all coordinates");
    add_flag(options, "json", "print JSON");
    const auto values = parse(verb, options, {"A", "B"}, arguments);
    if (not values)
        return 0;
    const bool bitwise = values->count("bitwise") != 0;
    if (bitwise and values->count("tolerance") != 0)
        throw usage_error("--bitwise and --tolerance do not go together; leave one of them out");
    const double tolerance = bitwise ? 0 : tolerance_of(*values);
    const polygon_soup a = read_soup(required(*values, "A"));
    const polygon_soup b = read_soup(required(*values, "B"));
    if (bitwise)
        return compare_bitwise(a, b, values->count("json") != 0);
    const comparison result = shown(
        "comparing", {}, [&] { return compare_meshes(a.points, a.faces, b.points, b.faces, tolerance); });
    if (values->count("json") != 0)
        std::cout << text_of({{"equal", result.equal()},
                              {"largest_distance", result.largest_distance},
                              {"unmatched_vertices", result.unmatched_vertices},
                              {"unmatched_faces", result.unmatched_faces},
                              {"same_faces", result.same_faces}});
    else
        std::cout << "largest distance " << shortest_text(result.largest_distance) << ", " << verdict(result);
    std::cout << '\n';
    return result.equal() ? 0 : 1;
}

} // namespace kith::tool
