// SPDX-License-Identifier: BSD-3-Clause
#include "picture_options.hpp"

#include "command_line.hpp"
#include "errors.hpp"
#include "partition_options.hpp"
#include "scheme_options.hpp"
#include "word_list.hpp"

#include <kith/picture.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>
#include <tuple>
#include <utility>

namespace kith::tool {

namespace {

namespace po = boost::program_options;

constexpr std::array<std::pair<std::string_view, std::array<double, 2>>, 7> views{
    {{"isometric", {picture::view{}.azimuth, picture::view{}.elevation}},
     {"front", {0, 0}},
     {"back", {180, 0}},
     {"left", {-90, 0}},
     {"right", {90, 0}},
     {"top", {0, 90}},
     {"bottom", {0, -90}}}};

/// Returns the whole number that a text stands for, or nothing for any other text and for numbers out of a range.
std::optional<int> whole_number_in(std::string_view text, int least, int most)
{
    int value = 0;
    const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() or rest != text.data() + text.size() or value < least or value > most)
        return std::nullopt;
    return value;
}

constexpr int most_levels = 20, most_pixels = 16384;

std::vector<int> levels_from(const std::string& text)
{
    std::vector<int> result;
    for (const std::string& part : parts_of(text, ',')) {
        const auto level = whole_number_in(part, 0, most_levels);
        if (not level)
            throw usage_error("--levels: '" + part + "' is no level; give levels from 0 to " +
                              std::to_string(most_levels) + ", such as 0,1,2");
        result.push_back(*level);
    }
    return result;
}

std::pair<int, int> size_from(const std::string& text)
{
    const auto parts = parts_of(text, 'x');
    const auto width = whole_number_in(parts[0], 1, most_pixels);
    const auto height = parts.size() == 2 ? whole_number_in(parts[1], 1, most_pixels) : std::nullopt;
    if (not width or not height)
        throw usage_error("--size: '" + text + "' is no size; give width and height in pixels, up to " +
                          std::to_string(most_pixels) + ", such as 800x600");
    return {*width, *height};
}

bool is_svg_from(const std::string& output)
{
    if (output.ends_with(".svg"))
        return true;
    if (not output.ends_with(".png"))
        throw usage_error("picture: '" + output + "' is no name of a picture; give one that ends with .png or .svg");
    if (not picture::writes_png())
        throw usage_error("picture: this program was built without libpng; give a name that ends with .svg");
    return false;
}

} // namespace

void add_view_options(po::options_description& options)
{
    add_option<std::string>(options,
                            "view",
                            "VIEW",
                            "isometric (default), front, back, left, right, top, bottom, or azimuth and elevation in "
                            "degrees, such as 30,20");
    add_option<std::string>(options, "up", "AXIS", "the axis that points upward: x, y or z (default)");
}

picture::view view_from(const po::variables_map& values)
{
    picture::view result;
    if (values.count("view") != 0) {
        const std::string given = required(values, "view");
        const auto* const found = std::ranges::find(views, given, &decltype(views)::value_type::first);
        const auto parts = parts_of(given, ',');
        const auto azimuth = number_in(parts[0]), elevation = parts.size() == 2 ? number_in(parts[1]) : std::nullopt;
        if (found == views.end() and not(azimuth and elevation)) {
            std::string known;
            for (const auto& view : views)
                append_to_list(known, view.first);
            throw usage_error("--view: '" + given + "' is not one of " + known +
                              ", or two angles in degrees such as 30,20");
        }
        result.azimuth = found != views.end() ? found->second[0] : *azimuth;
        result.elevation = found != views.end() ? found->second[1] : *elevation;
    }
    if (values.count("up") != 0) {
        const std::string given = required(values, "up");
        const auto axis = std::string_view("xyz").find(given);
        if (given.size() != 1 or axis == std::string_view::npos)
            throw usage_error("--up: '" + given + "' is not one of x, y, z");
        result.up = int(axis);
    }
    return result;
}

po::options_description options_of_picture()
{
    po::options_description options("Options");
    add_scheme_options(options, false);
    add_repair_options(options);
    add_option<std::string>(options, "output,o", "OUT", "the picture to write, .png or .svg");
    add_option<std::string>(
        options, "levels,n", "LEVELS", "show the meshes of these levels, such as 0,1,2, not the limit surface");
    add_option<int>(options, "wire", "LEVEL", "draw the edges of this level on the limit surface");
    add_flag(options, "cage", "draw the control mesh, faint where it is hidden");
    add_option<std::string>(
        options,
        "color",
        "WORD",
        "the meaning of colors: plain, parent (face of the control mesh), tile, rank, level, mean or gaussian "
        "curvature, reflection lines, checker or texture:FILE by texture coordinates, or attribute:NAME");
    add_option<std::int64_t>(options, "tiles", "N", "the number of tiles for --color tile and rank");
    add_option<std::int64_t>(
        options, "ranks", "N", "the number of ranks for --color rank; without --tiles each has one tile");
    add_option<std::string>(options, "partitioner", "P", "how to cut tiles: metis, block or file:PATH");
    add_view_options(options);
    add_option<std::string>(options, "size", "WxH", "width and height in pixels, such as 800x600");
    add_flag(options, "transparent", "leave out the white background");
    add_flag(options, "json", "print the result line as JSON");
    return options;
}

picture_request picture_request_from(const po::variables_map& values)
{
    const auto given = [&](const char* option) { return values.count(option) != 0; };
    picture_request result{.input = required(values, "IN"), .output = output_of(values)};
    result.is_svg = is_svg_from(result.output);
    result.schemes = parts_of(required(values, "scheme"), ',');
    if (given("levels"))
        result.levels = levels_from(values["levels"].as<std::string>());
    if (given("wire")) {
        const int level = values["wire"].as<int>();
        if (level < 0 or level > most_levels)
            throw usage_error("--wire: give a level from 0 to " + std::to_string(most_levels));
        if (given("levels"))
            throw usage_error("--wire: applies to the limit surface; leave out --levels, or --wire");
        result.wire = level;
    }
    result.has_cage = given("cage");
    if (given("color"))
        result.color = coloring_named(required(values, "color"));
    const coloring by = result.color.by;
    if (given("levels") and (by == coloring::mean or by == coloring::gaussian))
        throw usage_error("--color: curvature is that of the limit surface; leave out --levels");
    if (by == coloring::level and not given("levels"))
        throw usage_error("--color: level needs the levels that are shown; name --levels as well");
    if (by == coloring::tile and not given("tiles"))
        throw usage_error("--color: tile needs the number of tiles; name --tiles as well");
    if (by == coloring::rank and not given("ranks"))
        throw usage_error("--color: rank needs the number of ranks; name --ranks as well");
    for (const char* option : {"tiles", "partitioner"})
        if (by != coloring::tile and by != coloring::rank and given(option))
            throw usage_error("--" + std::string(option) + ": applies to --color tile and rank only; name one as well");
    if (by != coloring::rank and given("ranks"))
        throw usage_error("--ranks: applies to --color rank only; name it as well");
    result.color.ranks = std::size_t(count_from(values, "ranks", most_ranks));
    result.color.tiles = given("tiles") ? std::size_t(count_from(values, "tiles", most_tiles_per_rank))
                                        : result.color.ranks;
    result.partitioner = partitioner_from(values);
    result.view = view_from(values);
    if (given("size"))
        std::tie(result.width, result.height) = size_from(required(values, "size"));
    result.is_transparent = given("transparent");
    return result;
}

} // namespace kith::tool
