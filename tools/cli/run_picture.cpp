// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.hpp"
#include "errors.hpp"
#include "json.hpp"
#include "partition_options.hpp"
#include "picture_options.hpp"
#include "run_stats.hpp"
#include "scheme_options.hpp"
#include "terminal.hpp"
#include "job/mesh_input.hpp"
#include "job/picture_colors.hpp"
#include "job/pictured_surface.hpp"

#include <kith/output_file.hpp>
#include <kith/picture.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace kith::tool {

namespace {

/// One of the pictures side by side: the surface of a scheme, or the mesh of a level.
struct shown_surface {
    std::string title;
    pictured_surface surface;
    std::vector<picture::lines> over{}; ///< drawn over the surface
};

std::string title_of(const picture_request& request, const std::string& scheme, std::optional<int> level)
{
    std::string result = request.schemes.size() > 1 ? scheme : "";
    if (level and request.levels.size() > 1)
        result += (result.empty() ? "level " : ", level ") + std::to_string(*level);
    return result;
}

pictured_surface surface_for(const picture_request& request, const pictured_job& job, std::optional<int> level)
{
    if (level)
        return level_in_picture(job, *level);
    if (request.color.by == coloring::mean or request.color.by == coloring::gaussian)
        return curvature_in_picture(job);
    return limit_in_picture(job, request.wire.value_or(0));
}

shown_surface show(const picture_request& request, const pictured_job& job, const std::string& scheme,
                   std::optional<int> level)
{
    shown_surface result{title_of(request, scheme, level), surface_for(request, job, level)};
    if (level)
        result.surface.shape.edges.width = .8;
    if (request.wire) {
        picture::lines wire = wire_in_picture(job, *request.wire);
        wire.width = 1;
        result.over.push_back(std::move(wire));
    }
    if (request.has_cage) {
        picture::lines cage = picture::edges_of(job.control.mesh);
        cage.width = 1.4;
        cage.hidden = .25;
        cage.ink = {.55F, .15F, .1F, 1};
        result.over.push_back(std::move(cage));
    }
    return result;
}

/// Returns the picture of some surfaces, a row for each scheme.
picture::sheet sheet_of(const picture_request& request, std::vector<shown_surface> shown)
{
    picture::sheet result{.view = request.view};
    std::vector<pictured_surface> surfaces;
    for (shown_surface& one : shown)
        surfaces.push_back(std::move(one.surface));
    result.legend = give_colors(surfaces, request.color);
    for (std::size_t i = 0; i < shown.size(); ++i) {
        picture::panel panel{.items = {std::move(surfaces[i].shape)}, .title = std::move(shown[i].title)};
        for (picture::lines& lines : shown[i].over)
            panel.items.emplace_back(std::move(lines));
        result.panels.push_back(std::move(panel));
    }
    const std::size_t count = result.panels.size();
    const std::size_t columns = request.schemes.size() > 1 and not request.levels.empty() ? request.levels.size()
                                                                                          : count;
    result.columns = int(columns);
    constexpr int side = 400;
    result.width = request.width != 0 ? request.width : count == 1 ? 2 * side : side * int(columns);
    result.height = request.height != 0 ? request.height : count == 1 ? side * 3 / 2 : side * int(count / columns);
    if (request.is_transparent)
        result.background = picture::transparent;
    return result;
}

void write_picture(const picture_request& request, const picture::sheet& sheet)
{
    std::optional<picture::image> image;
    if (not request.is_svg)
        image = shown("drawing", {}, [&] { return picture::draw(sheet); });
    io::output_file file(request.output);
    if (image)
        picture::write_png(file.stream(), *image);
    else
        picture::write_svg(file.stream(), sheet);
    file.commit();
}

} // namespace

int run_picture(const verb& verb, const std::vector<std::string>& arguments)
{
    const auto values = parse(verb, options_of_picture(), {"[IN]"}, arguments);
    if (not values)
        return 0;
    picture_request request = picture_request_from(*values);
    const scheme_words words = scheme_words_of(*values);
    std::vector<any_scheme> schemes;
    for (const std::string& name : request.schemes)
        schemes.push_back(make_scheme(name, words));
    const control_mesh input = read_mesh(request.input, input_repair_from(*values));

    std::vector<shown_surface> pictures;
    std::size_t polygons = 0;
    for (std::size_t i = 0; i < schemes.size(); ++i) {
        control_mesh control = input;
        scheme_words own_words = words;
        give_creases(schemes[i], control, own_words);
        keep_colored(control.attributes, request.color);
        if (request.color.by == coloring::tile or request.color.by == coloring::rank) {
            request.color.part_of = make_partition(request.partitioner, control.mesh, request.color.tiles).part_of;
            if (request.color.by == coloring::rank)
                for (auto& part : request.color.part_of)
                    part %= std::uint32_t(request.color.ranks);
        }
        constexpr std::size_t enough_for_pixels = 100'000, enough_for_svg = 4'000;
        const pictured_job job{
            schemes[i], control, memory_limit_from(*values), request.is_svg ? enough_for_svg : enough_for_pixels};
        std::vector<std::optional<int>> levels(request.levels.begin(), request.levels.end());
        if (levels.empty())
            levels.emplace_back();
        for (const std::optional<int> level : levels) {
            pictures.push_back(show(request, job, request.schemes[i], level));
            polygons += pictures.back().surface.shape.face_count();
        }
    }
    const picture::sheet sheet = sheet_of(request, std::move(pictures));
    write_picture(request, sheet);

    const json object{
        {"output", request.output}, {"width", sheet.width}, {"height", sheet.height}, {"polygons", polygons}};
    const std::string line = request.output + ": " + std::to_string(sheet.width) + " x " +
                             std::to_string(sheet.height) + " pixels, " + std::to_string(polygons) + " polygons";
    print_result(std::cout, values->count("json") != 0 ? text_of(object) : line, request.output);
    return 0;
}

} // namespace kith::tool
