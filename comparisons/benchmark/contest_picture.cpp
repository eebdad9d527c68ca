// SPDX-License-Identifier: BSD-3-Clause
#include "contest_picture.hpp"

#include <kith/io/text/file_error.hpp>
#include <kith/picture/plot.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string_view>

namespace kith::comparison {

namespace {

using picture::color;

double nanoseconds_per_face(const std::vector<measurement>& runs, double measurement::* seconds, std::uint64_t faces)
{
    return 1e9 * median(runs, [&](const measurement& run) { return run.*seconds; }) / double(faces);
}

bool is_ours(std::string_view contestant)
{
    return contestant.starts_with("kith");
}

picture::bar_chart bars_of(const contest& contest)
{
    picture::bar_chart chart{contest.scheme + ", " + contest.mesh + ", " + std::to_string(contest.faces) + " faces",
                             " ns"};
    for (const auto& contestant : contest.contestants)
        chart.bars.push_back({contestant.name,
                              nanoseconds_per_face(contestant.runs, &measurement::seconds, contest.faces),
                              is_ours(contestant.name) ? color{.12F, .47F, .71F} : picture::gray});
    return chart;
}

/// The nanoseconds per face of a contestant's runs, by numbers of faces or of threads. A contestant may take part in
/// several contests.
struct runs_by_number {
    std::string contestant;
    std::map<std::uint64_t, std::vector<measurement>> runs{};
    std::map<std::uint64_t, std::uint64_t> faces{}; ///< of the last level
};

/// Returns the runs of all contestants of one scheme, in the order of their first appearance.
std::vector<runs_by_number> runs_of(const std::string& scheme, const std::vector<contest>& contests, curves_over over)
{
    std::vector<runs_by_number> result;
    for (const auto& contest : contests)
        if (contest.scheme == scheme)
            for (const auto& contestant : contest.contestants) {
                auto found = std::ranges::find(result, contestant.name, &runs_by_number::contestant);
                if (found == result.end())
                    found = result.insert(result.end(), {contestant.name});
                const auto number = over == curves_over::faces ? contest.faces : std::uint64_t(contestant.threads);
                found->faces[number] = contest.faces;
                auto& all = found->runs[number];
                all.insert(all.end(), contestant.runs.begin(), contestant.runs.end());
            }
    return result;
}

picture::plot curves_of(const std::string& scheme, const std::vector<contest>& contests, curves_over over)
{
    static constexpr std::array theirs{color{.53F, .53F, .53F},
                                       color{.73F, .6F, .27F},
                                       color{.27F, .67F, .47F},
                                       color{.67F, .4F, .53F},
                                       color{.73F, .73F, .73F},
                                       color{.47F, .4F, .33F},
                                       color{.79F, .54F, .54F}};
    static constexpr std::array ours{color{.12F, .47F, .71F},
                                     color{.84F, .15F, .16F},
                                     color{.5F, .25F, .75F},
                                     color{.09F, .64F, .72F},
                                     color{1, .5F, .05F},
                                     color{.17F, .63F, .17F}};
    picture::plot plot{.title = scheme,
                       .x = {over == curves_over::faces ? "faces of the last level" : "threads", true},
                       .y = {"nanoseconds per face", true},
                       .notes = {"dashed: first in a process", "solid: the same again"}};
    std::size_t our_next = 0, their_next = 0;
    for (const auto& [contestant, runs, faces] : runs_of(scheme, contests, over)) {
        const color& paint = is_ours(contestant) ? ours[our_next++ % ours.size()]
                                                 : theirs[their_next++ % theirs.size()];
        for (const auto& [seconds, is_dashed] :
             {std::pair(&measurement::seconds, true), std::pair(&measurement::seconds_again, false)}) {
            picture::curve curve{contestant, {}, paint, is_dashed};
            for (const auto& [number, measured] : runs)
                curve.points.push_back({double(number), nanoseconds_per_face(measured, seconds, faces.at(number))});
            plot.curves.push_back(std::move(curve));
        }
    }
    return plot;
}

void write(const std::string& path, const std::map<std::string, std::string>& facts,
           const std::vector<picture::diagram>& diagrams)
{
    std::ofstream file(path);
    write_svg(file,
              diagrams,
              "Nanoseconds per face of the last level, medians; " + facts.at("processor") + ", " +
                  facts.at("compiler") + ' ' + facts.at("flags"));
    if (not file.flush())
        throw io::file_error(path + ": could not be written completely");
}

} // namespace

void write_bars(const std::string& path, const std::map<std::string, std::string>& facts,
                const std::vector<contest>& contests)
{
    std::vector<picture::diagram> diagrams;
    for (const auto& contest : contests)
        diagrams.emplace_back(bars_of(contest));
    write(path, facts, diagrams);
}

void write_curves(const std::string& path, const std::map<std::string, std::string>& facts,
                  const std::vector<contest>& contests, curves_over over)
{
    std::vector<std::string> schemes;
    std::vector<picture::diagram> diagrams;
    for (const auto& contest : contests)
        if (std::ranges::find(schemes, contest.scheme) == schemes.end()) {
            schemes.push_back(contest.scheme);
            diagrams.emplace_back(curves_of(contest.scheme, contests, over));
        }
    write(path, facts, diagrams);
}

} // namespace kith::comparison
