// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.hpp"
#include "errors.hpp"
#include "json.hpp"
#include "run_stats.hpp"
#include "scheme_options.hpp"
#include "terminal.hpp"
#include "job/holes.hpp"
#include "job/mesh_input.hpp"
#include "job/settle_attributes.hpp"
#include "job/surface_places.hpp"

#include <kith/write_mesh.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace kith::tool {

namespace {

namespace po = boost::program_options;

po::options_description options_of_tessellate()
{
    po::options_description options("Options");
    add_scheme_options(options, false);
    add_repair_options(options);
    add_option<std::string>(options, "output,o", "OUT", "the file to write; - is standard output");
    add_option<std::int64_t>(options, "segments", "N", "cut each edge of the mesh into at least N segments");
    add_option<double>(options, "longest-edge", "L", "the largest length of an edge of a triangle");
    add_option<double>(options, "chord-error", "E", "the largest distance between the surface and the triangles");
    add_option<double>(options, "angle", "DEGREES", "about the largest angle between neighbouring segments");
    add_flag(options, "binary", "write PLY or STL as binary instead of text");
    add_flag(options, "json", "print the result line as JSON");
    return options;
}

/// Returns the options of a tessellation. Errors: usage_error if none of --segments, --longest-edge, --chord-error and
/// --angle is given, and for numbers that are not positive.
tessellation_options tessellation_options_from(const po::variables_map& values)
{
    tessellation_options result;
    const auto take = [&](const char* name, double& to, double unit) {
        if (values.count(name) == 0)
            return;
        const double number = values[name].as<double>();
        if (not(number > 0) or std::isinf(number))
            throw usage_error("--" + std::string(name) + ": give a positive number");
        to = number * unit;
    };
    take("longest-edge", result.longest_edge, 1);
    take("chord-error", result.chord_error, 1);
    take("angle", result.angle, std::numbers::pi / 180);
    constexpr std::int64_t most_segments = 4096;
    result.segments = std::size_t(count_from(values, "segments", most_segments));
    if (values.count("segments") + values.count("longest-edge") + values.count("chord-error") + values.count("angle") ==
        0)
        throw usage_error("tessellate: name --chord-error, --longest-edge, --angle or --segments");
    return result;
}

/// The triangles of a tessellation, and their vertices as places that can be evaluated.
struct located_triangles {
    surface_triangles made;
    located_places at;
};

/// Returns the attributes of the triangles. Those of vertices are as smooth as the surface; those of faces come from
/// the face in which a triangle lies.
io::mesh_attributes attributes_on(const located_triangles& on, const io::mesh_attributes& of_control,
                                  std::size_t vertices)
{
    io::mesh_attributes result;
    for (io::attribute a : of_control.vertices) {
        a.values.resize(vertices);
        const auto values = on.at.evaluate(a.values).points;
        a.values.assign(values.begin(), values.end());
        for (double& x : a.values)
            x = io::as_stored(a.type, x);
        result.vertices.push_back(std::move(a));
    }
    for (const io::attribute& from : of_control.faces) {
        io::attribute a{from.name, from.type, {}, from.labels};
        for (const std::size_t face : on.made.faces)
            a.values.push_back(from.values[face]);
        result.faces.push_back(std::move(a));
    }
    result.file_lines = of_control.file_lines;
    return result;
}

/// Moves attributes and points that a tessellation cannot carry to the list of what is lost.
void settle(control_mesh& control, mesh_format format, const any_scheme& scheme, bool is_binary)
{
    settle_attributes(control, format, {scheme, 1, true, is_binary});
    io::mesh_attributes of_corners;
    std::swap(of_corners.corners, control.attributes.corners);
    for (const std::string& topic : topics_of(of_corners))
        control.not_kept.push_back(topic);
    if (not control.isolated.empty())
        control.not_kept.emplace_back("vertices without a face");
}

} // namespace

int run_tessellate(const verb& verb, const std::vector<std::string>& arguments)
{
    const auto values = parse(verb, options_of_tessellate(), {"[IN]"}, arguments);
    if (not values)
        return 0;
    const std::string input = required(*values, "IN");
    const std::string output = output_of(*values);
    const std::string scheme_name = required(*values, "scheme");
    scheme_words words = scheme_words_of(*values);
    const input_repair repair = input_repair_from(*values);
    const tessellation_options options = tessellation_options_from(*values);
    any_scheme scheme = make_scheme(scheme_name, words);
    const mesh_format format = output_format_of(output);
    const bool is_binary = is_binary_from(*values, output);

    control_mesh control = read_mesh(input, repair);
    give_creases(scheme, control, words);
    settle(control, format, scheme, is_binary);
    const hole_field holes = holes_of(control.tags, control.mesh);
    located_triangles on_surface{tessellate_with(scheme, "tessellate", control.mesh, options), {}};
    if (not control.attributes.vertices.empty())
        on_surface.at = locate_with(scheme, "tessellate", control.mesh, on_surface.made.places);
    auto attributes = attributes_on(on_surface, control.attributes, control.mesh.vertex_count());
    surface_triangles& made = on_surface.made;
    refined_mesh result;
    result.mesh = std::move(made.mesh);
    result.normals = std::move(made.normals);
    if (not holes.empty()) {
        storage<bool> is_hole(made.faces.size());
        for (std::size_t f = 0; f < is_hole.size(); ++f)
            is_hole[f] = holes[made.faces[f]];
        result.holes = hole_field(std::move(is_hole));
        leave_out_holes(result, attributes);
    }
    write_mesh_file(output,
                    {.mesh = result.mesh, .normals = result.normals, .binary = is_binary, .attributes = &attributes});
    note_losses(input, control.not_kept);

    const auto vertices = result.mesh.vertex_count(), faces = result.mesh.face_count();
    const json object{{"scheme", scheme_name}, {"vertices", vertices}, {"faces", faces}, {"output", output}};
    const std::string line = output + ": " + std::to_string(vertices) + " vertices, " + std::to_string(faces) +
                             " triangles";
    print_result(
        output == standard_stream ? std::cerr : std::cout, values->count("json") != 0 ? text_of(object) : line, output);
    return 0;
}

} // namespace kith::tool
