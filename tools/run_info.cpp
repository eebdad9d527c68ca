// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.hpp"
#include "json.hpp"
#include "mesh_facts.hpp"
#include "mesh_file.hpp"
#include "word_list.hpp"

#include <iomanip>
#include <iostream>
#include <optional>
#include <string>

namespace kith::tool {

namespace {

std::string histogram_text(const std::map<std::size_t, std::size_t>& histogram)
{
    std::string result;
    for (const auto& [value, times] : histogram)
        append_to_list(result, std::to_string(times) + " of " + std::to_string(value));
    return histogram.empty() ? "none"
                             : std::to_string(histogram.begin()->first) + " to " +
                                   std::to_string(histogram.rbegin()->first) + " (" + result + ")";
}

json_object histogram_json(const std::map<std::size_t, std::size_t>& histogram)
{
    json_object result;
    for (const auto& [value, times] : histogram)
        result.add(std::to_string(value), times);
    return result;
}

template <class Line>
void print_box(const Line& line, const mesh_facts& facts)
{
    const auto text = [](const std::array<double, 3>& p) {
        return to_json(p[0]) + " " + to_json(p[1]) + " " + to_json(p[2]);
    };
    if (facts.box)
        line("bounding box", text(facts.box->first) + " to " + text(facts.box->second));
}

void print_text(const std::string& path, const mesh_facts& facts, const mesh_report& report)
{
    const auto line = [](std::string_view name, const auto& value) {
        std::cout << std::left << std::setw(22) << name << value << '\n';
    };
    line("file", path);
    line("vertices", facts.vertices);
    line("edges", facts.edges);
    line("faces", facts.faces);
    line("components", facts.components);
    if (facts.boundary_loops)
        line("boundary loops", *facts.boundary_loops);
    line("Euler characteristic", facts.euler_characteristic);
    line("valences", histogram_text(facts.valences));
    line("face degrees", histogram_text(facts.degrees));
    print_box(line, facts);
    const auto problems = report.lines();
    line("problems", problems.empty() ? "none" : "found");
    for (const auto& problem : problems)
        std::cout << "  " << problem << '\n';
}

void print_json(const std::string& path, const mesh_facts& facts, const mesh_report& report)
{
    json_object result;
    result.add("file", path)
        .add("vertices", facts.vertices)
        .add("edges", facts.edges)
        .add("faces", facts.faces)
        .add("components", facts.components)
        .add_json("boundary_loops", facts.boundary_loops ? to_json(*facts.boundary_loops) : "null")
        .add("euler_characteristic", facts.euler_characteristic)
        .add("valences", histogram_json(facts.valences))
        .add("face_degrees", histogram_json(facts.degrees));
    if (facts.box)
        result.add_json("bounding_box", "[" + to_json(facts.box->first) + "," + to_json(facts.box->second) + "]");
    result.add("problems", report.lines());
    std::cout << result.text() << '\n';
}

} // namespace

int run_info(const verb& verb, const std::vector<std::string>& arguments)
{
    boost::program_options::options_description options("Options");
    add_flag(options, "json", "print JSON");
    const auto values = parse(verb, options, {"FILE"}, arguments);
    if (not values)
        return 0;
    const std::string path = required(*values, "FILE");
    const polygon_soup soup = read_mesh_file(path);
    const mesh_report report = validate(soup.points, soup.faces);
    const mesh_facts facts = facts_of(soup, report);
    if (values->count("json") != 0)
        print_json(path, facts, report);
    else
        print_text(path, facts, report);
    return report.ok() ? 0 : 1;
}

} // namespace kith::tool
