// SPDX-License-Identifier: BSD-3-Clause
#include "picture_colors.hpp"

#include "cli/errors.hpp"
#include "cli/word_list.hpp"

#include <kith/io/format/held_attributes.hpp>
#include <kith/io/text/file_error.hpp>
#include <kith/picture/image.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <fstream>
#include <limits>
#include <span>
#include <stdexcept>
#include <utility>

namespace kith::tool {

namespace {

constexpr std::array<std::pair<std::string_view, coloring>, 9> words{{{"plain", coloring::plain},
                                                                      {"parent", coloring::parent},
                                                                      {"tile", coloring::tile},
                                                                      {"rank", coloring::rank},
                                                                      {"level", coloring::level},
                                                                      {"mean", coloring::mean},
                                                                      {"gaussian", coloring::gaussian},
                                                                      {"reflection", coloring::reflection},
                                                                      {"checker", coloring::checker}}};
constexpr std::string_view attribute_prefix = "attribute:", texture_prefix = "texture:";
constexpr std::size_t most_entries = 12; // of a legend that is a list
constexpr picture::color without_value{.88F, .88F, .88F, 1};

/// The values of a surface, one for each vertex or one for each polygon.
struct shown_values {
    std::vector<double> values;
    bool are_at_vertices = false;
    std::vector<std::string> labels{}; ///< of values that are numbers of words
};

/// Replaces values of vertices that are no numbers by the mean of the numbers in their polygons: curvature at irregular
/// vertices.
void fill_gaps(std::vector<double>& values, const picture::surface& shape)
{
    std::vector<double> sums(values.size()), counts(values.size());
    for (std::size_t f = 0; f < shape.face_count(); ++f) {
        const auto corners = std::span(shape.corners).subspan(shape.first[f], shape.first[f + 1] - shape.first[f]);
        for (const auto v : corners)
            if (not std::isfinite(values[v]))
                for (const auto w : corners)
                    if (std::isfinite(values[w]))
                        sums[v] += values[w], ++counts[v];
    }
    for (std::size_t v = 0; v < values.size(); ++v)
        if (counts[v] > 0)
            values[v] = sums[v] / counts[v];
}

shown_values values_of(const pictured_surface& surface, const color_request& request)
{
    shown_values result;
    switch (request.by) {
    case coloring::parent: result.values = surface.parents; break;
    case coloring::tile:
    case coloring::rank:
        for (const double parent : surface.parents)
            result.values.push_back(std::isfinite(parent) ? double(request.part_of[std::size_t(parent)]) : parent);
        break;
    case coloring::level: result.values.assign(surface.shape.face_count(), surface.level); break;
    case coloring::mean:
    case coloring::gaussian:
        result.are_at_vertices = true;
        for (const surface_curvature& c : surface.curvatures)
            result.values.push_back(request.by == coloring::mean ? c.mean : c.gaussian);
        fill_gaps(result.values, surface.shape);
        break;
    case coloring::attribute:
        for (const auto* attributes : {&surface.attributes.vertices, &surface.attributes.faces})
            for (const io::attribute& a : *attributes)
                result = {a.values, attributes == &surface.attributes.vertices, a.labels};
        break;
    case coloring::plain:
    case coloring::reflection:
    case coloring::checker:
    case coloring::texture: break;
    }
    return result;
}

/// Returns squares of two colors, eight along each side, whose lower left one is red.
picture::image checker()
{
    constexpr std::size_t squares = 8, pixels = 32; // of a side
    picture::image result{squares * pixels, squares * pixels};
    for (std::size_t y = 0; y < result.height; ++y)
        for (std::size_t x = 0; x < result.width; ++x) {
            const std::size_t column = x / pixels, row = squares - 1 - y / pixels;
            if (column + row == 0)
                result.pixels.push_back({200, 60, 50, 255});
            else if ((column + row) % 2 == 0)
                result.pixels.push_back({70, 110, 160, 255});
            else
                result.pixels.push_back({235, 235, 235, 255});
        }
    return result;
}

std::shared_ptr<const picture::image> texture_in(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    if (not file)
        throw io::file_error(path + ": cannot be opened");
    try {
        return std::make_shared<const picture::image>(picture::read_png(file));
    } catch (const std::runtime_error& error) {
        throw io::file_error(path + ": " + error.what());
    }
}

bool has_texture(coloring by)
{
    return by == coloring::checker or by == coloring::texture;
}

void keep_textures(io::mesh_attributes& attributes)
{
    const io::held_attributes held = held_by(io::mesh_format::obj, attributes);
    io::mesh_attributes kept;
    for (const io::attribute* a : held.corner_textures)
        kept.corners.push_back(*a);
    for (const io::attribute* a : held.textures)
        kept.vertices.push_back(*a);
    attributes = std::move(kept);
    if (attributes.corners.empty() and attributes.vertices.empty())
        throw usage_error("--color: the file has no texture coordinates, which checker and texture need");
}

void give_texture(pictured_surface& surface, const color_request& request)
{
    const bool is_of_corners = not surface.attributes.corners.empty();
    const auto& attributes = is_of_corners ? surface.attributes.corners : surface.attributes.vertices;
    picture::surface& shape = surface.shape;
    shape.texture = request.texture;
    shape.corner_textures.resize(shape.corners.size());
    for (std::size_t c = 0; c < shape.corners.size(); ++c)
        for (std::size_t k = 0; k < 2; ++k)
            if (k < attributes.size()) // OBJ may have one coordinate
                shape.corner_textures[c][k] = float(attributes[k].values[is_of_corners ? c : shape.corners[c]]);
}

/// Returns the finite values of all surfaces, sorted.
std::vector<double> finite_values(const std::vector<shown_values>& all)
{
    std::vector<double> result;
    for (const auto& shown : all)
        std::ranges::copy_if(shown.values, std::back_inserter(result), [](double x) { return std::isfinite(x); });
    std::ranges::sort(result);
    return result;
}

std::string short_text(double value)
{
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.3g", value + 0.); // no -0
    return text.data();
}

/// A range of values and their colors.
struct scale {
    double least = 0, most = 1;
    picture::color (*color_of_share)(double) = picture::color_of_share;
    double first = 0; ///< the argument that stands for `least`; `most` is 1

    [[nodiscard]] picture::color color_of(double value) const
    {
        return color_of_share(first + (1 - first) * (value - least) / (most - least));
    }
    [[nodiscard]] picture::legend as_legend(std::string title) const
    {
        constexpr int steps = 4;
        picture::legend result{.title = std::move(title), .is_scale = true};
        for (int i = 0; i <= steps; ++i) {
            const double value = least + (most - least) * i / steps;
            result.entries.push_back({color_of(value), short_text(value)});
        }
        return result;
    }
};

/// Returns a scale from -x to x, where x is larger than the sizes of all but a twentieth of the values. The largest
/// values, near irregular vertices, would leave no color to the others.
scale signed_scale(const std::vector<double>& sorted)
{
    std::vector<double> sizes;
    for (const double x : sorted)
        sizes.push_back(std::abs(x));
    std::ranges::sort(sizes);
    double most = sizes.empty() ? 1 : sizes[sizes.size() - 1 - sizes.size() / 20];
    if (not(most > 0))
        most = 1;
    return {-most, most, picture::color_of_signed, -1};
}

scale plain_scale(const std::vector<double>& sorted)
{
    if (sorted.empty() or sorted.front() == sorted.back())
        return {sorted.empty() ? 0 : sorted.front() - .5, sorted.empty() ? 1 : sorted.front() + .5};
    return {sorted.front(), sorted.back()};
}

picture::legend list_of(const std::vector<double>& sorted, const std::vector<std::string>& labels, std::string title)
{
    picture::legend result{.title = std::move(title)};
    auto numbers = sorted;
    numbers.erase(std::ranges::unique(numbers).begin(), numbers.end());
    for (const double value : numbers) {
        const auto number = std::size_t(value);
        if (result.entries.size() == most_entries) {
            result.entries.push_back({picture::transparent, "..."});
            break;
        }
        result.entries.push_back(
            {picture::color_of_number(number), number < labels.size() ? labels[number] : std::to_string(number)});
    }
    return result;
}

} // namespace

color_request coloring_named(std::string_view word)
{
    if (word.starts_with(attribute_prefix))
        return {.by = coloring::attribute, .name = std::string(word.substr(attribute_prefix.size()))};
    if (word.starts_with(texture_prefix))
        return {.by = coloring::texture, .texture = texture_in(std::string(word.substr(texture_prefix.size())))};
    std::string known;
    for (const auto& [name, by] : words) {
        if (name == word)
            return {.by = by,
                    .texture = by == coloring::checker ? std::make_shared<const picture::image>(checker()) : nullptr};
        append_to_list(known, name);
    }
    throw usage_error("--color: '" + std::string(word) + "' is not one of " + known + ", attribute:NAME, texture:FILE");
}

void keep_colored(io::mesh_attributes& attributes, const color_request& request)
{
    if (has_texture(request.by)) {
        keep_textures(attributes);
        return;
    }
    std::string known;
    for (auto* of_elements : {&attributes.vertices, &attributes.faces}) {
        for (const io::attribute& a : *of_elements)
            append_to_list(known, a.name);
        const auto found = std::ranges::find(*of_elements, request.name, &io::attribute::name);
        std::vector<io::attribute> kept;
        if (request.by == coloring::attribute and found != of_elements->end())
            kept.push_back(std::move(*found));
        *of_elements = std::move(kept);
    }
    attributes.corners.clear();
    if (request.by == coloring::attribute and attributes.vertices.empty() and attributes.faces.empty())
        throw usage_error("--color: no vertex or face has an attribute '" + request.name + "'; " +
                          (known.empty() ? "the file has none" : "the attributes are " + known));
    if (not attributes.vertices.empty())
        attributes.faces.clear();
}

picture::legend give_colors(std::vector<pictured_surface>& surfaces, const color_request& request)
{
    if (request.by == coloring::plain)
        return {};
    if (request.by == coloring::reflection) {
        for (auto& surface : surfaces)
            surface.shape.light = picture::shading::reflection_lines;
        return {};
    }
    if (has_texture(request.by)) {
        for (auto& surface : surfaces)
            give_texture(surface, request);
        return {};
    }
    std::vector<shown_values> all;
    for (const auto& surface : surfaces)
        all.push_back(values_of(surface, request));
    const std::vector<double> sorted = finite_values(all);
    const bool are_signed = request.by == coloring::mean or request.by == coloring::gaussian;
    const bool are_numbers = request.by == coloring::parent or request.by == coloring::tile or
                             request.by == coloring::rank or request.by == coloring::level or
                             not all.front().labels.empty();
    const scale range = are_signed ? signed_scale(sorted) : plain_scale(sorted);
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        auto& colors = all[i].are_at_vertices ? surfaces[i].shape.vertex_colors : surfaces[i].shape.face_colors;
        for (const double value : all[i].values)
            colors.push_back(not std::isfinite(value) ? without_value
                             : are_numbers            ? picture::color_of_number(std::size_t(value))
                                                      : range.color_of(value));
    }
    switch (request.by) {
    case coloring::parent: return {};
    case coloring::tile: return list_of(sorted, {}, "tile");
    case coloring::rank: return list_of(sorted, {}, "rank");
    case coloring::level: return list_of(sorted, {}, "level");
    case coloring::mean: return range.as_legend("mean");
    case coloring::gaussian: return range.as_legend("Gaussian");
    default: return are_numbers ? list_of(sorted, all.front().labels, request.name) : range.as_legend(request.name);
    }
}

} // namespace kith::tool
