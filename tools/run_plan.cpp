// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.hpp"
#include "json.hpp"
#include "mesh_input.hpp"
#include "scheme_options.hpp"

#include <kith/lift.hpp>
#include <kith/plan.hpp>

#include <iomanip>
#include <iostream>
#include <variant>

namespace kith::tool {

namespace {

namespace po = boost::program_options;

void print_table(const std::vector<planned_level>& levels)
{
    std::cout << "level        vertices           edges           faces           bytes\n";
    for (std::size_t level = 0; level < levels.size(); ++level) {
        const auto& [counts, bytes, least_bytes] = levels[level];
        std::cout << std::setw(5) << level << std::setw(16) << counts.vertices << std::setw(16) << counts.edges
                  << std::setw(16) << counts.faces << std::setw(16) << bytes << '\n';
    }
    std::cout << "refining needs " << peak_bytes(levels, false, true) << " bytes at once, keeping all levels "
              << peak_bytes(levels, true) << '\n';
}

void print_json(const std::vector<planned_level>& levels)
{
    std::vector<json_object> objects;
    for (const auto& [counts, bytes, least_bytes] : levels)
        objects.push_back(json_object()
                              .add("vertices", counts.vertices)
                              .add("edges", counts.edges)
                              .add("faces", counts.faces)
                              .add("bytes", bytes));
    std::cout << json_object()
                     .add("levels", objects)
                     .add("bytes_at_once", peak_bytes(levels, false, true))
                     .add("bytes_of_all_levels", peak_bytes(levels, true))
                     .text()
              << '\n';
}

} // namespace

int run_plan(const verb& verb, const std::vector<std::string>& arguments)
{
    po::options_description options("Options");
    add_scheme_options(options);
    add_flag(options, "json", "print JSON");
    const auto values = parse(verb, options, {"IN"}, arguments);
    if (not values)
        return 0;
    const int levels = levels_of(*values);
    const any_scheme scheme = make_scheme(required(*values, "scheme"), scheme_words_of(*values));
    const basic_mesh<> control = prepared(scheme, read_mesh(required(*values, "IN")).mesh);

    const auto planned = std::visit(
        [&]<class Scheme>(const Scheme& s) {
            require_input<Scheme>(level_of<basic_mesh<>>(control));
            return plan(count(control.topology()), s, levels, control.generation());
        },
        scheme);
    if (values->count("json") != 0)
        print_json(planned);
    else
        print_table(planned);
    return 0;
}

} // namespace kith::tool
