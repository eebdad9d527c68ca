// SPDX-License-Identifier: BSD-3-Clause
#include "schemes.hpp"

#include "holes.hpp"
#include "triangulate.hpp"
#include "cli/scheme_words.hpp"
#include "cli/word_list.hpp"

#include <kith/io/text/counted.hpp>
#include <kith/make_creases.hpp>
#include <kith/numbering/step/scheme.hpp>
#include <kith/tags_of_creases.hpp>

#include <algorithm>
#include <array>
#include <iostream>
#include <optional>

namespace kith::tool {

std::string schemes_with_creases()
{
    std::vector<std::string> names;
    std::apply(
        [&]<class... Schemes>(const scheme_entry<Schemes>&...) {
            ((scheme_with_creases<Schemes> ? void(names.emplace_back(scheme_name<Schemes>())) : void()), ...);
        },
        known_schemes);
    std::string result;
    for (const std::string& name : names)
        result += (result.empty() ? "" : name == names.back() ? " and " : ", ") + name;
    return result;
}

namespace {

template <class Scheme>
Scheme scheme_like(const std::string& preset)
{
    if (preset.empty())
        return {};
    try {
        return like<Scheme>(choice_from<library>("--preset", preset));
    } catch (const mesh_error& error) {
        throw usage_error("--preset " + preset + ": " + error.what());
    }
}

/// Sets the tension of a scheme, from which its other weights follow. The scheme itself checks which tensions it takes.
template <class Scheme>
void set_tension(Scheme& scheme, double tension)
{
    if constexpr (requires { scheme.tension; }) {
        scheme = Scheme{.tension = tension};
        try {
            scheme.require_weights();
        } catch (const mesh_error& error) {
            throw usage_error(std::string("--tension: ") + error.what());
        }
    } else {
        throw usage_error("--tension: " + std::string(scheme_name<Scheme>()) + " has no such option");
    }
}

template <class Scheme>
void set_degree(Scheme& scheme, int degree)
{
    if constexpr (requires { scheme.degree; }) {
        if (degree < 1 or degree > Scheme::max_degree)
            throw usage_error("--degree: " + std::to_string(degree) + " is not between 1 and " +
                              std::to_string(Scheme::max_degree));
        scheme.degree = degree;
    } else {
        throw usage_error("--degree: " + std::string(scheme_name<Scheme>()) + " has no such option");
    }
}

template <class Scheme>
void require_creases(const scheme_words& words)
{
    if (not words.crease_angle) {
        if (words.crease_sharpness)
            throw usage_error("--crease-sharpness: needs --crease-angle, which selects the edges");
        return;
    }
    if constexpr (not scheme_with_creases<Scheme>)
        throw usage_error("--crease-angle: " + std::string(scheme_name<Scheme>()) + " has no creases; only " +
                          schemes_with_creases() + " have them");
    if (not(*words.crease_angle >= 0 and *words.crease_angle <= 180))
        throw usage_error("--crease-angle: " + std::to_string(*words.crease_angle) +
                          " is not between 0 and 180 degrees");
    if (words.crease_sharpness and not(*words.crease_sharpness >= 0))
        throw usage_error("--crease-sharpness: " + std::to_string(*words.crease_sharpness) + " is not 0 or more");
}

template <class Scheme>
Scheme configured(const scheme_words& words)
{
    Scheme scheme = scheme_like<Scheme>(words.preset);
    if (words.tension)
        set_tension(scheme, *words.tension);
    if (words.degree)
        set_degree(scheme, *words.degree);
    require_creases<Scheme>(words);
    const std::array<std::pair<std::string_view, const std::string*>, 4> given{
        {{"--boundary-corners", &words.boundary_corners},
         {"--weights", &words.weights},
         {"--boundary", &words.boundary},
         {"--crease-method", &words.crease_method}}};
    for (const auto& [option, word] : given) {
        if (word->empty())
            continue;
        bool taken = false;
        for_each_option(scheme, [&]<class Choice>(std::string_view name, Choice& choice) {
            if (name == option) {
                choice = choice_from<Choice>(option, *word);
                taken = true;
            }
        });
        if (not taken)
            throw usage_error(std::string(option) + ": " + std::string(scheme_name<Scheme>()) + " has no such option");
    }
    return scheme;
}

/// Prints a note that names the first few tags that kith does not understand.
void note_unread(const mesh_tags& tags)
{
    constexpr std::size_t most_told = 4;
    std::string told;
    for (std::size_t i = 0; i < std::min(tags.unread.size(), most_told); ++i)
        append_to_list(told, "'" + tags.unread[i].name + "' in line " + std::to_string(tags.unread[i].line));
    if (tags.unread.size() > most_told)
        append_to_list(told, "...");
    if (not told.empty())
        std::cerr << "kith: note: " << counted(tags.unread.size(), "tag") << " of the file "
                  << (tags.unread.size() == 1 ? "is" : "are") << " not understood: " << told << '\n';
}

} // namespace

any_scheme make_scheme(const std::string& name, const scheme_words& words)
{
    std::optional<any_scheme> result;
    std::apply(
        [&]<class... Schemes>(const scheme_entry<Schemes>&...) {
            ((scheme_name<Schemes>() == name ? void(result = configured<Schemes>(words)) : void()), ...);
        },
        known_schemes);
    if (not result)
        throw usage_error("'" + name + "' is not a scheme; the schemes are " + scheme_names());
    return *result;
}

void give_creases(any_scheme& scheme, control_mesh& control, scheme_words& words)
{
    if (words.ignore_tags)
        control.tags = {};
    if (words.triangulate)
        control = triangulated(std::move(control));
    const mesh_tags& tags = control.tags;
    note_unread(tags);
    std::visit(
        [&]<class Scheme>(Scheme& s) {
            if constexpr (scheme_with_creases<Scheme>) {
                const auto method = s.sharpness.method;
                s.sharpness = creases_of(tags, control.mesh);
                if (words.crease_angle) {
                    const creases by_angle = creases_by_angle(
                        control.mesh, *words.crease_angle, words.crease_sharpness.value_or(infinitely_sharp));
                    for (const auto& [edge, sharpness] : by_angle.edges())
                        s.sharpness.sharpen_edge(edge, std::max(sharpness, s.sharpness.of_edge(edge)));
                }
                if (not words.crease_method.empty())
                    s.sharpness.method = method;
                if (tags.corners and words.preset.empty() and words.boundary_corners.empty()) {
                    s.corners = *tags.corners;
                    words.boundary_corners = word_of(s.corners);
                } else if (tags.corners and words.boundary_corners.empty() and *tags.corners != s.corners) {
                    std::cerr << "kith: note: --preset " << words.preset
                              << " overrides the rule of the file for boundary corners; to keep that rule, add "
                                 "--boundary-corners "
                              << word_of(*tags.corners) << '\n';
                }
            } else if (tags.has_creases() or not holes_of(tags, control.mesh).empty()) {
                throw mesh_error(std::string(scheme_name<Scheme>()) +
                                 " has no rules for the creases, corners or holes of the file; only " +
                                 schemes_with_creases() + " have them; use one of these, or --ignore-tags");
            }
        },
        scheme);
}

bool refines_along_seams(const any_scheme& scheme)
{
    return std::visit(
        []<class Scheme>(const Scheme&) { return scheme_with_sharp_rules<Scheme> or kith::detail::is_linear<Scheme>; },
        scheme);
}

sharp_elements sharp_after(const any_scheme& scheme, int levels)
{
    return std::visit(
        [&]<class Scheme>(const Scheme& s) {
            sharp_elements result;
            if constexpr (scheme_with_creases<Scheme>) {
                const auto is_left = [&](const auto& sharp) { return sharp.second > levels; };
                result.edges = std::size_t(std::ranges::count_if(s.sharpness.edges(), is_left));
                result.vertices = std::size_t(std::ranges::count_if(s.sharpness.vertices(), is_left));
            }
            return result;
        },
        scheme);
}

void tell_next_step(control_mesh& control, const any_scheme& scheme, int levels)
{
    if (is_prepared(scheme))
        control.not_kept.emplace_back("the edges that 4-8 splits next");
    const bool is_odd = (control.mesh.generation() + levels) % 2 != 0;
    if (std::holds_alternative<sqrt3>(scheme) and is_odd and count(control.mesh.topology()).boundary_edges != 0)
        control.attributes.file_lines.emplace_back(odd_generation);
}

void add_boundary_tag(io::mesh_tags& tags, const any_scheme& scheme)
{
    std::visit(
        [&]<class Scheme>(const Scheme& s) {
            if constexpr (scheme_with_sharp_rules<Scheme>)
                if (s.corners != Scheme().corners)
                    tags.corners = s.corners;
        },
        scheme);
}

void add_lost_boundary_rule(std::vector<std::string>& lost, const io::mesh_tags& given, const any_scheme& scheme)
{
    io::mesh_tags needed;
    add_boundary_tag(needed, scheme);
    if (given.corners and needed.corners and not given.boundary_is_hole)
        lost.emplace_back("the rule for boundary corners");
}

void require_scheme_takes(const any_scheme& scheme, const basic_mesh<>& control)
{
    std::visit(
        [&]<class Scheme>(const Scheme& one) {
            try {
                require_input(one, level_of<basic_mesh<>>(control), control.generation());
            } catch (const mesh_error& error) {
                const int degree = control.topology().degree;
                const char* more = "";
                if (needs_triangles<Scheme> and degree != 3)
                    more = ", with --triangulate";
                else if (needs_quads<Scheme> and degree != 4)
                    more = ": `kith refine IN -s linear -n 1 -o QUADS.off`";
                else if (needs_closed<Scheme> and count(control.topology()).boundary_edges != 0)
                    more = " such as catmull-clark or loop; kith fills no holes";
                throw mesh_error(std::string(error.what()) + more);
            }
        },
        scheme);
}

basic_mesh<> prepared(const any_scheme& scheme, basic_mesh<> control, attribute_fields& attributes)
{
    const auto prepare_for = [&]<class Scheme>(const scheme_entry<Scheme>& entry) {
        if (std::holds_alternative<Scheme>(scheme) and entry.prepare != nullptr)
            control = entry.prepare(control, attributes);
    };
    std::apply([&](const auto&... entry) { (prepare_for(entry), ...); }, known_schemes);
    return control;
}

basic_mesh<> prepared(const any_scheme& scheme, basic_mesh<> control)
{
    attribute_fields none;
    return prepared(scheme, std::move(control), none);
}

bool is_prepared(const any_scheme& scheme)
{
    return std::apply(
        [&]<class... Schemes>(const scheme_entry<Schemes>&... entry) {
            return ((std::holds_alternative<Schemes>(scheme) and entry.prepare != nullptr) or ...);
        },
        known_schemes);
}

std::string scheme_names()
{
    std::string result;
    std::apply([&]<class... Schemes>(
                   const scheme_entry<Schemes>&...) { (append_to_list(result, scheme_name<Schemes>()), ...); },
               known_schemes);
    return result;
}

std::vector<std::string_view> schemes_that_take(const control_mesh& control)
{
    const bool has_tags = control.tags.has_creases() or not holes_of(control.tags, control.mesh).empty();
    std::vector<std::string_view> result;
    const auto look_at = [&]<class Scheme>(const scheme_entry<Scheme>& entry) {
        if (has_tags and not scheme_with_creases<Scheme>)
            return;
        try {
            attribute_fields none;
            const basic_mesh<> first = entry.prepare == nullptr ? basic_mesh<>() : entry.prepare(control.mesh, none);
            const basic_mesh<>& mesh = entry.prepare == nullptr ? control.mesh : first;
            require_input(Scheme(), level_of<basic_mesh<>>(mesh), mesh.generation());
            result.push_back(scheme_name<Scheme>());
        } catch (const mesh_error&) {
            return; // it does not take the mesh
        }
    };
    std::apply([&](const auto&... entry) { (look_at(entry), ...); }, known_schemes);
    return result;
}

std::string not_in_tiles(std::string_view scheme, bool is_closed_only)
{
    return std::string(scheme) + " is not refined in tiles: " +
           (is_closed_only ? "it takes closed meshes only, and a tile has a boundary"
                           : "a tile does not know how many triangles come before its own");
}

} // namespace kith::tool
