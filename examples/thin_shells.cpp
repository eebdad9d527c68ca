// SPDX-License-Identifier: BSD-3-Clause
// Computes thin shells by finite elements on limit surfaces, as Cirak, Ortiz & Schröder (2000) introduced them. The
// basis functions are those of Catmull-Clark and of Loop, on the shell obstacle course of Belytschko et al. (1985). The
// program fails unless the displacements of the finest level are close enough to those of the literature.
// Sample run: thin_shells [levels, 1 to 5] [plot.svg]

#include "thin_shells/obstacle_course.hpp"

#include <kith/picture/plot.hpp>

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
void draw(const char* file, const std::vector<course_result>& results)
{
    constexpr std::array<kith::picture::color, 3> colors{{{.12F, .38F, .55F}, {.69F, .23F, .18F}, {.49F, .4F, .03F}}};
    kith::picture::plot plot{.title = "Displacement over reference",
                             .x = {"unknowns", true},
                             .y = {},
                             .band = {{.99, 1.01}},
                             .notes = {"solid: Catmull-Clark", "dashed: Loop", "green: within 1 %"}};
    for (std::size_t i = 0; i < results.size(); ++i) {
        kith::picture::curve curve{results[i].problem, {}, colors[i % 3], i >= 3};
        for (std::size_t level = 0; level < results[i].ratios.size(); ++level)
            curve.points.push_back({results[i].unknowns[level], results[i].ratios[level]});
        plot.curves.push_back(std::move(curve));
    }
    std::ofstream svg(file);
    kith::picture::write_svg(svg, {plot});
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
        draw(words[2], results);
    constexpr std::array tolerances{.5, .04, .01, .01, .01};
    return std::ranges::all_of(results,
                               [&](const course_result& result) {
                                   return std::abs(result.ratios.back() - 1) < tolerances[std::size_t(levels - 1)];
                               })
               ? 0
               : 1;
}
