// SPDX-License-Identifier: BSD-3-Clause
#include "bfr_peer.hpp"
#include "exit_code.hpp"
#include "random_meshes.hpp"
#include "random_runs.hpp"

#include <kith/presets.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace {

using namespace kith::comparison;
using kith::basic_mesh;

/// Counts the places that have been compared, and keeps the largest differences of points and derivatives.
struct tally {
    std::size_t turned = 0; // second derivatives that have the other sign
    struct of_kind {
        std::size_t places = 0;
        std::array<double, 3> largest{};
    };
    of_kind regular, irregular, near_vertices;
};

/// Returns true if a place is so near to a corner of its face that Bfr, after its last level, approximates there.
bool is_near_vertex(const kith::surface_place& place)
{
    constexpr double least = 1. / 256;
    const auto is_near_end = [](double x) { return x < least or x > 1 - least; };
    return is_near_end(place.u) and is_near_end(place.v);
}

/// Returns eight places in each face at random, one of them on an edge.
template <class Scheme>
std::vector<kith::surface_place> random_places(const basic_mesh<>& mesh, random_numbers& random)
{
    constexpr bool has_quads = kith::detail::has_quad_parameters<Scheme>;
    std::vector<kith::surface_place> result;
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        for (int i = 0; i < 8; ++i) {
            double u = (random.coordinate() + 1) / 2, v = i == 0 ? 0 : (random.coordinate() + 1) / 2;
            if (not has_quads and u + v > 1) {
                u = 1 - u;
                v = 1 - v;
            }
            const std::size_t degree = mesh.face(f).size();
            result.push_back({f, u, v, has_quads and degree != 4 ? random.below(degree) : 0});
        }
    return result;
}

/// Returns the largest difference of a coordinate in derivatives of one order. Theirs are multiplied by `scale`.
double difference(const kith::surface_values<std::array<double, 3>>& ours, std::size_t i,
                  const bfr_peer::values& theirs, int order, double scale)
{
    const std::array all{&ours.points, &ours.du, &ours.dv, &ours.duu, &ours.duv, &ours.dvv};
    const std::size_t first = order == 0 ? 0 : order == 1 ? 1 : 3, end = order == 0 ? 1 : order == 1 ? 3 : 6;
    double largest = 0;
    for (std::size_t k = first; k < end; ++k)
        for (std::size_t axis = 0; axis < 3; ++axis)
            largest = std::max(largest, std::abs((*all[k])[i][axis] - scale * theirs[k][axis]));
    return largest;
}

template <class Scheme>
void compare(const basic_mesh<>& mesh, const Scheme& scheme, random_numbers& random, tally& sum)
{
    const auto refiner = opensubdiv_peer::make(mesh, scheme);
    if (not refiner)
        throw std::runtime_error("OpenSubdiv refuses the mesh");
    constexpr int exact_levels = 10; // OpenSubdiv's most
    const bfr_peer theirs(refiner, mesh.points(), exact_levels, exact_levels);
    const auto places = random_places<Scheme>(mesh, random);
    const auto ours =
        kith::surface_locator(mesh, scheme).locate(places).evaluate(mesh.points(), kith::derivatives::second);
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto& surface = theirs.of_face(places[i].face);
        if (not surface.IsValid())
            continue;
        bfr_peer::values values{};
        theirs.evaluate(places[i].face, theirs.parameters(places[i]), values);
        // A sub-face is half as wide to Bfr.
        const double scale = surface.GetParameterization().HasSubFaces() ? .5 : 1;
        const bool is_near = not surface.IsRegular() and is_near_vertex(places[i]);
        tally::of_kind& kind = surface.IsRegular() ? sum.regular : is_near ? sum.near_vertices : sum.irregular;
        ++kind.places;
        for (int order = 0; order < 3; ++order) {
            double here = difference(ours, i, values, order, std::pow(scale, order));
            // In a triangle that was turned, Bfr's second derivatives have the wrong sign. Differences of its own first
            // derivatives have the other one.
            if (order == 2 and std::is_same_v<Scheme, kith::loop> and not surface.IsRegular())
                if (const double other = difference(ours, i, values, order, -1); other < here) {
                    here = other;
                    ++sum.turned;
                }
            double& largest = kind.largest[std::size_t(order)];
            largest = std::max(largest, here);
            constexpr double any = std::numeric_limits<double>::infinity();
            constexpr std::array<double, 3> exact{1e-12, 1e-11, 1e-7}, rough{1e-2, any, any};
            if (not(here <= (is_near ? rough : exact)[std::size_t(order)]))
                throw std::runtime_error(std::string(kith::scheme_name<Scheme>()) + ", face " +
                                         std::to_string(places[i].face) + " at " + std::to_string(places[i].u) + ' ' +
                                         std::to_string(places[i].v) + ": derivatives of order " +
                                         std::to_string(order) + " are off by " + std::to_string(here));
        }
    }
}

/// On one mesh without creases and with some of each kind.
template <class Scheme>
void compare_options(const shapes::shape& shape, random_numbers& random, tally& sum)
{
    const auto mesh = kith::make_mesh(shape.points, shape.faces);
    for (const auto corners : {kith::boundary_corner::kept, kith::boundary_corner::smoothed}) {
        auto scheme = kith::like<Scheme>(kith::library::opensubdiv);
        scheme.corners = corners;
        compare(mesh, scheme, random, sum);
        scheme.sharpness = random_creases(mesh, float_sharpness::alike, kith::crease_method::uniform, random);
        compare(mesh, scheme, random, sum);
    }
}

} // namespace

int main(int count, char** words)
{
    return exit_code_of([&] {
        auto runs = parse_random_runs(count, words, "Random places on random meshes, by OpenSubdiv's Bfr and by kith");
        if (not runs)
            return;
        tally sum;
        runs->attempt_seeds([&](random_numbers& random) {
            compare_options<kith::catmull_clark>(random_polygons(random), random, sum);
            compare_options<kith::loop>(random_triangles(random), random, sum);
        });
        const auto print = [](const char* where, const tally::of_kind& kind) {
            std::cout << kind.places << " places " << where << "; largest differences of points " << kind.largest[0]
                      << ", of first derivatives " << kind.largest[1] << ", of second ones " << kind.largest[2] << '\n';
        };
        print("in regular faces", sum.regular);
        print("in irregular faces", sum.irregular);
        std::cout << sum.turned << " of them where Bfr's second derivatives have the other sign\n";
        print("at vertices of these, where Bfr approximates", sum.near_vertices);
        std::cout << opensubdiv_peer::version() << ", " << runs->count << " meshes for each scheme, "
                  << runs->different() << " different\n";
        runs->require_same();
    });
}
