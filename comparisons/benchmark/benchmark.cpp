// SPDX-License-Identifier: BSD-3-Clause
#include "contest_picture.hpp"
#include "contest_report.hpp"
#include "contests.hpp"
#include "correctness/exit_code.hpp"

#include <kith/read_mesh.hpp>

#include <boost/program_options.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#if defined(_OPENMP)
#include <omp.h>
#endif

namespace {

using namespace kith::comparison;

namespace options = boost::program_options;

/// A peer that this program was built with.
struct peer {
    std::string name;
    std::string (*version)();
    std::vector<contest> (*contests)(const course_settings&);
    std::vector<contest> (*doors)(const course_settings&);
};
std::vector<contest> none(const course_settings&)
{
    return {};
}
const std::vector<peer> peers{
    {"cgal", cgal_version, cgal_contests, cgal_doors},
#if defined(KITH_WITH_OPENMESH)
    {"openmesh", openmesh_version, openmesh_contests, openmesh_doors},
#endif
#if defined(KITH_WITH_OPENSUBDIV)
    {"opensubdiv", opensubdiv_version, opensubdiv_contests, none},
#endif
    {"kith", kith_version, kith_contests, kith_doors},
};

bool is_in(const std::string& list, const std::string& word)
{
    std::istringstream words(list);
    for (std::string one; std::getline(words, one, ',');)
        if (one == word)
            return true;
    return false;
}

std::string all_peers()
{
    std::string result;
    for (const auto& peer : peers)
        result += (result.empty() ? "" : ",") + peer.name;
    return result;
}

/// Parses the command line. Returns no value after printing the help text for --help.
std::optional<options::variables_map> parse(int count, char** words)
{
    options::options_description all("Options");
    all.add_options()("help", "this text")("doors",
                                           "Catmull-Clark by the calls of users: in place with maps, with levels, "
                                           "values, tiles and limits")(
        "peers",
        options::value<std::string>()->default_value(all_peers()),
        "whom to compare with; kith: with writing memory, with itself on all "
        "threads and with creases, and all schemes")(
        "schemes",
        options::value<std::string>()->default_value("catmull-clark,loop,butterfly,doo-sabin,sqrt3,kobbelt,"
                                                     "nasri-hasbini,mid-edge,4-8"),
        "what to refine with")("meshes",
                               options::value<std::string>()->default_value("torus"),
                               "torus (closed), patch (bounded), or both: torus,patch")(
        "mesh", options::value<std::string>(), "refine this mesh, too: OFF, OBJ, PLY, STL")(
        "faces-target", options::value<double>()->default_value(4718592), "about how many faces to refine to")(
        "sizes", options::value<std::string>(), "or to each of these numbers of faces, as 1000,100000")(
        "repeats", options::value<int>()->default_value(5), "runs of each; medians are printed")(
        "threads",
        options::value<std::string>()->default_value("1"),
        "kith's threads, or several numbers of them, as 1,2,4; the peers have one")(
        "json", options::value<std::string>(), "write all runs to this file")(
        "plot",
        options::value<std::string>(),
        "draw the medians into this .svg: over sizes or threads, if several are given, else as bars");
    options::variables_map values;
    store(options::parse_command_line(count, words, all), values);
    notify(values);
    if (values.count("help")) {
        std::cout
            << "Usage: benchmark [options]\nRefines with other libraries and with kith, in turn, and compares time and "
               "memory.\n\n"
            << all;
        return std::nullopt;
    }
    if (values["repeats"].as<int>() < 1 or values["faces-target"].as<double>() < 1)
        throw options::error("--repeats and --faces-target are 1 or more");
    return values;
}

/// Returns the numbers of an option. Errors: options::error for an entry that is not a number of at least 1.
template <class Number>
std::vector<Number> numbers_from(const options::variables_map& values, const std::string& option)
{
    std::vector<Number> result;
    std::istringstream words(values[option].as<std::string>());
    for (std::string one; std::getline(words, one, ',');) {
        std::istringstream word(one);
        if (Number number = 0; word >> number and word.eof() and number >= 1)
            result.push_back(number);
        else
            throw options::error("--" + option + ": '" + one + "' is no number from 1 on; write them as 1,100");
    }
    return result;
}

/// Returns a contest for each number of threads, which contestants without a number of their own have.
std::vector<contest> on_threads(const std::vector<contest>& contests, const std::vector<int>& threads)
{
    std::vector<contest> result;
    for (const contest& one : contests)
        for (const int count : threads) {
            result.push_back(one);
            if (threads.size() > 1)
                result.back().mesh += ", " + std::to_string(count) + " threads";
            for (auto& contestant : result.back().contestants)
                if (contestant.threads == 0)
                    contestant.threads = count;
        }
    return result;
}

course_settings settings_from(const options::variables_map& values)
{
    const auto meshes = values["meshes"].as<std::string>();
    course_settings result{.faces_target = values["faces-target"].as<double>(),
                           .torus = is_in(meshes, "torus"),
                           .patch = is_in(meshes, "patch")};
    if (values.count("mesh")) {
        const auto file = values["mesh"].as<std::string>();
        const auto soup = kith::io::read_mesh_file(file);
        result.mesh_name = std::filesystem::path(file).filename().string();
        result.mesh = std::make_shared<const kith::basic_mesh<>>(kith::make_mesh(soup.points, soup.faces));
    }
    return result;
}

void run_all(const options::variables_map& values)
{
#if defined(_OPENMP)
    omp_set_num_threads(1); // one thread only: this process forks
#endif
    auto settings = settings_from(values);
    const auto sizes = values.count("sizes") ? numbers_from<double>(values, "sizes")
                                             : std::vector{values["faces-target"].as<double>()};
    const auto threads = numbers_from<int>(values, "threads");
    if (sizes.size() > 1 and threads.size() > 1)
        throw options::error("--sizes and --threads: a plot is over one of them; give several numbers to one only");
    auto facts = machine();
    facts["threads of kith"] = values["threads"].as<std::string>();
    facts["runs"] = std::to_string(values["repeats"].as<int>()) + " of each in turn, medians";
    std::vector<contest> contests;
    for (const auto& peer : peers)
        if (is_in(values["peers"].as<std::string>(), peer.name)) {
            facts[peer.name] = peer.version();
            for (const double size : sizes) {
                settings.faces_target = size;
                std::ranges::move((values.count("doors") ? peer.doors : peer.contests)(settings),
                                  std::back_inserter(contests));
            }
        }
    std::erase_if(contests,
                  [&](const contest& one) { return not is_in(values["schemes"].as<std::string>(), one.scheme); });
    if (contests.empty())
        throw options::error("--peers, --schemes and --meshes: there is nothing that both name");
    contests = on_threads(contests, threads);
    print(facts);
    for (auto& contest : contests) {
        run(contest, values["repeats"].as<int>());
        print(contest);
    }
    if (values.count("json"))
        write_json(values["json"].as<std::string>(), facts, contests);
    if (not values.count("plot"))
        return;
    const auto plot = values["plot"].as<std::string>();
    if (sizes.size() > 1 or threads.size() > 1)
        write_curves(plot, facts, contests, sizes.size() > 1 ? curves_over::faces : curves_over::threads);
    else
        write_bars(plot, facts, contests);
}

} // namespace

int main(int count, char** words)
{
    return exit_code_of([&] {
        if (const auto values = parse(count, words))
            run_all(*values);
    });
}
