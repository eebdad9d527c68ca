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
        "threads", options::value<int>()->default_value(1), "kith's threads; the peers have one")(
        "json", options::value<std::string>(), "write all runs to this file")(
        "svg", options::value<std::string>(), "draw the medians into this file")(
        "curves", options::value<std::string>(), "draw them over the number of faces into this file");
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
    if (values["repeats"].as<int>() < 1 or values["threads"].as<int>() < 1 or values["faces-target"].as<double>() < 1)
        throw options::error("--repeats, --threads and --faces-target are 1 or more");
    return values;
}

/// Returns the numbers of faces to refine to. Errors: options::error for an entry that is not a number of at least 1.
std::vector<double> sizes_from(const options::variables_map& values)
{
    if (not values.count("sizes"))
        return {values["faces-target"].as<double>()};
    std::vector<double> result;
    std::istringstream words(values["sizes"].as<std::string>());
    for (std::string one; std::getline(words, one, ',');) {
        std::istringstream word(one);
        if (double size = 0; word >> size and word.eof() and size >= 1)
            result.push_back(size);
        else
            throw options::error("--sizes: '" + one + "' is no number of faces; write them as 1000,100000");
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
    const auto sizes = sizes_from(values);
    auto facts = machine();
    facts["threads of kith"] = std::to_string(values["threads"].as<int>());
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
    print(facts);
    for (auto& contest : contests) {
        run(contest, values["repeats"].as<int>(), values["threads"].as<int>());
        print(contest);
    }
    if (values.count("json"))
        write_json(values["json"].as<std::string>(), facts, contests);
    if (values.count("svg"))
        write_bars(values["svg"].as<std::string>(), facts, contests);
    if (values.count("curves"))
        write_curves(values["curves"].as<std::string>(), facts, contests);
}

} // namespace

int main(int count, char** words)
{
    return exit_code_of([&] {
        if (const auto values = parse(count, words))
            run_all(*values);
    });
}
