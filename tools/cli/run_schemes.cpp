// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.hpp"
#include "json.hpp"
#include "scheme_words.hpp"
#include "job/schemes.hpp"

#include <kith/numbering/step/scheme.hpp>

#include <algorithm>
#include <cstddef>
#include <iomanip>
#include <iostream>

namespace kith::tool {

namespace {

struct scheme_line {
    std::string_view name;
    std::string_view takes;
    std::string_view source;
    std::vector<std::pair<std::string, std::string>> options; ///< names of options and their words
};

template <class Scheme>
scheme_line describe(const scheme_entry<Scheme>& entry)
{
    const std::string_view takes = entry.prepare != nullptr  ? "any polygons"
                                   : needs_triangles<Scheme> ? "triangles"
                                   : needs_quads<Scheme>     ? "quads"
                                   : needs_closed<Scheme>    ? "closed meshes"
                                                             : "any polygons";
    scheme_line result{scheme_name<Scheme>(), takes, entry.source, {}};
    Scheme scheme;
    for_each_option(scheme, [&]<class Choice>(const char* option, Choice&) {
        result.options.emplace_back(option, all_words<Choice>());
    });
    if constexpr (scheme_with_creases<Scheme>)
        result.options.emplace_back("--crease-angle", "a number of degrees");
    if constexpr (requires { scheme.tension; })
        result.options.emplace_back("--tension", "a number between 0 and 2.472");
    if constexpr (requires { scheme.degree; })
        result.options.emplace_back("--degree", "a number from 1 to 9");
    return result;
}

json as_json(const scheme_line& line)
{
    auto options = json::object();
    for (const auto& [option, words] : line.options)
        options[option] = words;
    return {{"name", line.name}, {"takes", line.takes}, {"source", line.source}, {"options", options}};
}

} // namespace

int run_schemes(const verb& verb, const std::vector<std::string>& arguments)
{
    boost::program_options::options_description options("Options");
    add_flag(options, "json", "print JSON");
    const auto values = parse(verb, options, {}, arguments);
    if (not values)
        return 0;
    const auto lines = std::apply([](const auto&... entry) { return std::vector{describe(entry)...}; }, known_schemes);
    if (values->count("json") != 0) {
        auto objects = json::array();
        for (const auto& line : lines)
            objects.push_back(as_json(line));
        std::cout << text_of(objects) << '\n';
        return 0;
    }
    std::size_t names = 0, kinds = 0;
    for (const auto& line : lines) {
        names = std::max(names, line.name.size() + 2);
        kinds = std::max(kinds, line.takes.size() + 2);
    }
    const auto column = [](std::size_t width) { return std::setw(int(width)); };
    for (const auto& line : lines) {
        std::cout << std::left << column(names) << line.name << column(kinds) << line.takes << line.source << '\n';
        for (const auto& [option, words] : line.options)
            std::cout << column(names) << "" << option << ' ' << words << '\n';
    }
    return 0;
}

} // namespace kith::tool
