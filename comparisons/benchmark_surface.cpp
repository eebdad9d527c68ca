// SPDX-License-Identifier: BSD-3-Clause
#include "bfr_peer.hpp"
#include "exit_code.hpp"
#include "random_meshes.hpp"

#include <kith/closest_points.hpp>
#include <kith/presets.hpp>
#include <kith/ray_hits.hpp>
#include <kith/read_mesh.hpp>
#include <kith/refine.hpp>
#include <kith/surface.hpp>

#include <boost/program_options.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <iostream>
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

/// Nanoseconds of one run: per face for the set-up, per place for all else.
struct times {
    double set_up, locate, first, points, moved;
};
using runs = std::vector<times>;
/// Seconds of one run.
struct search_times {
    double set_up, rays, nearest;
};

basic_mesh<> mesh_of(const kith::io::polygon_soup& soup)
{
    return kith::make_mesh(soup.points, soup.faces);
}

template <class F>
double seconds(const F& f)
{
    const auto begin = std::chrono::steady_clock::now();
    f();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}
template <class Times>
double median(const std::vector<Times>& all, double Times::* which)
{
    std::vector<double> values;
    for (const Times& one : all)
        values.push_back(one.*which);
    std::ranges::sort(values);
    return values[values.size() / 2];
}

template <class Scheme>
std::vector<kith::surface_place> random_places(const basic_mesh<>& mesh, std::size_t count)
{
    random_numbers random(1);
    std::vector<kith::surface_place> result;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t face = random.below(mesh.face_count()), degree = mesh.face(face).size();
        double u = (random.coordinate() + 1) / 2, v = (random.coordinate() + 1) / 2;
        if (not kith::detail::has_quad_parameters<Scheme> and u + v > 1) {
            u = 1 - u;
            v = 1 - v;
        }
        result.push_back(
            {face, u, v, kith::detail::has_quad_parameters<Scheme> and degree != 4 ? random.below(degree) : 0});
    }
    return result;
}

template <class Scheme>
times run_kith(const basic_mesh<>& mesh, const Scheme& scheme, const std::vector<kith::surface_place>& places)
{
    times result{};
    std::optional<kith::surface_locator<Scheme>> surface;
    kith::located_places at;
    result.set_up = seconds([&] { surface.emplace(mesh, scheme); });
    result.locate = seconds([&] { at = surface->locate(places); });
    result.first = seconds([&] { static_cast<void>(at.evaluate(mesh.points(), kith::derivatives::first)); });
    result.points = seconds([&] { static_cast<void>(at.evaluate(mesh.points())); });
    result.moved = result.first; // what is kept are places; all values are made again
    return result;
}
template <class Scheme>
times run_bfr(const basic_mesh<>& mesh, const Scheme& scheme, const std::vector<kith::surface_place>& places)
{
    times result{};
    const auto refiner = opensubdiv_peer::make(mesh, scheme);
    std::optional<bfr_peer> peer;
    result.set_up = seconds([&] { peer.emplace(refiner, mesh.points()); });
    std::vector<std::array<double, 2>> parameters(places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        parameters[i] = peer->parameters(places[i]);
    std::vector<std::array<std::array<double, 3>, 3>> made(places.size());
    bfr_peer::values values{};
    const auto evaluate = [&] {
        for (std::size_t i = 0; i < places.size(); ++i) {
            peer->evaluate_first(places[i].face, parameters[i], values);
            made[i] = {values[0], values[1], values[2]};
        }
    };
    result.first = seconds(evaluate);
    result.points = seconds([&] {
        for (std::size_t i = 0; i < places.size(); ++i)
            peer->evaluate_point(places[i].face, parameters[i], made[i][0]);
    });
    result.moved = seconds([&] {
        peer->move(mesh.points());
        evaluate();
    });
    return result;
}

template <class Scheme>
void contest(const std::string& name, const basic_mesh<>& mesh, const Scheme& scheme, std::size_t count, int repeats)
{
    const auto places = random_places<Scheme>(mesh, count);
    runs ours, theirs;
    for (int i = 0; i < repeats; ++i) {
        ours.push_back(run_kith(mesh, scheme, places));
        theirs.push_back(run_bfr(mesh, scheme, places));
    }
    const auto print = [&](const char* who, const runs& all) {
        const double per_place = 1e9 / double(count), per_face = 1e9 / double(mesh.face_count());
        std::cout << std::setw(8) << who << std::setw(12) << median(all, &times::set_up) * per_face << std::setw(12)
                  << median(all, &times::locate) * per_place << std::setw(12) << median(all, &times::first) * per_place
                  << std::setw(12) << median(all, &times::points) * per_place << std::setw(12)
                  << median(all, &times::moved) * per_place << '\n';
    };
    std::cout << name << ", " << mesh.face_count() << " faces, " << count << " random places\n"
              << "          ns a face     a place   with du,dv  points only       moved\n"
              << std::fixed << std::setprecision(0);
    print("kith", ours);
    print("Bfr", theirs);
}

/// Times rays and nearest points, for which there is no peer.
template <class Scheme>
void time_searches(const std::string& name, const basic_mesh<>& mesh, const Scheme& scheme, int repeats)
{
    constexpr std::size_t queries = 2000;
    double size = 0;
    for (const auto& p : mesh.points())
        for (const double x : p)
            size = std::max(size, std::abs(x));
    random_numbers random(2);
    std::vector<kith::surface_ray> rays;
    std::vector<std::array<double, 3>> points;
    for (std::size_t i = 0; i < queries; ++i) {
        const auto any = [&] {
            return std::array{size * random.coordinate(), size * random.coordinate(), size * random.coordinate()};
        };
        const auto from = any(), to = any();
        rays.push_back({from, {to[0] - from[0], to[1] - from[1], to[2] - from[2]}});
        points.push_back(from);
    }
    std::vector<search_times> all;
    for (int i = 0; i < repeats; ++i) {
        search_times& one = all.emplace_back();
        std::optional<kith::ray_hits<Scheme>> hits;
        std::optional<kith::closest_points<Scheme>> nearest;
        one.set_up = seconds([&] { hits.emplace(mesh, scheme); });
        nearest.emplace(mesh, scheme);
        one.rays = seconds([&] { static_cast<void>(hits->of(rays)); });
        one.nearest = seconds([&] { static_cast<void>(nearest->of(points)); });
    }
    constexpr double microseconds = 1e6;
    std::cout << name << ", " << mesh.face_count() << " faces: set-up "
              << median(all, &search_times::set_up) * microseconds / double(mesh.face_count()) << " us a face, "
              << median(all, &search_times::rays) * microseconds / double(queries) << " us a ray, "
              << median(all, &search_times::nearest) * microseconds / double(queries) << " us a nearest point\n";
}

} // namespace

int main(int count, char** words)
{
    return exit_code_of([&] {
        options::options_description all(
            "Places on limit surfaces, by kith and by OpenSubdiv's Bfr in turn, on one thread: the time of finding the "
            "surfaces of all faces, of finding the places, of evaluating them, and of doing so again for moved points; "
            "rays and nearest points by kith alone");
        std::size_t places = 1'000'000;
        int repeats = 5;
        std::string file;
        all.add_options()("help",
                          "this text")("mesh", options::value(&file), "a mesh: OFF, OBJ, PLY, STL; else a torus")(
            "places", options::value(&places)->default_value(places), "how many")(
            "repeats", options::value(&repeats)->default_value(repeats), "runs of each; medians are printed");
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
        contest("Catmull-Clark", mesh, catmull_clark, places, repeats);
        contest("Catmull-Clark, once refined", kith::refine(mesh, catmull_clark, 1), catmull_clark, places, repeats);
        std::cout << std::setprecision(1);
        time_searches("Catmull-Clark", mesh, catmull_clark, repeats);
        const bool has_triangles = mesh.topology().degree == 3;
        const auto cut = shapes::triangulated(shape);
        if (file.empty() or has_triangles)
            contest("Loop",
                    has_triangles ? mesh : kith::make_mesh(cut.points, cut.faces),
                    kith::like<kith::loop>(kith::library::opensubdiv),
                    places,
                    repeats);
    });
}
