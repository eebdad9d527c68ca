// SPDX-License-Identifier: BSD-3-Clause
#include "peers/bfr_peer.hpp"
#include "bfr_tessellation.hpp"
#include "correctness/exit_code.hpp"
#include "peers/far_peer.hpp"
#include "correctness/random_place.hpp"
#include "search_times.hpp"
#include "timing.hpp"

#include <kith/presets.hpp>
#include <kith/read_mesh.hpp>
#include <kith/refine.hpp>
#include <kith/surface.hpp>

#include <boost/program_options.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#if defined(_OPENMP)
#include <omp.h>
#endif

namespace {

using namespace kith::comparison;
using kith::basic_mesh;

namespace options = boost::program_options;

using point = std::array<double, 3>;

/// The times of one run in seconds, and the points that the run made.
struct times {
    double set_up, locate, first, points, moved;
    std::vector<point> made{};
};
using runs = std::vector<times>;
struct tessellation_times {
    double all = 0;
    std::size_t triangles = 0;
};
/// The settings that the command line chooses.
struct settings {
    std::size_t places = 1'000'000, triangles = 1'000'000;
    int repeats = 5;
    int level = 3; // up to which Far refines
};

basic_mesh<> mesh_of(const kith::io::polygon_soup& soup)
{
    return kith::make_mesh(soup.points, soup.faces);
}

template <class Scheme>
std::vector<kith::surface_place> random_places(const basic_mesh<>& mesh, std::size_t count)
{
    random_numbers random(1);
    std::vector<kith::surface_place> result;
    for (std::size_t i = 0; i < count; ++i)
        result.push_back(random_place<Scheme>(mesh, random.below(mesh.face_count()), random));
    return result;
}

template <class Scheme>
times run_kith(const basic_mesh<>& mesh, const Scheme& scheme, const std::vector<kith::surface_place>& places)
{
    times result{};
    std::optional<kith::surface_locator<Scheme>> surface;
    kith::located_places at;
    kith::surface_values<point> values;
    result.set_up = seconds([&] { surface.emplace(mesh, scheme); });
    result.locate = seconds([&] { at = surface->locate(places); });
    result.first = seconds([&] { values = at.evaluate(mesh.points(), kith::derivatives::first); });
    result.points = seconds([&] { static_cast<void>(at.evaluate(mesh.points())); });
    result.moved = result.first; // only places are kept, so all values are computed again
    result.made.assign(values.points.begin(), values.points.end());
    return result;
}
/// Times a peer. make() returns the peer; evaluate(peer, i, outputs) evaluates place i, with first derivatives if there
/// are three outputs.
template <class Make, class Evaluate>
times run_peer(const basic_mesh<>& mesh, std::size_t count, const Make& make, const Evaluate& evaluate)
{
    times result{};
    decltype(make()) peer;
    std::vector<std::array<point, 3>> made(count);
    result.set_up = seconds([&] { peer = make(); });
    const auto evaluate_first = [&] {
        for (std::size_t i = 0; i < count; ++i)
            evaluate(*peer, i, made[i]);
    };
    result.first = seconds(evaluate_first);
    result.made.resize(count);
    result.points = seconds([&] {
        for (std::size_t i = 0; i < count; ++i) {
            std::array<point, 1> one;
            evaluate(*peer, i, one);
            result.made[i] = one[0];
        }
    });
    result.moved = seconds([&] {
        peer->move(mesh.points());
        evaluate_first();
    });
    return result;
}
template <class Scheme>
times run_bfr(const basic_mesh<>& mesh, const Scheme& scheme, const std::vector<kith::surface_place>& places)
{
    const auto refiner = opensubdiv_peer::make(mesh, scheme);
    const auto make = [&] { return std::make_unique<bfr_peer>(refiner, mesh.points()); };
    std::vector<std::array<double, 2>> parameters(places.size());
    const auto any = make();
    for (std::size_t i = 0; i < places.size(); ++i)
        parameters[i] = any->parameters(places[i]);
    return run_peer(mesh, places.size(), make, [&](const bfr_peer& peer, std::size_t i, auto& to) {
        peer.evaluate(places[i].face, parameters[i], to);
    });
}
template <class Scheme>
times run_far(const basic_mesh<>& mesh, const Scheme& scheme, const std::vector<kith::surface_place>& places, int level)
{
    const auto refiner = opensubdiv_peer::make(mesh, scheme);
    const auto make = [&] { return std::make_unique<far_peer>(refiner, mesh.points(), level); };
    return run_peer(mesh, places.size(), make, [&](const far_peer& peer, std::size_t i, auto& to) {
        peer.evaluate(places[i], to);
    });
}
/// Returns the largest distance between the points of `a` and `b` at the same place.
double largest_distance(const std::vector<point>& a, const std::vector<point>& b)
{
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        largest = std::max(largest, std::hypot(a[i][0] - b[i][0], a[i][1] - b[i][1], a[i][2] - b[i][2]));
    return largest;
}

template <class Scheme>
void contest(const std::string& name, const basic_mesh<>& mesh, const Scheme& scheme, const settings& chosen)
{
    const auto places = random_places<Scheme>(mesh, chosen.places);
    runs ours, bfr, far;
    for (int i = 0; i < chosen.repeats; ++i) {
        ours.push_back(run_kith(mesh, scheme, places));
        bfr.push_back(run_bfr(mesh, scheme, places));
        far.push_back(run_far(mesh, scheme, places, chosen.level));
    }
    const auto print = [&](const char* who, const runs& all) {
        const double per_place = 1e9 / double(places.size()), per_face = 1e9 / double(mesh.face_count());
        std::cout << std::fixed << std::setprecision(0) << std::setw(8) << who << std::setw(12)
                  << median(all, &times::set_up) * per_face << std::setw(12) << median(all, &times::locate) * per_place
                  << std::setw(12) << median(all, &times::first) * per_place << std::setw(12)
                  << median(all, &times::points) * per_place << std::setw(12) << median(all, &times::moved) * per_place
                  << std::scientific << std::setw(12) << largest_distance(all[0].made, ours[0].made) << '\n';
    };
    std::cout << name << ", " << mesh.face_count() << " faces, " << places.size() << " random places\n"
              << "          ns a face     a place   with du,dv  points only       moved   off kith by\n";
    print("kith", ours);
    print("Bfr", bfr);
    print("Far", far);
}

/// Times tessellation into the same number of segments on all edges.
template <class Scheme>
void contest_tessellations(const std::string& name, const basic_mesh<>& mesh, const Scheme& scheme,
                           const settings& chosen)
{
    double triangles = 0; // for one segment per edge
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        triangles += mesh.face(f).size() == 3 and not kith::detail::has_quad_parameters<Scheme>
                         ? 1
                         : double(mesh.face(f).size()) / 2;
    const double halves = std::sqrt(double(chosen.triangles) / triangles) / 2;
    const std::size_t segments = 2 * std::size_t(std::max(1., std::round(halves))); // polygons need an even number
    std::vector<tessellation_times> ours, theirs;
    const auto refiner = opensubdiv_peer::make(mesh, scheme);
    for (int i = 0; i < chosen.repeats; ++i) {
        tessellation_times &our = ours.emplace_back(), &their = theirs.emplace_back();
        our.all = seconds([&] { our.triangles = tessellate(mesh, scheme, {.segments = segments}).mesh.face_count(); });
        their.all = seconds(
            [&] { their.triangles = bfr_tessellation(refiner, mesh.points(), int(segments)).triangles.size(); });
    }
    const auto print = [](const char* who, const std::vector<tessellation_times>& all) {
        std::cout << who << ' ' << all[0].triangles << " triangles, "
                  << 1e9 * median(all, &tessellation_times::all) / double(all[0].triangles) << " ns each";
    };
    std::cout << name << ", " << segments << " segments of each edge, with normals: " << std::fixed
              << std::setprecision(0);
    print("kith", ours);
    print("; Bfr", theirs);
    std::cout << '\n';
}

} // namespace

int main(int count, char** words)
{
    return exit_code_of([&] {
        options::options_description all(
            "Places on limit surfaces, by kith and by OpenSubdiv's Bfr and Far in turn, on one thread: the time of "
            "finding the surfaces of all faces, of finding the places, of evaluating them, and of doing so again for "
            "moved points; triangles by kith and Bfr; rays and nearest points by kith alone");
        settings chosen;
        std::string file;
        all.add_options()("help",
                          "this text")("mesh", options::value(&file), "a mesh: OFF, OBJ, PLY, STL; else a torus")(
            "places", options::value(&chosen.places)->default_value(chosen.places), "how many")(
            "triangles", options::value(&chosen.triangles)->default_value(chosen.triangles), "about how many")(
            "level", options::value(&chosen.level)->default_value(chosen.level), "up to which Far refines, 1 to 10")(
            "repeats",
            options::value(&chosen.repeats)->default_value(chosen.repeats),
            "runs of each; medians are printed");
        options::variables_map values;
        store(options::parse_command_line(count, words, all), values);
        notify(values);
        if (values.count("help")) {
            std::cout << all;
            return;
        }
#if defined(_OPENMP)
        omp_set_num_threads(1);
#endif
        const auto shape = shapes::shaken(shapes::torus(40, 60));
        const auto mesh = file.empty() ? kith::make_mesh(shape.points, shape.faces)
                                       : mesh_of(kith::io::read_mesh_file(file));
        const auto catmull_clark = kith::like<kith::catmull_clark>(kith::library::opensubdiv);
        const auto contest_all = [&](const std::string& name, const basic_mesh<>& control, const auto& scheme) {
            contest(name, control, scheme, chosen);
            contest_tessellations(name, control, scheme, chosen);
        };
        contest_all("Catmull-Clark", mesh, catmull_clark);
        contest_all("Catmull-Clark, once refined", kith::refine(mesh, catmull_clark, 1), catmull_clark);
        time_searches("Catmull-Clark", mesh, catmull_clark, chosen.repeats);
        const bool has_triangles = mesh.topology().degree == 3;
        const auto cut = shapes::triangulated(shape);
        if (file.empty() or has_triangles)
            contest_all("Loop",
                        has_triangles ? mesh : kith::make_mesh(cut.points, cut.faces),
                        kith::like<kith::loop>(kith::library::opensubdiv));
    });
}
