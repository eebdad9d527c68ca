// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.hpp"

#include "errors.hpp"
#include "terminal.hpp"

#include <kith/io/format/mesh_format.hpp>

#include <boost/program_options/parsers.hpp>
#include <boost/program_options/positional_options.hpp>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <iostream>

namespace kith::tool {

namespace po = boost::program_options;

namespace {

/// Returns the arguments with `--weld 0.1` joined to `--weld=0.1`. Boost gives an optional value to an option only in
/// the joined form.
std::vector<std::string> with_joined_distance(const std::vector<std::string>& arguments)
{
    std::vector<std::string> result;
    for (const auto& argument : arguments)
        if (not result.empty() and result.back() == "--weld" and number_in(argument))
            result.back() += "=" + argument;
        else
            result.push_back(argument);
    return result;
}

} // namespace

std::optional<po::variables_map> parse(const verb& verb, po::options_description options,
                                       const std::vector<std::string>& operands,
                                       const std::vector<std::string>& arguments)
{
    add_flag(options, "help,h", "print this help and exit");
    add_flag(options, "version", "print the version and exit");
    po::options_description all;
    all.add(options);
    po::positional_options_description positions;
    const auto is_optional = [](const std::string& operand) { return operand.starts_with('['); };
    for (const auto& operand : operands) {
        if (operand.ends_with("...")) {
            all.add_options()(operand.c_str(), po::value<std::vector<std::string>>());
            positions.add(operand.c_str(), -1);
            continue;
        }
        const std::string name = is_optional(operand) ? operand.substr(1, operand.size() - 2) : operand;
        all.add_options()(name.c_str(), po::value<std::string>());
        positions.add(name.c_str(), 1);
    }
    po::variables_map values;
    try {
        const int style = po::command_line_style::unix_style & ~po::command_line_style::allow_guessing;
        po::store(po::command_line_parser(with_joined_distance(arguments))
                      .options(all)
                      .positional(positions)
                      .style(style)
                      .run(),
                  values);
    } catch (const po::error& error) {
        if (std::string(error.what()).find("too many positional") != std::string::npos)
            throw usage_error("too many operands; at most " + std::to_string(operands.size()) + " can be given");
        throw usage_error(error.what());
    }
    if (values.count("version") != 0) {
        print_version(verb.program);
        return std::nullopt;
    }
    if (values.count("help") != 0) {
        std::cout << verb.program << ' ' << verb.name;
        for (const auto& operand : operands)
            std::cout << ' ' << operand;
        std::cout << " [options]\n" << verb.summary << "\n\n" << options << "\n" << verb.examples;
        return std::nullopt;
    }
    for (const auto& operand : operands)
        if (not is_optional(operand) and values.count(operand) == 0)
            throw usage_error(operand + " is missing");
    allow_progress(values.count("json") == 0);
    return values;
}

void print_version(std::string_view program)
{
    std::cout << program << ' ' << KITH_VERSION << '\n';
}

std::string required(const po::variables_map& values, const std::string& name)
{
    if (values.count(name) == 0)
        throw usage_error(name + " is missing");
    return values[name].as<std::string>();
}

std::string output_of(const po::variables_map& values)
{
    const std::string output = required(values, "output");
    if (output.empty())
        throw file_error("the output has no name; name a file with -o");
    const auto path = [](const std::string& name) { return std::filesystem::path(name).lexically_normal(); };
    if (values.count("stats") != 0 and path(required(values, "stats")) == path(output))
        throw usage_error("--stats: " + output + " is the output; name another file");
    return output;
}

bool is_binary_from(const po::variables_map& values, const std::string& output)
{
    const bool is_binary = values.count("binary") != 0;
    if (is_binary and not io::contents_of(io::output_format_of(output)).binary)
        throw usage_error("--binary: only PLY and STL are either text or binary; leave it out for " + output);
    return is_binary;
}

int levels_of(const po::variables_map& values)
{
    if (values.count("levels") == 0)
        throw usage_error("--levels is missing");
    const int levels = values["levels"].as<int>();
    if (levels < 0)
        throw usage_error("--levels: " + std::to_string(levels) + " levels were asked for; ask for 0 or more");
    return levels;
}

std::uint64_t count_from(const po::variables_map& values, const std::string& option, std::int64_t most)
{
    const auto count = values.count(option) != 0 ? values[option].as<std::int64_t>() : 1;
    const std::string noun = option == "tiles-per-rank" ? "tiles per rank" : option;
    if (count < 1 or count > most)
        throw usage_error("--" + option + ": " + std::to_string(count) + " " + noun +
                          " were asked for; ask for 1 or more" +
                          (most == INT64_MAX ? "" : ", up to " + std::to_string(most)));
    return std::uint64_t(count);
}

std::optional<double> number_in(std::string_view text)
{
    double value = 0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value);
    if (text.empty() or error != std::errc() or rest != end or not std::isfinite(value))
        return std::nullopt;
    return value;
}

std::uint64_t bytes_from(const std::string& text)
{
    double value = 0;
    const char* const end = text.data() + text.size();
    auto [rest, error] = std::from_chars(text.data(), end, value, std::chars_format::fixed);
    double unit = 1;
    if (error == std::errc() and rest != end) {
        const auto power = std::string_view("KMGT").find(*rest++);
        unit = power == std::string_view::npos ? 0 : std::pow(1024., double(power + 1));
    }
    const double bytes = value * unit;
    if (error != std::errc() or rest != end or not(bytes >= 1 and bytes < 1e19))
        throw usage_error("'" + text + "' is not a number of bytes; write e.g. 500M or 1.5G");
    return std::uint64_t(bytes);
}

} // namespace kith::tool
