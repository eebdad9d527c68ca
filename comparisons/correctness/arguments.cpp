// SPDX-License-Identifier: BSD-3-Clause
#include "arguments.hpp"

#include <boost/program_options.hpp>

#include <algorithm>
#include <iostream>
#include <limits>

namespace kith::comparison {

namespace {

namespace options = boost::program_options;

std::vector<std::filesystem::path> off_files(const std::filesystem::path& folder)
{
    std::vector<std::filesystem::path> result;
    if (std::filesystem::is_directory(folder))
        for (const auto& entry : std::filesystem::directory_iterator(folder))
            if (entry.path().extension() == ".off")
                result.push_back(entry.path());
    std::ranges::sort(result);
    return result;
}

} // namespace

std::optional<arguments> parse(int count, char** words, const std::string& what_it_does)
{
    constexpr std::size_t no_limit = std::numeric_limits<std::size_t>::max();
    options::options_description visible("Options");
    visible.add_options()("help", "this text")(
        "data", options::value<std::string>()->default_value(KITH_DATA_DIR), "the folder whose OFF files are taken")(
        "max-faces", options::value<std::size_t>()->default_value(no_limit, "all"), "leave out meshes with more faces")(
        "levels", options::value<int>()->default_value(2), "how often to refine");
    options::options_description all;
    all.add(visible).add_options()("file", options::value<std::vector<std::string>>());
    options::positional_options_description operands;
    operands.add("file", -1);
    options::variables_map values;
    store(options::command_line_parser(count, words).options(all).positional(operands).run(), values);
    notify(values);
    if (values.count("help")) {
        std::cout << "Usage: " << std::filesystem::path(words[0]).filename().string() << " [options] [FILE...]\n"
                  << what_it_does << "\nMeshes made by code, and FILE... (OFF, OBJ, PLY, STL) or the data.\n\n"
                  << visible;
        return std::nullopt;
    }
    arguments result{{}, values["max-faces"].as<std::size_t>(), values["levels"].as<int>()};
    if (result.levels < 1)
        throw options::error("--levels: 1 or more");
    if (values.count("file"))
        for (const auto& file : values["file"].as<std::vector<std::string>>())
            result.files.emplace_back(file);
    else
        result.files = off_files(values["data"].as<std::string>());
    return result;
}

} // namespace kith::comparison
