// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.hpp"
#include "errors.hpp"
#include "holes.hpp"
#include "json.hpp"
#include "mesh_facts.hpp"
#include "mesh_input.hpp"
#include "word_list.hpp"

#include <kith/counted.hpp>
#include <kith/tags_of_creases.hpp>

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

/// What the tags of a file are about, with how much of it.
std::vector<std::pair<std::string, std::size_t>> tag_counts(const mesh_tags& tags)
{
    std::vector<std::pair<std::string, std::size_t>> result;
    const auto add = [&](const char* name, std::size_t number) {
        if (number != 0)
            result.emplace_back(name, number);
    };
    add("sharp edge", tags.edges.size());
    add("sharp vertex", tags.vertices.size());
    add("hole", tags.holes.size());
    add("boundary rule", tags.corners ? 1 : 0);
    add("crease method", tags.method ? 1 : 0);
    add("unknown tag", tags.unread.size());
    return result;
}

/// What is wrong with the mesh, or with its tags.
std::vector<std::string> problems_of(const polygon_soup& soup, const mesh_report& report)
{
    if (not report.ok() or tag_counts(soup.tags).empty())
        return report.lines();
    const control_mesh control = control_mesh_of(soup);
    try {
        (void)creases_of(control.tags, control.mesh);
        (void)holes_of(control.tags, control.mesh);
    } catch (const mesh_error& error) {
        return {error.what()};
    }
    return {};
}

void print_text(const std::string& path, const mesh_facts& facts, const polygon_soup& soup,
                const std::vector<std::string>& problems)
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
    if (facts.between_two_faces != 0)
        line("between two faces",
             std::to_string(facts.between_two_faces) + ", which dual schemes and schemes for triangles refuse");
    line("face degrees", histogram_text(facts.degrees));
    print_box(line, facts);
    if (facts.isolated != 0)
        line("isolated vertices", facts.isolated);
    std::string others, tags;
    for (const auto& what : soup.not_kept)
        append_to_list(others, what);
    for (const auto& [name, number] : tag_counts(soup.tags))
        append_to_list(tags, counted(number, name));
    if (not tags.empty())
        line("tags", tags);
    if (not others.empty())
        line("not refined", others);
    line("problems", problems.empty() ? "none" : "found");
    for (const auto& problem : problems)
        std::cout << "  " << problem << '\n';
}

void print_json(const std::string& path, const mesh_facts& facts, const polygon_soup& soup,
                const std::vector<std::string>& problems)
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
    if (facts.between_two_faces != 0)
        result.add("vertices_between_two_faces", facts.between_two_faces);
    if (facts.isolated != 0)
        result.add("isolated_vertices", facts.isolated);
    json_object tags;
    for (const auto& [name, number] : tag_counts(soup.tags))
        tags.add(name, number);
    if (not tag_counts(soup.tags).empty())
        result.add("tags", tags);
    if (not soup.not_kept.empty())
        result.add("not_refined", soup.not_kept);
    result.add("problems", problems);
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
    const polygon_soup soup = read_soup(path);
    const mesh_report report = report_of(soup);
    const mesh_facts facts = facts_of(soup, report);
    const std::vector<std::string> problems = problems_of(soup, report);
    if (values->count("json") != 0)
        print_json(path, facts, soup, problems);
    else
        print_text(path, facts, soup, problems);
    return problems.empty() ? 0 : 1;
}

} // namespace kith::tool
