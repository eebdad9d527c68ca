// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.hpp"
#include "errors.hpp"
#include "json.hpp"
#include "shortest_text.hpp"
#include "terminal.hpp"
#include "word_list.hpp"
#include "info/mesh_facts.hpp"
#include "job/holes.hpp"
#include "job/mesh_input.hpp"
#include "job/schemes.hpp"

#include <kith/core/base/error.hpp>
#include <kith/io/text/counted.hpp>
#include <kith/tags_of_creases.hpp>

#include <algorithm>
#include <cstddef>
#include <iomanip>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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

json histogram_json(const std::map<std::size_t, std::size_t>& histogram)
{
    auto result = json::object();
    for (const auto& [value, times] : histogram)
        result[std::to_string(value)] = times;
    return result;
}

template <class Line>
void print_box(const Line& line, const mesh_facts& facts)
{
    const auto text = [](const std::array<double, 3>& p) {
        return shortest_text(p[0]) + " " + shortest_text(p[1]) + " " + shortest_text(p[2]);
    };
    if (facts.box)
        line("bounding box", text(facts.box->first) + " to " + text(facts.box->second));
}

/// The findings of `info` besides the facts.
struct mesh_verdict {
    std::vector<std::string> problems;     ///< reasons for which `refine` refuses the mesh, whatever the scheme
    std::vector<std::string> tags;         ///< lines such as "edge 0-1: sharpness 2"
    std::vector<std::string_view> schemes; ///< names of the schemes that take the mesh
    std::vector<std::string> attributes;   ///< kinds of attributes that are refined
    std::vector<std::string> not_refined;
    tool::cracks cracks;
    std::vector<std::string> remedies; ///< options that solve the problems
};

std::string sharpness_text(double sharpness)
{
    return sharpness == infinitely_sharp ? "infinitely sharp" : "sharpness " + shortest_text(sharpness);
}

std::vector<std::string> lines_of(const mesh_tags& tags)
{
    std::vector<std::string> result;
    for (const auto& [from, to, sharpness] : tags.edges)
        result.push_back("edge " + std::to_string(from) + "-" + std::to_string(to) + ": " + sharpness_text(sharpness));
    for (const auto& [vertex, sharpness] : tags.vertices)
        result.push_back("vertex " + std::to_string(vertex) + ": " + sharpness_text(sharpness));
    for (const std::size_t face : tags.holes)
        result.push_back("face " + std::to_string(face) + ": a hole");
    if (tags.boundary_is_hole)
        result.emplace_back("boundary: its faces are holes");
    else if (tags.corners)
        result.emplace_back(*tags.corners == boundary_corner::kept ? "boundary: its corners are kept"
                                                                   : "boundary: its corners are smoothed");
    if (tags.method)
        result.emplace_back(*tags.method == crease_method::chaikin ? "creases: by Chaikin's rule"
                                                                   : "creases: by the uniform rule");
    for (const auto& [line, name] : tags.unread)
        result.push_back("line " + std::to_string(line) + ": '" + name + "' is not understood");
    return result;
}

/// Returns the number of tags of each kind: "2 sharp edges, 1 hole".
std::string numbers_of(const mesh_tags& tags)
{
    std::string result;
    const auto add = [&](const char* name, std::size_t number) {
        if (number != 0)
            append_to_list(result, counted(number, name));
    };
    add("sharp edge", tags.edges.size());
    add("sharp vertex", tags.vertices.size());
    add("hole", tags.holes.size());
    add("boundary rule", tags.corners or tags.boundary_is_hole ? 1 : 0);
    add("crease method", tags.method ? 1 : 0);
    add("unknown tag", tags.unread.size());
    return result.empty() ? "none" : result;
}

mesh_verdict verdict_on(const polygon_soup& soup, const mesh_report& report)
{
    mesh_verdict result{report.lines(), lines_of(soup.tags), {}, topics_of(soup.attributes), soup.not_kept, {}, {}};
    if (not report.has(problem::bad_index))
        result.cracks = cracks_of(soup);
    result.remedies = remedies(soup, report);
    if (std::erase(result.attributes, "normals") != 0)
        result.not_refined.emplace_back("normals");
    if (not report.ok())
        return result;
    const auto look_at = [&](const auto& part) {
        try {
            part();
        } catch (const mesh_error& error) {
            result.problems.emplace_back(error.what());
        }
    };
    look_at([&] {
        const control_mesh control = control_mesh_of(soup);
        look_at([&] { (void)creases_of(control.tags, control.mesh); });
        look_at([&] { (void)holes_of(control.tags, control.mesh); });
        if (result.problems.empty())
            result.schemes = schemes_that_take(control);
    });
    return result;
}

void print_list(const std::vector<std::string>& lines)
{
    constexpr std::size_t most = 100;
    for (std::size_t i = 0; i < std::min(most, lines.size()); ++i)
        std::cout << "  " << lines[i] << '\n';
    if (lines.size() > most)
        std::cout << "  and " << lines.size() - most << " more, which --json lists\n";
}

/// Returns a text on coinciding vertices: "16 at the boundary coincide with others, 8 exactly, the rest within 1e-06: 8
/// at 0, ...; --weld joins them".
std::string cracks_text(const cracks& found, std::size_t first_number)
{
    constexpr std::size_t most = 4;
    const auto number = [&](std::size_t v) { return std::to_string(v + first_number); };
    const std::size_t count = found.rounded.size();
    std::string result = std::to_string(count) + " at the boundary " +
                         (count == 1 ? "coincides with another" : "coincide with others") + ", " +
                         (found.equal.size() == count
                              ? "exactly"
                              : std::to_string(found.equal.size()) + " exactly, the rest within " +
                                    shortest_text(found.distance)) +
                         ": ";
    for (std::size_t i = 0; i < std::min(most, count); ++i)
        result += (i == 0 ? "" : ", ") + number(found.rounded[i].first) + " at " + number(found.rounded[i].second);
    return result + (count > most ? ", ..." : "") + "; --weld joins them";
}

void print_text(const std::string& path, const mesh_facts& facts, const polygon_soup& soup, const mesh_verdict& found)
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
             std::to_string(facts.between_two_faces) + "; dual schemes and schemes for triangles refuse such vertices");
    line("face degrees", histogram_text(facts.degrees));
    print_box(line, facts);
    if (facts.isolated != 0)
        line("isolated vertices", facts.isolated);
    if (not found.cracks.rounded.empty())
        line("coinciding vertices", cracks_text(found.cracks, soup.first_number));
    line("tags", numbers_of(soup.tags));
    print_list(found.tags);
    std::string attributes, others, schemes;
    for (const auto& topic : found.attributes)
        append_to_list(attributes, topic);
    if (not attributes.empty())
        line("attributes", attributes);
    for (const auto& what : found.not_refined)
        append_to_list(others, what);
    if (not others.empty())
        line("not refined", others);
    for (const auto& name : found.schemes)
        append_to_list(schemes, name);
    line("refined by", schemes.empty() ? "none of the schemes" : schemes);
    line("problems", found.problems.empty() ? "none" : "found");
    for (const auto& problem : found.problems)
        std::cout << "  " << problem << '\n';
    for (const auto& remedy : found.remedies)
        std::cout << "  " << remedy << '\n';
}

void print_json(const std::string& path, const mesh_facts& facts, const mesh_verdict& found)
{
    json result{{"file", path},
                {"vertices", facts.vertices},
                {"edges", facts.edges},
                {"faces", facts.faces},
                {"components", facts.components},
                {"boundary_loops", facts.boundary_loops ? json(*facts.boundary_loops) : json()},
                {"euler_characteristic", facts.euler_characteristic},
                {"valences", histogram_json(facts.valences)},
                {"face_degrees", histogram_json(facts.degrees)}};
    if (facts.box)
        result["bounding_box"] = {facts.box->first, facts.box->second};
    if (facts.between_two_faces != 0)
        result["vertices_between_two_faces"] = facts.between_two_faces;
    if (facts.isolated != 0)
        result["isolated_vertices"] = facts.isolated;
    if (not found.cracks.rounded.empty())
        result["coinciding_vertices"] = {{"equal", found.cracks.equal.size()},
                                         {"within_distance", found.cracks.rounded.size()},
                                         {"distance", found.cracks.distance}};
    result["tags"] = found.tags;
    if (not found.attributes.empty())
        result["attributes"] = found.attributes;
    if (not found.not_refined.empty())
        result["not_refined"] = found.not_refined;
    result["schemes"] = found.schemes;
    result["problems"] = found.problems;
    std::cout << text_of(result) << '\n';
}

} // namespace

int run_info(const verb& verb, const std::vector<std::string>& arguments)
{
    boost::program_options::options_description options("Options");
    add_repair_options(options);
    add_flag(options, "json", "print JSON");
    const auto values = parse(verb, options, {"FILE"}, arguments);
    if (not values)
        return 0;
    const std::string path = required(*values, "FILE");
    const polygon_soup soup = read_soup(path, input_repair_from(*values));
    const mesh_report report = report_of(soup);
    const mesh_facts facts = shown("counting", {}, [&] { return facts_of(soup, report); });
    const mesh_verdict found = shown("trying schemes", {}, [&] { return verdict_on(soup, report); });
    if (values->count("json") != 0)
        print_json(path, facts, found);
    else
        print_text(path, facts, soup, found);
    return found.problems.empty() ? 0 : 1;
}

} // namespace kith::tool
