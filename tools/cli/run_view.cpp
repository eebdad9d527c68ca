// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.hpp"
#include "errors.hpp"
#include "json.hpp"
#include "partition_options.hpp"
#include "picture_options.hpp"
#include "run_stats.hpp"
#include "scheme_options.hpp"
#include "terminal.hpp"
#include "word_list.hpp"
#include "job/mesh_input.hpp"
#include "job/schemes.hpp"
#include "viewer/page.hpp"

#include <kith/output_file.hpp>
#include <kith/tags_of_creases.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace kith::tool {

namespace {

namespace po = boost::program_options;

constexpr std::array<std::string_view, 4> schemes_of_page{"catmull-clark", "loop", "doo-sabin", "sqrt3"};

std::string names_of_schemes()
{
    std::string result;
    for (const std::string_view name : schemes_of_page)
        append_to_list(result, name);
    return result;
}

po::options_description options_of_view()
{
    po::options_description options("Options");
    add_option<std::string>(
        options, "scheme,s", "NAMES", "the schemes to begin with, side by side: " + names_of_schemes());
    add_option<int>(options, "levels,n", "LEVEL", "the level to begin with (default: 2)");
    add_control_mesh_options(options);
    add_repair_options(options);
    add_option<std::string>(options, "output,o", "OUT", "the page to write, .html");
    add_option<std::int64_t>(options, "tiles", "N", "let the page color N tiles of each mesh");
    add_option<std::string>(options, "partitioner", "P", "how to cut tiles: metis, block or file:PATH");
    add_view_options(options);
    add_flag(options, "json", "print the result line as JSON");
    return options;
}

std::vector<std::string> schemes_from(const po::variables_map& values)
{
    if (values.count("scheme") == 0)
        return {};
    std::vector<std::string> result = parts_of(required(values, "scheme"), ',');
    for (const std::string& name : result)
        if (std::ranges::find(schemes_of_page, name) == schemes_of_page.end())
            throw usage_error("--scheme: '" + name + "' is no scheme of the page; those are " + names_of_schemes());
    return result;
}

/// Returns attributes of vertices or faces as the page reads them; values that an element does not have are null.
void add_attributes(json& list, const std::vector<attribute>& attributes, std::string_view on, std::size_t elements)
{
    for (const attribute& a : attributes)
        list.push_back({{"name", a.name},
                        {"on", on},
                        {"labels", on == "faces" ? a.labels : std::vector<std::string>()},
                        {"values", std::vector(a.values.begin(), a.values.begin() + std::ptrdiff_t(elements))}});
}

/// Returns a control mesh as the page reads it; null stands for an infinite sharpness.
json content_of(const std::string& name, const control_mesh& control, const creases& sharpness,
                const std::vector<std::uint32_t>& tiles, std::size_t tile_count)
{
    const basic_mesh<>& mesh = control.mesh;
    std::vector<double> points;
    std::vector<std::size_t> degrees, corners;
    json edges = json::array();
    for (const auto& p : mesh.points())
        points.insert(points.end(), p.begin(), p.end());
    for (const auto face : mesh.faces()) {
        degrees.push_back(face.size());
        corners.insert(corners.end(), face.begin(), face.end());
    }
    const mesh_tags tags = tags_of(sharpness, level_of<basic_mesh<>>(mesh));
    for (const auto& [from, to, s] : tags.edges)
        edges.push_back({from, to, s});
    json attributes = json::array();
    add_attributes(attributes, control.attributes.vertices, "vertices", mesh.vertex_count());
    add_attributes(attributes, control.attributes.faces, "faces", mesh.face_count());
    return {{"name", name},
            {"points", std::move(points)},
            {"degrees", std::move(degrees)},
            {"corners", std::move(corners)},
            {"edges", std::move(edges)},
            {"vertices", tags.vertices},
            {"chaikin", sharpness.method == crease_method::chaikin},
            {"tiles", tiles},
            {"tileCount", tile_count},
            {"attributes", std::move(attributes)}};
}

/// Returns the mesh of a file for the page. Errors: those of reading, of the partition, and mesh_error for a mesh that
/// one of these schemes does not take.
json content_of_file(const std::string& path, const std::vector<std::string>& schemes, const po::variables_map& values)
{
    control_mesh control = read_mesh(path, input_repair_from(values));
    scheme_words words = scheme_words_of(values);
    any_scheme scheme = make_scheme("catmull-clark", words);
    give_creases(scheme, control, words);
    for (const std::string& name : schemes)
        require_scheme_takes(make_scheme(name, {}), control.mesh);
    std::vector<std::uint32_t> tiles;
    const auto tile_count = std::size_t(count_from(values, "tiles", most_tiles_per_rank));
    if (values.count("tiles") != 0)
        tiles = make_partition(partitioner_from(values), control.mesh, tile_count).part_of;
    return content_of(std::filesystem::path(path).filename().string(),
                      control,
                      std::get<catmull_clark>(scheme).sharpness,
                      tiles,
                      tile_count);
}

/// Returns JSON as the content of an element of HTML, which the text "</script>" would end.
std::string text_in_html(const json& content)
{
    std::string result;
    for (const char c : text_of(content))
        if (c == '<')
            result += "\\u003c";
        else
            result += c;
    return result;
}

} // namespace

int run_view(const verb& verb, const std::vector<std::string>& arguments)
{
    const auto values = parse(verb, options_of_view(), {"IN..."}, arguments);
    if (not values)
        return 0;
    if (viewer_page.empty())
        throw usage_error(
            "view: this program was built without its page; build kith where clang compiles to WebAssembly "
            "(lld-19, wasi-libc, libc++-19-dev-wasm32, libc++abi-19-dev-wasm32, libclang-rt-19-dev-wasm32)");
    const picture::view view = view_from(*values);
    const std::vector<std::string> schemes = schemes_from(*values);
    json content{{"schemes", schemes},
                 {"level", values->count("levels") != 0 ? levels_of(*values) : 2},
                 {"view", {{"azimuth", view.azimuth}, {"elevation", view.elevation}, {"up", view.up}}},
                 {"meshes", json::array()}};
    if (values->count("partitioner") != 0 and values->count("tiles") == 0)
        throw usage_error("--partitioner: applies to tiles; name --tiles as well");
    const std::string output = output_of(*values);
    if (not output.ends_with(".html"))
        throw usage_error("view: '" + output + "' is no name of a page; give one that ends with .html");
    for (const std::string& path : (*values)["IN..."].as<std::vector<std::string>>())
        content["meshes"].push_back(content_of_file(path, schemes, *values));

    constexpr std::string_view mark = "@CONTENT@";
    const std::size_t at = viewer_page.find(mark);
    const std::string text = text_in_html(content);
    output_file file(output);
    file.stream() << viewer_page.substr(0, at) << text << viewer_page.substr(at + mark.size());
    file.commit();

    const std::size_t bytes = viewer_page.size() - mark.size() + text.size();
    const json object{{"output", output}, {"meshes", content["meshes"].size()}, {"bytes", bytes}};
    print_result(std::cout,
                 values->count("json") != 0 ? text_of(object) : output + ": " + std::to_string(bytes) + " bytes",
                 output);
    return 0;
}

} // namespace kith::tool
