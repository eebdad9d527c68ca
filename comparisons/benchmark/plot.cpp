// SPDX-License-Identifier: BSD-3-Clause
// Draws plots that a script describes in JSON on standard input: plot OUT.svg. Example:
// {"note": "two processors", "plots": [{"title": "one surface",
//   "x": {"title": "ranks", "is_logarithmic": true}, "y": {"title": "seconds", "is_logarithmic": true},
//   "curves": [{"name": "job", "points": [[1, 3.8], [2, 2.3]], "is_dashed": false}]}]}
#include "correctness/exit_code.hpp"

#include <kith/output_file.hpp>
#include <kith/picture/plot.hpp>

#include <nlohmann/json.hpp>

#include <iostream>
#include <vector>

namespace {

using namespace kith;
using json = nlohmann::json;

picture::axis axis_of(const json& told)
{
    return {told.at("title"), told.at("is_logarithmic")};
}

picture::plot plot_of(const json& told)
{
    picture::plot result{.title = told.at("title"), .x = axis_of(told.at("x")), .y = axis_of(told.at("y"))};
    for (const json& curve : told.at("curves"))
        result.curves.push_back({curve.at("name"),
                                 curve.at("points"),
                                 curve.at("is_dashed") ? picture::gray : picture::color_of_number(result.curves.size()),
                                 curve.at("is_dashed")});
    return result;
}

} // namespace

int main(int count, char** words)
{
    return comparison::exit_code_of([&] {
        if (count != 2)
            throw boost::program_options::error("Usage: plot OUT.svg < plots.json");
        const json told = json::parse(std::cin);
        std::vector<picture::diagram> diagrams;
        for (const json& plot : told.at("plots"))
            diagrams.emplace_back(plot_of(plot));
        io::output_file file(words[1]);
        picture::write_svg(file.stream(), diagrams, told.at("note"));
        file.commit();
    });
}
