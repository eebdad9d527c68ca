// SPDX-License-Identifier: BSD-3-Clause
#include "contest_report.hpp"

#include "cli/json.hpp"

#include <kith/io/text/file_error.hpp>

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <thread>

namespace kith::comparison {

namespace {

double seconds(const measurement& run)
{
    return run.seconds;
}
double seconds_again(const measurement& run)
{
    return run.seconds_again;
}
double processor_seconds(const measurement& run)
{
    return run.processor_seconds;
}
double bytes(const measurement& run)
{
    return double(run.bytes);
}

/// Returns the text after "NAME : " in /proc/cpuinfo, for the first processor.
std::string processor(const std::string& name)
{
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.starts_with(name))
            if (const auto colon = line.find(": "); colon != line.npos)
                return line.substr(colon + 2);
    return "unknown";
}

std::string first_line(const std::string& path)
{
    std::ifstream file(path);
    std::string line;
    return std::getline(file, line) ? line : "unknown";
}

} // namespace

std::map<std::string, std::string> machine()
{
    return {{"processor",
             processor("model name") + ", family " + processor("cpu family") + ", model " + processor("model\t")},
            {"processors", std::to_string(std::thread::hardware_concurrency())},
            {"cache", processor("cache size")},
            {"huge pages", first_line("/sys/kernel/mm/transparent_hugepage/enabled")},
#if defined(__clang__)
            {"compiler", "clang " __clang_version__},
#else
            {"compiler", "g++ " __VERSION__},
#endif
            {"flags", KITH_BENCHMARK_FLAGS}};
}

void print(const std::map<std::string, std::string>& facts)
{
    for (const auto& [name, fact] : facts)
        std::cout << name << ": " << fact << '\n';
    std::cout << std::endl;
}

void print(const contest& contest)
{
    std::cout << contest.scheme << ", " << contest.mesh << ", " << contest.levels << " levels, " << contest.faces
              << " faces\n"
              << std::fixed;
    const auto& first = contest.contestants.front();
    const double faces = double(contest.faces);
    for (const auto& contestant : contest.contestants) {
        const double time = median(contestant.runs, seconds), again = median(contestant.runs, seconds_again);
        std::cout << "  " << std::left << std::setw(32) << contestant.name << std::right << std::setprecision(1)
                  << std::setw(8) << 1e9 * time / faces << " ns, again" << std::setw(8) << 1e9 * again / faces << " ns"
                  << std::setprecision(0) << std::setw(6) << median(contestant.runs, bytes) / faces << " B";
        if (&contestant != &first) {
            std::vector<double> ratios;
            for (std::size_t i = 0; i < contestant.runs.size(); ++i)
                ratios.push_back(first.runs[i].seconds / contestant.runs[i].seconds);
            const auto [least, most] = std::ranges::minmax(ratios);
            std::cout << std::setprecision(2) << std::setw(8) << median(first.runs, seconds) / time
                      << " times as fast (" << least << ".." << most << "), again "
                      << median(first.runs, seconds_again) / again;
        }
        if (const double processor = median(contestant.runs, processor_seconds); time > 1.1 * processor)
            std::cout << "  busy machine: " << std::setprecision(1) << 1e9 * processor / faces
                      << " ns on the processor";
        std::cout << '\n';
    }
    std::cout << std::endl;
}

void write_json(const std::string& path, const std::map<std::string, std::string>& facts,
                const std::vector<contest>& contests)
{
    auto results = tool::json::array();
    for (const auto& contest : contests)
        for (const auto& contestant : contest.contestants) {
            std::vector<double> seconds, seconds_again, processor_seconds;
            std::vector<std::uint64_t> bytes;
            for (const auto& run : contestant.runs) {
                seconds.push_back(run.seconds);
                seconds_again.push_back(run.seconds_again);
                processor_seconds.push_back(run.processor_seconds);
                bytes.push_back(run.bytes);
            }
            results.push_back({{"scheme", contest.scheme},
                               {"mesh", contest.mesh},
                               {"levels", contest.levels},
                               {"faces", contest.faces},
                               {"peer", contest.contestants.front().name},
                               {"contestant", contestant.name},
                               {"seconds", seconds},
                               {"seconds_again", seconds_again},
                               {"processor_seconds", processor_seconds},
                               {"peak_bytes", bytes}});
        }
    std::ofstream file(path);
    file << tool::text_of(tool::json{{"about", facts}, {"results", results}}) << '\n';
    if (not file.flush())
        throw io::file_error(path + ": could not be written completely");
}

} // namespace kith::comparison
