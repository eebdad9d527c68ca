// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.hpp"
#include "errors.hpp"
#include "json.hpp"
#include "shortest_text.hpp"
#include "run_refine_tiles.hpp"
#include "run_stats.hpp"
#include "scheme_options.hpp"
#include "terminal.hpp"
#include "tile_options.hpp"
#include "job/back_end.hpp"
#include "job/holes.hpp"
#include "job/limit_surface.hpp"
#include "job/mesh_input.hpp"
#include "job/settle_attributes.hpp"

#include <kith/core/level/to_native.hpp>
#include <kith/io/format/held_attributes.hpp>
#include <kith/io/format/mesh_format.hpp>
#include <kith/io/text/counted.hpp>
#include <kith/plan.hpp>
#include <kith/write_mesh.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <utility>
#include <variant>

#if defined(_OPENMP)
#include <omp.h>
#endif

namespace kith::tool {

namespace {

namespace po = boost::program_options;

refined_mesh refine_on(mesh_kind mesh, basic_mesh<> control, const refine_request& request)
{
    switch (mesh) {
    case mesh_kind::native: break;
    case mesh_kind::cgal: return refine_cgal(std::move(control), request);
    case mesh_kind::openmesh: return refine_openmesh(std::move(control), request);
    }
    return refine_native(std::move(control), request);
}

po::options_description options_of_refine()
{
    po::options_description options("Options");
    add_scheme_options(options);
    add_uv_option(options);
    add_repair_options(options);
    add_option<std::string>(options, "output,o", "OUT", "the file to write; - is standard output");
    add_flag(options, "binary", "write PLY or STL as binary instead of text");
    add_flag(options, "limit", "write limit positions of the vertices; in OFF, OBJ and PLY with limit normals");
    add_flag(options, "drop-isolated", "leave out isolated vertices (otherwise they are written after the others)");
    add_option<std::string>(options, "mesh", "MESH", "refine on this kind of mesh: " + mesh_kind_names());
    add_option<std::int64_t>(
        options, "tiles", "N", "refine in N tiles, one in memory at a time; OUT is .vtu, .ply or .pvtu");
    add_option<std::string>(options, "partitioner", "P", "how to cut tiles: metis, block or file:PATH");
    add_option<std::string>(options, "journal", "DIR", journal_help);
    add_option<std::string>(options, "only", "A..B", "refine only tiles A to B of the journal, numbered from 0");
    add_option<std::string>(
        options,
        "memory-limit",
        "BYTES",
        "refuse jobs that need more memory, e.g. 500M or 4G (default: 9/10 of the available memory)");
#if defined(_OPENMP)
    add_option<std::int64_t>(options, "threads", "N", "run on N threads");
#endif
    add_flag(
        options, "verify", "with tiles: read the output back; with a journal, also tiles that earlier jobs finished");
    add_flag(options, "checksum", "with tiles: print a checksum of the surface, independent of the number of tiles");
    add_option<std::string>(
        options,
        "way",
        "WAY",
        "go one way where it can be gone: levels, order or patches; `kith plan --why` tells which is taken");
    add_option<std::string>(options, "stats", "FILE", stats_help);
    add_flag(options, "json", "print the result line as JSON");
    return options;
}

/// Keeps the points without a face, which are written after the vertices, unless `drop` is true or the format cannot
/// hold them.
void settle_isolated(control_mesh& control, mesh_format format, bool drop)
{
    if (control.isolated.empty())
        return;
    const std::string points = counted(control.isolated.size(), "vertex") + " without a face";
    if (drop) {
        control.isolated.clear();
    } else if (not contents_of(format).isolated_points) {
        control.not_kept.push_back(points);
        control.isolated.clear();
    } else {
        std::cerr << "kith: note: " << points << (control.isolated.size() == 1 ? " is" : " are")
                  << " written after the others; --drop-isolated leaves out such vertices\n";
    }
}

/// Appends the attribute values of the points without a face to those of the vertices.
void append_isolated(io::mesh_attributes& attributes, const control_mesh& control)
{
    for (std::size_t i = 0; i < attributes.vertices.size(); ++i) {
        const auto& values = control.attributes.vertices[i].values;
        attributes.vertices[i].values.insert(
            attributes.vertices[i].values.end(), values.end() - std::ptrdiff_t(control.isolated.size()), values.end());
    }
}

/// Prints a note on what the floats of a format change, if that is more than the last digits of the mesh. `fallen` is
/// the number of triangles that are left out.
void note_rounding(const std::string& output, const std::string& format, const written_mesh& what, std::size_t fallen)
{
    double largest_move = 0, size = 0;
    std::array<double, 3> least = what.mesh.point(0), most = least;
    for (const auto& p : what.mesh.points())
        for (std::size_t i = 0; i < 3; ++i) {
            largest_move = std::max(largest_move, std::abs(p[i] - double(float(p[i]))));
            least[i] = std::min(least[i], p[i]);
            most[i] = std::max(most[i], p[i]);
            size = std::max(size, most[i] - least[i]);
        }
    constexpr double last_digits = 1e-6;
    if (fallen == 0 and largest_move <= last_digits * size)
        return;
    std::cerr << "kith: note: " << output << ": the floats of " << format << " move coordinates by up to "
              << shortest_text(largest_move);
    if (fallen != 0)
        std::cerr << "; " << fallen << " of " << counted(what.mesh.face_count(), "triangle")
                  << (fallen == 1 ? " collapses and is" : " collapse and are") << " left out";
    std::cerr << (format == ".glb" ? "; " : "; text, ") << ".off, .obj and .ply keep doubles\n";
}

/// Returns the number of bytes by which memory grows until the last level is made. They hold that level, or all levels
/// if each is a mesh of its own. Errors: mesh_error for levels that cannot be planned.
double bytes_of_levels(const refine_request& request, const basic_mesh<>& control, mesh_kind mesh)
{
    const auto planned = std::visit(
        [&](const auto& scheme) {
            return plan_what_fits(count(control.topology()), scheme, request.levels, control.generation()).levels;
        },
        request.scheme);
    if (mesh == mesh_kind::native)
        return double(request.limit or request.with_tags ? planned.back().bytes : planned.back().least_bytes);
    return double(job_bytes(planned,
                            {.mesh = mesh,
                             .limit = request.limit,
                             .corner_normals = request.corner_normals,
                             .tags = request.with_tags,
                             .attributes = request.counted}));
}

/// Returns the share of a refinement that is done, measured by the memory that it fills. Returns an empty function for
/// levels that cannot be planned; their refinement is refused with the reason.
share_of_work share_of_refinement(const refine_request& request, const basic_mesh<>& control, mesh_kind mesh)
{
    try {
        return share_of_memory(bytes_of_levels(request, control, mesh));
    } catch (const mesh_error&) {
        return {};
    }
}

void set_threads([[maybe_unused]] const po::variables_map& values)
{
#if defined(_OPENMP)
    if (values.count("threads") != 0)
        omp_set_num_threads(int(count_from(values, "threads", most_threads)));
#endif
}

void force_way_from(const po::variables_map& values)
{
    if (values.count("way") == 0)
        return;
    const std::string given = required(values, "way");
    constexpr std::array names{"levels", "order", "patches"}; // in the order of refinement_way
    const auto found = std::ranges::find(names, given);
    if (found == names.end())
        throw usage_error("--way: '" + given + "' is not one of levels, order, patches");
    force_way(refinement_way(found - names.begin()));
}

} // namespace

int run_refine(const verb& verb, const std::vector<std::string>& arguments)
{
    const auto values = parse(verb, options_of_refine(), {"[IN]"}, arguments);
    if (not values)
        return 0;
    const auto given = [&](const char* option) { return values->count(option) != 0; };
    set_threads(*values);
    force_way_from(*values);
    if (given("tiles") or given("journal") or given("only") or is_tile_format_only(*values))
        return run_refine_tiles(*values);
    for (const char* option : {"verify", "checksum", "partitioner"})
        if (given(option))
            throw usage_error("--" + std::string(option) + ": applies to tiles only; name --tiles as well");
    shared_blocks.keep_at_most(0); // nothing is refined after this
    const std::string input = required(*values, "IN");
    const std::string output = output_of(*values);
    const std::string scheme = required(*values, "scheme");
    const mesh_kind mesh = mesh_kind_from(*values);
    scheme_words words = scheme_words_of(*values);
    const input_repair repair = input_repair_from(*values);
    refine_request request{.scheme = make_scheme(scheme, words),
                           .levels = levels_of(*values),
                           .memory = memory_limit_from(*values),
                           .limit = given("limit")};
    const face_varying_linear linear = linear_from(*values, request.scheme);
    const mesh_format format = output_format_of(output);
    const io::format_contents& contents = contents_of(format);
    request.with_tags = contents.tags;
    const bool binary = is_binary_from(*values, output);

    phase_seconds seconds;
    control_mesh control = timed(seconds[phase::read], [&] { return read_mesh(input, repair); });
    io::mesh_attributes attributes;
    refined_mesh result = timed(seconds[phase::refine], [&] {
        give_creases(request.scheme, control, words);
        if (not request.limit) // points on the limit are not refined further
            tell_next_step(control, request.scheme, request.levels);
        request.holes = holes_of(control.tags, control.mesh);
        settle_attributes(control, format, {request.scheme, request.levels, request.limit, binary});
        const bool has_normals_of_sides = request.limit and has_sides(request.scheme);
        request.corner_normals = has_normals_of_sides and contents.corner_normals;
        if (has_normals_of_sides and contents.normals and not contents.corner_normals)
            control.not_kept.emplace_back(normals_of_sides);
        request.attributes = attribute_fields(control.attributes, control.mesh, linear);
        request.counted = count_of(control.attributes, linear);
        auto start = prepared(request.scheme, std::move(control.mesh), request.attributes);
        const share_of_work share = share_of_refinement(request, start, mesh);
        refined_mesh refined = shown("refining", share, [&] { return refine_on(mesh, std::move(start), request); });
        request.attributes = {};
        attributes = refined.attributes.at_level(control.attributes);
        refined.attributes = {};
        if (not refined.holes.empty())
            leave_out_holes(refined, attributes);
        return refined;
    });
    if (request.with_tags) {
        add_boundary_tag(result.tags, request.scheme);
    } else {
        const sharp_elements left = sharp_after(request.scheme, request.levels);
        add_lost_sharpness(control.not_kept, left.edges, left.vertices);
        if (not request.limit)
            add_lost_boundary_rule(control.not_kept, control.tags, request.scheme);
    }
    settle_isolated(control, format, given("drop-isolated"));
    append_isolated(attributes, control);
    const written_mesh what{.mesh = result.mesh,
                            .normals = result.normals,
                            .isolated = control.isolated,
                            .tags = &result.tags,
                            .binary = binary,
                            .attributes = &attributes,
                            .corner_normals = result.corner_normals};
    timed(seconds[phase::write], [&] {
        const shown_phase writing("writing", share_of_file);
        write_mesh_file(output, what);
    });
    note_losses(input, control.not_kept);
    note_zeros(output, written_as_zero(format, attributes));
    if (format == mesh_format::stl and binary)
        note_rounding(output, "binary STL", what, fallen_faces(what));
    if (format == mesh_format::glb)
        note_rounding(output, ".glb", what, 0);

    const auto vertices = result.mesh.vertex_count() + control.isolated.size();
    const auto faces = result.mesh.face_count();
    if (given("stats"))
        write_stats(required(*values, "stats"), seconds);
    json object{{"scheme", scheme},
                {"mesh", given("mesh") ? required(*values, "mesh") : "native"},
                {"levels", request.levels},
                {"vertices", vertices},
                {"edges", result.edges},
                {"faces", faces},
                {"output", output}};
    if (given("stats"))
        object["seconds"] = json_of(seconds);
    const std::string line = output + ": " + std::to_string(vertices) + " vertices, " + std::to_string(result.edges) +
                             " edges, " + std::to_string(faces) + " faces";
    print_result(output == standard_stream ? std::cerr : std::cout, given("json") ? text_of(object) : line, output);
    return 0;
}

} // namespace kith::tool
