// SPDX-License-Identifier: BSD-3-Clause
#include "golden.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>

namespace golden {

namespace {

/// Returns a sharpness. The files contain the string "inf" for infinite sharpness, which JSON numbers cannot express.
double read_sharpness(const nlohmann::json& text)
{
    return text.is_string() ? std::numeric_limits<double>::infinity() : text.get<double>();
}

level read_level(const nlohmann::json& text)
{
    level result;
    text.at("counts").get_to(result.counts);
    text.at("boundary_edges").get_to(result.boundary_edges);
    text.at("vertices").get_to(result.vertices);
    text.at("faces").get_to(result.faces);
    const auto list = [&text](const char* name) { return text.value(name, nlohmann::json::array()); };
    for (const auto& entry : list("keys")) {
        auto& key = result.keys.emplace_back();
        entry.at(0).get_to(key.kind);
        for (std::size_t i = 1; i < entry.size(); ++i)
            key.numbers.push_back(entry.at(i));
    }
    for (const auto& [a, b, sharpness] : list("creases").get<std::vector<std::array<nlohmann::json, 3>>>())
        result.creases.push_back({a, b, read_sharpness(sharpness)});
    for (const auto& [v, sharpness] : list("corners").get<std::vector<std::array<nlohmann::json, 2>>>())
        result.corners.push_back({v, read_sharpness(sharpness)});
    list("marked_edges").get_to(result.marked_edges);
    for (const auto& point : list("limit_points")) {
        result.limit_points.emplace_back();
        if (not point.is_null())
            point.get_to(result.limit_points.back().emplace());
    }
    result.min_vertex_distance = text.value("min_vertex_distance", 0.);
    return result;
}

file read(const std::filesystem::path& path)
{
    std::ifstream in(path);
    const auto text = nlohmann::json::parse(in);
    const auto& convention = text.at("convention");
    file result{.name = path.stem(),
                .corner_rule = convention.value("corner_rule", ""),
                .weights = convention.value("weights", ""),
                .boundary = convention.value("boundary", ""),
                .crease_method = convention.value("crease_method", ""),
                .degree = convention.value("degree", 0),
                .levels = {}};
    for (std::size_t i = 0; text.contains("level" + std::to_string(i)); ++i)
        result.levels.push_back(read_level(text.at("level" + std::to_string(i))));
    return result;
}

} // namespace

std::vector<file> files_of(const std::string& scheme)
{
    std::vector<file> result;
    for (const auto& entry : std::filesystem::directory_iterator(KITH_TEST_DIR "/golden"))
        if (entry.path().filename().string().starts_with(scheme + "__"))
            result.push_back(read(entry.path()));
    if (result.empty())
        throw std::runtime_error("no golden files of " + scheme);
    std::ranges::sort(result, {}, &file::name);
    return result;
}

} // namespace golden
