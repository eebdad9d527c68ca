// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_input.hpp"

#include "cli/errors.hpp"
#include "cli/terminal.hpp"
#include "cli/word_list.hpp"

#include <kith/attributes_of.hpp>
#include <kith/io/text/counted.hpp>
#include <kith/read_mesh.hpp>

#include <algorithm>
#include <iostream>
#include <set>
#include <utility>

namespace kith::tool {

namespace {

/// Returns the ends of all edges, the smaller number first.
std::set<std::pair<std::size_t, std::size_t>> edges_of(const polygon_soup& soup)
{
    const auto& faces = soup.faces;
    std::set<std::pair<std::size_t, std::size_t>> result;
    for (std::size_t f = 0; f < faces.size(); ++f)
        for (std::size_t i = faces.first[f], end = faces.first[f + 1]; i < end; ++i)
            result.insert(std::minmax(faces.vertices[i], faces.vertices[i + 1 == end ? faces.first[f] : i + 1]));
    return result;
}

/// Removes the vertices without a face, renumbers the others, and returns the points of the removed vertices.
std::vector<std::array<double, 3>> take_isolated(polygon_soup& soup)
{
    const std::vector<bool> used = vertices_with_faces(soup);
    std::vector<std::array<double, 3>> isolated;
    std::vector<std::size_t> number(used.size());
    std::size_t kept = 0;
    for (std::size_t v = 0; v < used.size(); ++v) {
        number[v] = kept;
        if (used[v])
            soup.points[kept++] = soup.points[v];
        else
            isolated.push_back(soup.points[v]);
    }
    if (isolated.empty())
        return isolated;
    soup.points.resize(kept);
    for (io::attribute& a : soup.attributes.vertices) {
        std::vector<double> values(used.size());
        std::size_t next_isolated = kept;
        for (std::size_t v = 0; v < used.size(); ++v)
            values[used[v] ? number[v] : next_isolated++] = a.values[v];
        a.values = std::move(values);
    }
    const auto edges = soup.tags.edges.empty() ? std::set<std::pair<std::size_t, std::size_t>>() : edges_of(soup);
    for (std::size_t& v : soup.faces.vertices)
        v = number[v];
    for (auto& [from, to, sharpness] : soup.tags.edges) {
        if (not edges.contains(std::minmax(from, to)))
            throw mesh_error("crease " + std::to_string(from) + "-" + std::to_string(to) +
                             ": there is no such edge; correct the tag");
        from = number[from];
        to = number[to];
    }
    for (const auto& [vertex, sharpness] : soup.tags.vertices)
        if (vertex >= used.size())
            throw mesh_error("corner " + std::to_string(vertex) + ": there is no such vertex; correct the tag");
    std::erase_if(soup.tags.vertices, [&](const auto& corner) { return not used[corner.first]; });
    for (auto& [vertex, sharpness] : soup.tags.vertices)
        vertex = number[vertex];
    return isolated;
}

} // namespace

io::polygon_soup read_soup(const std::string& path)
{
    polygon_soup soup = shown("reading", share_of_file, [&] { return read_mesh_file(path); });
    for (const auto& note : soup.notes)
        std::cerr << "kith: note: " << path << ": " << note << '\n';
    return soup;
}

io::polygon_soup read_soup(const std::string& path, const input_repair& repair)
{
    polygon_soup soup = read_soup(path);
    if (repair.empty())
        return soup;
    repair_report report;
    std::vector<std::string> notes;
    try {
        soup = repaired_soup(soup, repair, report, notes);
    } catch (const mesh_error& error) {
        throw file_error(path + ":\n" + error.what());
    }
    for (const auto& lines : {report.lines(), notes})
        for (const auto& line : lines)
            std::cerr << "kith: note: " << path << ": " << line << '\n';
    return soup;
}

std::vector<bool> vertices_with_faces(const io::polygon_soup& soup)
{
    std::vector<bool> result(soup.points.size());
    for (const std::size_t v : soup.faces.vertices)
        result[v] = true;
    return result;
}

control_mesh control_mesh_of(const io::polygon_soup& soup)
{
    const auto control =
        [&](const polygon_soup& with_faces, std::vector<std::array<double, 3>> isolated, std::size_t first_number) {
            control_mesh result{make_mesh(with_faces.points, with_faces.faces, first_number)};
            result.tags = with_faces.tags;
            result.isolated = std::move(isolated);
            result.not_kept = soup.not_kept;
            result.attributes = attributes_of(with_faces, result.mesh);
            if (take_odd_generation(result.attributes))
                result.mesh = {storage<std::array<double, 3>>(result.mesh.points()), result.mesh.topology(), 1};
            return result;
        };
    if (const auto used = vertices_with_faces(soup); std::ranges::find(used, false) == used.end())
        return control(soup, {}, soup.first_number);
    polygon_soup with_faces = soup;
    auto isolated = take_isolated(with_faces);
    report_of(soup).require_ok(); // in the numbers of the file
    return control(with_faces, std::move(isolated), 0);
}

control_mesh read_mesh(const std::string& path, const input_repair& repair)
{
    const polygon_soup soup = read_soup(path, repair);
    try {
        return shown("joining faces", {}, [&] { return control_mesh_of(soup); });
    } catch (const mesh_error& error) {
        std::string text = path + (repair.empty() ? ":\n" : ", numbered as after the repair:\n") + error.what();
        for (const auto& remedy : remedies(soup, report_of(soup)))
            text += "\n" + remedy;
        throw file_error(text);
    }
}

mesh_report report_of(const io::polygon_soup& soup)
{
    mesh_report report = validate(soup.points, soup.faces, soup.first_number);
    using enum problem;
    for (const auto kind :
         {empty_mesh, not_finite, bad_index, degenerate_face, nonmanifold_edge, turned_face, nonmanifold_vertex})
        if (report.has(kind))
            return report;
    return {};
}

void note_losses(const std::string& input, const std::vector<std::string>& lost)
{
    std::string list;
    for (const auto& what : lost)
        append_to_list(list, what);
    if (not list.empty())
        std::cerr << "kith: note: " << (input == standard_stream ? "standard input" : input) << ": not kept: " << list
                  << '\n';
}

void note_zeros(const std::string& output, const std::vector<std::string>& zeros)
{
    std::string list;
    for (const auto& what : zeros)
        append_to_list(list, what);
    if (not list.empty())
        std::cerr << "kith: note: " << (output == standard_stream ? "standard output" : output)
                  << ": this format cannot mark missing values; it has 0 for: " << list << '\n';
}

void add_lost_sharpness(std::vector<std::string>& lost, std::size_t edges, std::size_t vertices)
{
    std::string of;
    if (edges != 0)
        of = counted(edges, "edge");
    if (vertices != 0)
        of += (of.empty() ? "" : " and ") + counted(vertices, "vertex");
    if (not of.empty())
        lost.push_back("the remaining sharpness of " + of + " (.obj can hold it)");
}

} // namespace kith::tool
