// SPDX-License-Identifier: BSD-3-Clause
#include "recipe.hpp"

#include "cli/errors.hpp"
#include "cli/shortest_text.hpp"
#include "cli/scheme_words.hpp"

#include <kith/packed_mesh.hpp>
#include <kith/tiles/part/checksum.hpp>
#include <kith/tiles/refine/pack.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <utility>
#include <variant>

namespace kith::tool {

namespace {

constexpr std::uint64_t kind_of_recipe = 0x6b697468'72637034; // "kithrcp4", turned round on other machines

template <class Number>
std::string text_of(const std::optional<Number>& value)
{
    return value ? shortest_text(*value) : "";
}

/// Returns the words that choose the form of the scheme, with their names. Creases are kept with the control mesh.
std::array<std::pair<const char*, std::string>, 7> words_with_names(const scheme_words& words)
{
    return {{{"preset", words.preset},
             {"boundary-corners", words.boundary_corners},
             {"weights", words.weights},
             {"boundary", words.boundary},
             {"crease-method", words.crease_method},
             {"tension", text_of(words.tension)},
             {"degree", text_of(words.degree)}}};
}

const std::string& setting(const recipe& recipe, const std::string& name)
{
    for (const auto& [known, value] : recipe.settings)
        if (known == name)
            return value;
    throw file_error("the recipe has no " + name + "; another version of kith wrote it");
}

template <class Kinds, class F>
void for_each_element(Kinds& kinds, const F& f)
{
    f(kinds.vertices), f(kinds.faces), f(kinds.corners);
}

std::vector<std::byte> pack_control(const tile_request& request)
{
    packer out;
    io::pack_mesh(out, request.control);
    std::visit([&](const auto& s) { kith::detail::pack_state(out, s); }, request.scheme);
    out.add_array(pack_kinds(request.kinds));
    request.attributes.pack(out);
    return out.take();
}

/// Reads the control mesh that pack_control has written.
void unpack_control(const std::vector<std::byte>& bytes, tile_request& request)
{
    unpacker in(bytes);
    request.control = io::unpack_mesh<std::array<double, 3>, std::uint32_t>(in);
    std::visit([&](auto& s) { kith::detail::unpack_state(in, s); }, request.scheme);
    request.kinds = unpack_kinds(in.get_array<std::vector<std::byte>>());
    request.attributes.unpack(in);
}

void add_settings(packer& out, const recipe& recipe)
{
    for (const auto& [name, value] : recipe.settings)
        out.add_array(name).add_array(value);
}
/// Adds the data from which the surface and its tiles are made: the control mesh and the partition.
void add_mesh(packer& out, const recipe& recipe)
{
    out.add_array(recipe.control).add_array(recipe.parts.part_of).add(std::uint64_t(recipe.parts.parts));
}
std::string next_text(unpacker& in)
{
    const auto letters = in.get_array<std::vector<char>>();
    return {letters.begin(), letters.end()};
}

} // namespace

std::vector<std::byte> pack_kinds(const io::mesh_attributes& kinds)
{
    packer out;
    for_each_element(kinds, [&](const std::vector<io::attribute>& of_elements) {
        out.add(of_elements.size());
        for (const io::attribute& a : of_elements) {
            out.add_array(a.name).add(a.type.bytes).add(a.type.floating).add(a.type.is_signed).add(a.labels.size());
            for (const std::string& label : a.labels)
                out.add_array(label);
        }
    });
    out.add(kinds.file_lines.size());
    for (const std::string& file : kinds.file_lines)
        out.add_array(file);
    return out.take();
}

io::mesh_attributes unpack_kinds(const std::vector<std::byte>& bytes)
{
    unpacker in(bytes);
    io::mesh_attributes result;
    for_each_element(result, [&](std::vector<io::attribute>& of_elements) {
        for (auto left = in.get<std::size_t>(); left > 0; --left) {
            auto& a = of_elements.emplace_back();
            a.name = next_text(in);
            a.type.bytes = in.get<std::size_t>();
            a.type.floating = in.get<bool>();
            a.type.is_signed = in.get<bool>();
            for (auto labels = in.get<std::size_t>(); labels > 0; --labels)
                a.labels.push_back(next_text(in));
        }
    });
    for (auto files = in.get<std::size_t>(); files > 0; --files)
        result.file_lines.push_back(next_text(in));
    return result;
}

recipe recipe_of(const tile_request& request, partition parts)
{
    recipe result;
    result.settings = {{"version", KITH_VERSION},
                       {"scheme", request.scheme_name},
                       {"levels", std::to_string(request.levels)},
                       {"format", std::filesystem::path(request.output).extension().string()},
                       {"cell-origin", request.with_origin ? "yes" : "no"},
                       {"limit", request.limit ? "yes" : "no"},
                       {"uv", word_of(request.linear)},
                       {"repair", words_of(request.repair)}};
    for (const auto& [name, word] : words_with_names(request.words))
        result.settings.emplace_back(name, word);
    result.control = pack_control(request);
    result.parts = std::move(parts);
    result.output = request.output;
    return result;
}

tile_request request_from(const recipe& recipe)
{
    const auto word = [&](const char* name) { return setting(recipe, name); };
    tile_request result;
    result.scheme_name = word("scheme");
    result.words.preset = word("preset");
    result.words.boundary_corners = word("boundary-corners");
    result.words.weights = word("weights");
    result.words.boundary = word("boundary");
    result.words.crease_method = word("crease-method");
    if (const std::string tension = word("tension"); not tension.empty())
        result.words.tension = std::stod(tension);
    if (const std::string degree = word("degree"); not degree.empty())
        result.words.degree = std::stoi(degree);
    result.scheme = make_scheme(result.scheme_name, result.words);
    result.levels = std::stoi(word("levels"));
    result.output = recipe.output;
    result.with_origin = word("cell-origin") == "yes";
    result.limit = word("limit") == "yes";
    result.linear = choice_from<face_varying_linear>("uv", word("uv"));
    result.repair = repair_named(word("repair"));
    return result;
}

tile_request request_with_control(const recipe& recipe)
{
    tile_request result = request_from(recipe);
    unpack_control(recipe.control, result);
    return result;
}

std::vector<std::byte> pack_recipe(const recipe& recipe)
{
    packer out;
    out.add(kind_of_recipe).add(std::uint64_t(recipe.settings.size()));
    add_settings(out, recipe);
    out.add_array(recipe.output);
    add_mesh(out, recipe);
    auto bytes = out.take();
    const auto sum = packer().add(kith::detail::checksum_of_bytes(bytes)).take();
    bytes.insert(bytes.end(), sum.begin(), sum.end());
    return bytes;
}

recipe unpack_recipe(const std::vector<std::byte>& bytes)
{
    unpacker in(bytes);
    if (in.get<std::uint64_t>() != kind_of_recipe)
        throw pack_error("this is not a recipe, or another version of kith or kind of machine wrote it");
    recipe result;
    for (auto left = in.get<std::uint64_t>(); left > 0; --left) {
        auto name = next_text(in);
        result.settings.emplace_back(std::move(name), next_text(in));
    }
    result.output = next_text(in);
    result.control = in.get_array<std::vector<std::byte>>();
    result.parts.part_of = in.get_array<std::vector<std::uint32_t>>();
    result.parts.parts = in.get<std::uint64_t>();
    constexpr std::size_t sum_bytes = sizeof(std::uint64_t);
    const auto summed = std::span(bytes).first(bytes.size() - std::min(sum_bytes, bytes.size()));
    if (in.get<std::uint64_t>() != kith::detail::checksum_of_bytes(summed) or not in.is_at_end())
        throw pack_error("the recipe is damaged, its checksum is wrong");
    return result;
}

std::uint64_t checksum_of(const recipe& recipe)
{
    packer all;
    add_settings(all, recipe);
    add_mesh(all, recipe);
    return kith::detail::checksum_of_bytes(all.take());
}

std::string difference(const recipe& kept, const recipe& asked)
{
    for (const auto& [name, value] : asked.settings)
        if (setting(kept, name) != value)
            return "its " + name + " is '" + setting(kept, name) + "', not '" + value + "'";
    return kept.control == asked.control ? "" : "its control mesh, creases or attributes differ";
}

} // namespace kith::tool
