// SPDX-License-Identifier: BSD-3-Clause
#include "repair_input.hpp"

#include "cli/command_line.hpp"
#include "cli/errors.hpp"
#include "cli/shortest_text.hpp"
#include "cli/word_list.hpp"

#include <kith/core/base/error.hpp>
#include <kith/io/format/mesh_attributes.hpp>
#include <kith/io/text/counted.hpp>
#include <kith/repair.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <span>
#include <string_view>

namespace kith::tool {

namespace {

namespace po = boost::program_options;

using edge = std::pair<std::size_t, std::size_t>;

std::vector<double> values_at(const std::vector<double>& values, const std::vector<std::size_t>& elements)
{
    std::vector<double> result;
    result.reserve(elements.size());
    for (const std::size_t i : elements)
        result.push_back(values[i]);
    return result;
}

bool is_same(double a, double b)
{
    return a == b or (std::isnan(a) and std::isnan(b));
}

/// Moves the texture coordinates of vertices to corners, for joined vertices with different coordinates. A seam then
/// stays a seam.
void move_textures_to_corners(io::mesh_attributes& attributes, const face_list& faces)
{
    std::vector<io::attribute> kept;
    for (io::attribute& a : attributes.vertices) {
        if (std::ranges::find(io::texture_names, io::shared_name(a.name)) == std::end(io::texture_names)) {
            kept.push_back(std::move(a));
            continue;
        }
        a.name = std::string(io::shared_name(a.name));
        a.values = values_at(a.values, faces.vertices);
        attributes.corners.push_back(std::move(a));
    }
    attributes.vertices = std::move(kept);
}

/// Notes the number of joined vertices whose values are lost, since they differ from those of the vertex that stays.
void note_other_values(const io::polygon_soup& soup, const repaired<std::array<double, 3>>& mended,
                       io::mesh_attributes& attributes, std::vector<std::string>& notes)
{
    std::vector<std::size_t> stays_as(soup.points.size(), mended.none); // the old vertex whose values it gets
    for (std::size_t c = 0; c < mended.vertex_at.size(); ++c)
        if (mended.vertex_at[c] != mended.none)
            stays_as[soup.faces.vertices[c]] = mended.from_vertex[mended.vertex_at[c]];
    const auto differing = [&](const io::attribute& a) {
        std::size_t result = 0;
        for (std::size_t v = 0; v < stays_as.size(); ++v)
            result += stays_as[v] != mended.none and not is_same(a.values[v], a.values[stays_as[v]]) ? 1 : 0;
        return result;
    };
    const auto is_texture = [](const io::attribute& a) {
        return std::ranges::find(io::texture_names, io::shared_name(a.name)) != std::end(io::texture_names);
    };
    const auto has_texture = [&](const std::vector<io::attribute>& all) {
        return std::ranges::any_of(all, is_texture);
    };
    if (not has_texture(attributes.corners) and
        std::ranges::any_of(attributes.vertices, [&](const auto& a) { return is_texture(a) and differing(a) != 0; }))
        move_textures_to_corners(attributes, soup.faces);
    std::map<std::string, std::size_t> lost; // by topic
    for (const io::attribute& a : attributes.vertices)
        if (const std::size_t n = differing(a); n != 0)
            lost[io::topic_of(a.name, "vertices")] = std::max(lost[io::topic_of(a.name, "vertices")], n);
    for (const auto& [topic, n] : lost)
        notes.push_back(topic + ": " + io::counted(n, "joined vertex") +
                        " had other values than the vertex that is kept");
}

/// Returns the tags after a repair. Creases follow the sides of faces, and sharp vertices follow the corners of faces.
io::mesh_tags mended_tags(const io::polygon_soup& soup, const repaired<std::array<double, 3>>& mended,
                          std::vector<std::string>& notes)
{
    io::mesh_tags tags = soup.tags;
    tags.edges.clear(), tags.vertices.clear(), tags.holes.clear();
    std::map<edge, double> wanted;
    for (const auto& [from, to, sharpness] : soup.tags.edges)
        wanted[std::minmax(from, to)] = sharpness;
    std::map<std::size_t, double> sharp_vertices;
    for (const auto& [vertex, sharpness] : soup.tags.vertices) {
        if (vertex >= soup.points.size())
            throw mesh_error("corner " + std::to_string(vertex) + ": there is no such vertex; correct the tag");
        sharp_vertices[vertex] = sharpness;
    }
    std::set<edge> met;
    std::set<std::size_t> met_vertices, kept_vertices;
    std::map<edge, double> edges;
    std::map<std::size_t, double> vertices;
    std::set<edge> kept;
    const auto raise = [](auto& values, const auto& key, double sharpness) {
        const auto [place, is_new] = values.try_emplace(key, sharpness);
        place->second = std::max(place->second, sharpness);
    };
    for (std::size_t f = 0; f < soup.faces.size() and not(wanted.empty() and sharp_vertices.empty()); ++f)
        for (std::size_t c = soup.faces.first[f], end = soup.faces.first[f + 1]; c < end; ++c) {
            const std::size_t next = c + 1 == end ? soup.faces.first[f] : c + 1;
            const std::size_t v = mended.vertex_at[c], w = mended.vertex_at[next];
            const edge old = std::minmax(soup.faces.vertices[c], soup.faces.vertices[next]);
            if (const auto crease = wanted.find(old); crease != wanted.end()) {
                met.insert(old);
                if (v != mended.none and v != w) {
                    kept.insert(old);
                    raise(edges, edge(std::minmax(v, w)), crease->second);
                }
            }
            if (const auto corner = sharp_vertices.find(soup.faces.vertices[c]);
                corner != sharp_vertices.end() and v != mended.none) {
                kept_vertices.insert(corner->first);
                raise(vertices, v, corner->second);
            }
        }
    for (const auto& [ends, sharpness] : wanted)
        if (not met.contains(ends))
            throw mesh_error("crease " + std::to_string(ends.first) + "-" + std::to_string(ends.second) +
                             ": there is no such edge; correct the tag");
    for (const auto& [ends, sharpness] : edges)
        tags.edges.push_back({ends.first, ends.second, sharpness});
    tags.vertices.assign(vertices.begin(), vertices.end());
    const std::set<std::size_t> holes(soup.tags.holes.begin(), soup.tags.holes.end());
    for (const std::size_t hole : holes)
        if (hole >= soup.faces.size())
            throw mesh_error("hole " + std::to_string(hole) + ": there is no such face; correct the tag");
    for (std::size_t f = 0; f < mended.from_face.size(); ++f)
        if (holes.contains(mended.from_face[f]))
            tags.holes.push_back(f);
    const auto note = [&](std::size_t lost, std::string_view noun) {
        if (lost != 0)
            notes.push_back(io::counted(lost, noun) + (lost == 1 ? " is" : " are") +
                            " lost with the elements that the repair removes");
    };
    note(wanted.size() - kept.size(), "crease");
    note(sharp_vertices.size() - kept_vertices.size(), "sharp vertex");
    note(holes.size() - tags.holes.size(), "hole");
    return tags;
}

/// Returns a text on coinciding vertices: "vertex 9 coincides with vertex 1, one of 16 such vertices at the boundary".
std::string crack_text(const io::polygon_soup& soup, const std::vector<edge>& pairs)
{
    const auto number = [&](std::size_t v) { return std::to_string(v + soup.first_number); };
    std::string result = "vertex " + number(pairs[0].first) + " coincides with vertex " + number(pairs[0].second);
    if (pairs.size() > 1)
        result += ", one of " + std::to_string(pairs.size()) + " such vertices at the boundary";
    return result;
}

double distance_from(const std::string& option, std::string_view text)
{
    const auto distance = number_in(text);
    if (not distance or not(*distance >= 0))
        throw usage_error(option + ": '" + std::string(text) + "' is not a distance; give a number of 0 or more");
    return *distance;
}

} // namespace

bool input_repair::empty() const
{
    return not options.drop and not options.split and not options.orient and not options.weld and not welds_rounded;
}

void add_repair_options(po::options_description& options)
{
    add_option<std::string>(
        options,
        "repair",
        "WORDS",
        "repair non-manifold faces: drop (remove them), split (edges and vertices), orient (reverse "
        "them), weld; e.g. orient,split");
    options.add_options()("weld",
                          po::value<std::string>()->implicit_value("")->value_name("[DISTANCE]"),
                          "join boundary vertices within DISTANCE of each other (default: 1e-6 of the mesh diagonal)");
}

input_repair repair_named(std::string_view words)
{
    input_repair result;
    while (not words.empty()) {
        const std::string_view word = words.substr(0, words.find(','));
        words.remove_prefix(std::min(words.size(), word.size() + 1));
        if (word == "drop")
            result.options.drop = true;
        else if (word == "split")
            result.options.split = true;
        else if (word == "orient")
            result.options.orient = true;
        else if (word == "weld")
            result.welds_rounded = true;
        else if (word.starts_with("weld="))
            result.options.weld = distance_from("--repair", word.substr(5));
        else
            throw usage_error("--repair: '" + std::string(word) + "' is not one of drop, split, orient, weld");
    }
    return result;
}

input_repair input_repair_from(const po::variables_map& values)
{
    input_repair result;
    if (values.count("repair") != 0) {
        result = repair_named(values["repair"].as<std::string>());
        if (result.empty())
            throw usage_error("--repair: name one or more of drop, split, orient, weld");
    }
    if (values.count("weld") == 0)
        return result;
    if (const std::string text = values["weld"].as<std::string>(); text.empty())
        result.welds_rounded = true;
    else
        result.options.weld = distance_from("--weld", text);
    return result;
}

std::string words_of(const input_repair& repair)
{
    std::string result;
    const auto add = [&](bool is_chosen, const std::string& word) {
        if (is_chosen)
            result += (result.empty() ? "" : ",") + word;
    };
    add(repair.options.drop, "drop");
    add(repair.options.split, "split");
    add(repair.options.orient, "orient");
    if (repair.options.weld)
        add(true, "weld=" + shortest_text(*repair.options.weld));
    else
        add(repair.welds_rounded, "weld");
    return result;
}

io::polygon_soup repaired_soup(const io::polygon_soup& soup, const input_repair& repair, repair_report& report,
                               std::vector<std::string>& notes)
{
    repair_options options = repair.options;
    if (repair.welds_rounded and not options.weld)
        options.weld = rounding_distance(soup.points);
    auto mended = kith::repair(soup.points, soup.faces, options, soup.first_number);
    io::polygon_soup result = soup;
    result.tags = mended_tags(soup, mended, notes);
    note_other_values(soup, mended, result.attributes, notes);
    for (io::attribute& a : result.attributes.vertices)
        a.values = values_at(a.values, mended.from_vertex);
    for (io::attribute& a : result.attributes.faces)
        a.values = values_at(a.values, mended.from_face);
    for (io::attribute& a : result.attributes.corners)
        a.values = values_at(a.values, mended.from_corner);
    result.points = std::move(mended.points);
    result.faces = std::move(mended.faces);
    report = std::move(mended.report);
    return result;
}

cracks cracks_of(const io::polygon_soup& soup)
{
    cracks result;
    result.distance = rounding_distance(soup.points);
    result.rounded = coinciding_vertices(soup.points, soup.faces, result.distance);
    if (not result.rounded.empty())
        result.equal = coinciding_vertices(soup.points, soup.faces);
    return result;
}

std::vector<std::string> remedies(const io::polygon_soup& soup, const mesh_report& report)
{
    using enum problem;
    std::vector<std::string> result;
    if (report.ok() or report.has(bad_index) or report.has(not_finite) or report.has(empty_mesh))
        return result;
    if (const cracks found = cracks_of(soup); not found.rounded.empty())
        result.push_back(crack_text(soup, found.rounded) + "; --weld joins such vertices, try it first");
    std::string words;
    if (report.has(turned_face))
        append_to_list(words, "orient (reverses faces)");
    if (report.has(turned_face) or report.has(nonmanifold_edge) or report.has(nonmanifold_vertex))
        append_to_list(words, "split (gives each sheet an edge of its own and each fan a vertex of its own)");
    if (report.has(turned_face) or report.has(nonmanifold_edge) or report.has(nonmanifold_vertex) or
        report.has(degenerate_face))
        append_to_list(words, "drop (removes faces)");
    if (not words.empty())
        result.push_back("--repair changes such faces: " + words);
    return result;
}

} // namespace kith::tool
