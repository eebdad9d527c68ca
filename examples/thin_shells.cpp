// SPDX-License-Identifier: BSD-3-Clause
// Computes thin shells by finite elements on limit surfaces, as Cirak, Ortiz & Schröder (2000) introduced them. The
// basis functions are those of Catmull-Clark and of Loop, on the shell obstacle course of Belytschko et al. (1985). The
// program fails unless the displacements of the finest level are close enough to those of the literature.
// Sample run: thin_shells [levels, 1 to 5] [plot.svg]

#include "thin_shells/obstacle_course.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

namespace {

using namespace thin_shells;

/// The displacements of a problem relative to the reference, level by level, and the numbers of unknowns.
struct course_result {
    std::string problem, scheme;
    std::vector<double> unknowns{}, ratios{};
};

template <class Scheme>
void run(const char* problem, const char* scheme, shell_problem (*at_level)(int), int levels,
         std::vector<course_result>& results)
{
    course_result& result = results.emplace_back(course_result{problem, scheme});
    for (int level = 0; level < levels; ++level) {
        const shell_problem here = at_level(level);
        const auto [displacement, unknowns] = shell_solver(here, Scheme()).solve();
        result.unknowns.push_back(double(unknowns));
        result.ratios.push_back(displacement / here.reference);
        std::printf("%-18s %-13s %d %7td  %.5e  %.4f\n",
                    problem,
                    scheme,
                    level,
                    unknowns,
                    displacement,
                    displacement / here.reference);
    }
}
template <class Scheme>
void run_course(const char* scheme, int levels, std::vector<course_result>& results)
{
    run<Scheme>("Scordelis-Lo roof", scheme, scordelis_lo_roof<Scheme>, levels, results);
    run<Scheme>("pinched cylinder", scheme, pinched_cylinder<Scheme>, levels, results);
    run<Scheme>("pinched hemisphere", scheme, pinched_hemisphere<Scheme>, levels, results);
}

/// Draws displacements over the number of unknowns; the curves of Loop are dashed.
void plot(const char* file, const std::vector<course_result>& results)
{
    std::ofstream svg(file);
    svg.precision(4);
    const auto x = [](double unknowns) { return 60 + 65 * (std::log2(unknowns) - std::log2(128)); };
    const auto y = [](double ratio) { return 30 + 360 * (1.05 - ratio); };
    svg << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 480 240\" font-family=\"sans-serif\" "
           "font-size=\"11\">\n<rect width=\"480\" height=\"240\" fill=\"white\"/>\n"
        << "<rect x=\"60\" y=\"" << y(1.01) << "\" width=\"400\" height=\"" << y(.99) - y(1.01)
        << "\" fill=\"#d5f5e3\"/>\n"
        << "<text x=\"60\" y=\"18\">displacement / reference; green: within 1 %; dashed: Loop</text>\n";
    for (const double ratio : {.6, .8, 1.})
        svg << "<text x=\"30\" y=\"" << y(ratio) + 4 << "\">" << ratio << "</text>\n";
    for (const int unknowns : {128, 512, 2048, 8192})
        svg << "<text x=\"" << x(unknowns) - 10 << "\" y=\"225\">" << unknowns << "</text>\n";
    svg << "<text x=\"380\" y=\"238\">unknowns</text>\n";
    constexpr std::array colors{"#1f618d", "#b03a2e", "#7d6608"};
    for (std::size_t i = 0; i < results.size(); ++i) {
        svg << "<polyline fill=\"none\" stroke=\"" << colors[i % 3] << "\" stroke-width=\"2\""
            << (i < 3 ? "" : " stroke-dasharray=\"5 3\"") << " points=\"";
        for (std::size_t level = 0; level < results[i].ratios.size(); ++level)
            svg << x(results[i].unknowns[level]) << ',' << y(results[i].ratios[level]) << ' ';
        svg << "\"/>\n";
        if (i < 3)
            svg << "<text x=\"330\" y=\"" << 110 + 16 * i << "\" fill=\"" << colors[i] << "\">" << results[i].problem
                << "</text>\n";
    }
    svg << "</svg>\n";
}

} // namespace

int main(int count, char** words)
{
    const int levels = count > 1 ? std::clamp(std::atoi(words[1]), 1, 5) : 3;
    std::vector<course_result> results;
    std::printf("problem            scheme     level unknowns displacement  /reference\n");
    run_course<kith::catmull_clark>("Catmull-Clark", levels, results);
    run_course<kith::loop>("Loop", levels, results);
    if (count > 2)
        plot(words[2], results);
    constexpr std::array tolerances{.5, .04, .01, .01, .01};
    return std::ranges::all_of(results,
                               [&](const course_result& result) {
                                   return std::abs(result.ratios.back() - 1) < tolerances[std::size_t(levels - 1)];
                               })
               ? 0
               : 1;
}
