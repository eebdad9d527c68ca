// SPDX-License-Identifier: BSD-3-Clause
#include "scheme_options.hpp"

#include "command_line.hpp"
#include "errors.hpp"
#include "scheme_words.hpp"

namespace kith::tool {

void add_control_mesh_options(boost::program_options::options_description& options)
{
    add_option<double>(options,
                       "crease-angle",
                       "DEGREES",
                       "catmull-clark, loop: sharpen edges whose face normals differ by more than DEGREES");
    add_option<double>(
        options, "crease-sharpness", "S", "make these edges sharp for S levels (default: on all levels)");
    add_option<std::string>(options,
                            "crease-method",
                            "WORD",
                            "how the sharpness of creases in the file decays: " + all_words<crease_method>());
    add_flag(options,
             "triangulate",
             "cut faces into triangles first: quads along the better diagonal, others in their planes");
    add_flag(options, "ignore-tags", "ignore the tags of an OBJ file (creases, corners, holes, boundary rules)");
}

void add_scheme_options(boost::program_options::options_description& options, bool with_levels)
{
    add_option<std::string>(options, "scheme,s", "SCHEME", scheme_names());
    if (with_levels)
        add_option<int>(options, "levels,n", "LEVELS", "number of refinement steps");
    add_option<std::string>(options, "preset", "WORD", "use the rules of this library: " + all_words<library>());
    add_option<std::string>(options,
                            "boundary-corners",
                            "WORD",
                            "rule for boundary vertices with a single face: " + all_words<boundary_corner>());
    add_option<std::string>(options,
                            "weights",
                            "WORD",
                            "loop: " + all_words<loop_weights>() + "; doo-sabin: " + all_words<doo_sabin_weights>());
    add_option<std::string>(options,
                            "boundary",
                            "WORD",
                            "doo-sabin: " + all_words<doo_sabin_boundary>() +
                                "; catmull-clark: " + all_words<boundary_curve>());
    add_control_mesh_options(options);
    add_option<double>(options, "tension", "W", "kobbelt: between 0 and 2.472 (default: 1)");
    add_option<int>(options, "degree", "N", "unified: degree of the B-spline, 1 to 9 (default: 3)");
}

scheme_words scheme_words_of(const boost::program_options::variables_map& values)
{
    const auto word = [&](const char* name) {
        return values.count(name) == 0 ? std::string() : values[name].as<std::string>();
    };
    const auto number = [&](const char* name) {
        return values.count(name) == 0 ? std::nullopt : std::optional(values[name].as<double>());
    };
    return {.preset = word("preset"),
            .boundary_corners = word("boundary-corners"),
            .weights = word("weights"),
            .boundary = word("boundary"),
            .crease_method = word("crease-method"),
            .crease_angle = number("crease-angle"),
            .crease_sharpness = number("crease-sharpness"),
            .tension = number("tension"),
            .degree = values.count("degree") == 0 ? std::nullopt : std::optional(values["degree"].as<int>()),
            .ignore_tags = values.count("ignore-tags") != 0,
            .triangulate = values.count("triangulate") != 0};
}

void add_uv_option(boost::program_options::options_description& options)
{
    add_option<std::string>(
        options,
        "uv",
        "WORD",
        "catmull-clark, loop: where texture coordinates are interpolated linearly, as named by OpenSubdiv: " +
            all_words<face_varying_linear>() + " (default: all)");
}

face_varying_linear linear_from(const boost::program_options::variables_map& values, const any_scheme& scheme)
{
    if (values.count("uv") == 0)
        return face_varying_linear::all;
    const auto result = choice_from<face_varying_linear>("--uv", values["uv"].as<std::string>());
    if (result != face_varying_linear::all and not refines_along_seams(scheme))
        throw usage_error("--uv: only " + schemes_with_creases() +
                          " have rules for seams of texture coordinates; leave it out, or use all");
    return result;
}

} // namespace kith::tool
