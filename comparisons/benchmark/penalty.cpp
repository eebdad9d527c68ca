// SPDX-License-Identifier: BSD-3-Clause
#include "by_hand.hpp"
#include "contest_report.hpp"
#include "contests.hpp"
#include "correctness/exit_code.hpp"

#include <boost/program_options.hpp>

#include <cstring>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

/// The cost of the abstraction: kith's schemes against the same schemes written by hand on raw arrays.
namespace {

using namespace kith::comparison;

namespace options = boost::program_options;

bool same_bits(const auto& a, const auto& b)
{
    return a.size() == b.size() and std::memcmp(a.data(), b.data(), a.size() * sizeof(*a.data())) == 0;
}
bool same(const by_hand::mesh& a, const by_hand::mesh& b)
{
    const auto &s = a.topology(), &t = b.topology();
    return same_bits(a.points(), b.points()) and same_bits(s.corner_vertex, t.corner_vertex) and
           same_bits(s.corner_halfedge, t.corner_halfedge) and same_bits(s.halfedge_corner, t.halfedge_corner) and
           same_bits(s.vertex_corner, t.vertex_corner);
}

/// Adds the contests of a scheme: to the last level with all connectivity, and with face lists only. Errors:
/// std::logic_error if both ways do not lead to the same bits, since their times could not be compared then.
template <class Scheme, class Step>
void add(std::vector<contest>& list, const Scheme& scheme, double target, const Step& step)
{
    const auto course = courses(scheme, {.faces_target = target}).front();
    for (const bool complete : {true, false}) {
        const auto last = complete ? kith::connect::everything : kith::connect::faces;
        if (not same(by_hand::refine(*course.control, 3, complete, step),
                     kith::refine(*course.control, scheme, 3, {last})))
            throw std::logic_error(std::string(kith::scheme_name<Scheme>()) + ": by hand something else comes out");
        const auto raw = [=]() -> work {
            return [=] {
                return std::make_shared<by_hand::mesh>(by_hand::refine(*course.control, course.levels, complete, step));
            };
        };
        const std::string what = complete ? "" : ", faces only";
        list.push_back({std::string(kith::scheme_name<Scheme>()),
                        course.name,
                        course.levels,
                        course.faces,
                        {{"by hand" + what, raw, {}},
                         native_contestant("scheme text" + what, course.control, scheme, course.levels, last)}});
    }
}

void run_all(double target, int repeats)
{
    std::vector<contest> contests;
    add(contests, kith::catmull_clark{}, target, [](const by_hand::mesh& coarse, bool complete) {
        return complete ? by_hand::catmull_clark_step<true>(coarse) : by_hand::catmull_clark_step<false>(coarse);
    });
    std::vector<double> beta(100);
    for (std::size_t n = 3; n < beta.size(); ++n)
        beta[n] = kith::loop{}.beta(n);
    add(contests, kith::loop{}, target, [beta](const by_hand::mesh& coarse, bool complete) {
        return complete ? by_hand::loop_step<true>(coarse, beta.data())
                        : by_hand::loop_step<false>(coarse, beta.data());
    });
    print(machine());
    for (auto& contest : contests) {
        run(contest, repeats);
        print(contest);
    }
}

} // namespace

int main(int count, char** words)
{
    return exit_code_of([&] {
        options::options_description all("Options");
        all.add_options()("help", "this text")(
            "faces-target", options::value<double>()->default_value(4718592), "about how many faces to refine to")(
            "repeats", options::value<int>()->default_value(7), "runs of each in turn; medians are printed");
        options::variables_map values;
        store(options::parse_command_line(count, words, all), values);
        notify(values);
        if (values.count("help")) {
            std::cout << "Usage: penalty [options]\nRefines by the text of a scheme and by the same scheme written by "
                         "hand on raw arrays, in turn.\n\n"
                      << all;
            return;
        }
        if (values["repeats"].as<int>() < 1 or values["faces-target"].as<double>() < 1)
            throw options::error("--repeats and --faces-target are 1 or more");
        run_all(values["faces-target"].as<double>(), values["repeats"].as<int>());
    });
}
