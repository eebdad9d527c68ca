// SPDX-License-Identifier: BSD-3-Clause
#include "peers/bfr_peer.hpp"
#include "exit_code.hpp"
#include "random_meshes.hpp"
#include "random_runs.hpp"

#include <kith/four_eight.hpp>
#include <kith/hierarchy.hpp>
#include <kith/limits/limit_surface.hpp>
#include <kith/numbering/step/submesh.hpp>
#include <kith/presets.hpp>
#include <kith/unified.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

using namespace kith::comparison;
using kith::basic_mesh;

/// The counts of compared places, and the largest differences of points and derivatives.
struct tally {
    std::size_t turned = 0; // second derivatives with the opposite sign
    struct of_kind {
        std::size_t places = 0;
        std::array<double, 3> largest{};
    };
    of_kind regular, irregular, near_vertices;
    std::size_t deep_places = 0; // at vertices of level 12
    double deep = 0;
    std::size_t own_places = 0; // at vertices of levels, for schemes that OpenSubdiv does not have
    double own = 0;
};

/// Returns true if a place is so near to a corner of its face that Bfr approximates the surface there, after its last
/// level.
bool is_near_vertex(const kith::surface_place& place)
{
    constexpr double least = 1. / 256;
    const auto is_near_end = [](double x) { return x < least or x > 1 - least; };
    return is_near_end(place.u) and is_near_end(place.v);
}

/// Returns eight random places in each face, one of them on an edge.
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

/// Returns the largest difference of a coordinate over the derivatives of one order. The derivatives of Bfr are
/// multiplied by `scale`.
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
    constexpr int exact_levels = 10; // the most that OpenSubdiv allows
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
        // In Bfr's parameters a sub-face is half as wide.
        const double scale = surface.GetParameterization().HasSubFaces() ? .5 : 1;
        const bool is_near = not surface.IsRegular() and is_near_vertex(places[i]);
        tally::of_kind& kind = surface.IsRegular() ? sum.regular : is_near ? sum.near_vertices : sum.irregular;
        ++kind.places;
        for (int order = 0; order < 3; ++order) {
            double here = difference(ours, i, values, order, std::pow(scale, order));
            // In a triangle whose parameters were rotated, Bfr's second derivatives have the wrong sign; differences of
            // its own first derivatives have the opposite one.
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

/// A random vertex of level 12: its place on the surface, and its limit by the masks of that level.
struct deep_vertex {
    kith::surface_place place;
    std::array<double, 3> limit;
};

using parameters = std::array<double, 2>;

/// Returns the corners of child k of a face, given the corners of the face. Child k lies at corner k; child 3 of a
/// triangle is the middle one.
std::vector<parameters> child_of(const std::vector<parameters>& face, std::size_t k)
{
    const std::size_t n = face.size();
    const auto middle = [&](std::size_t i, std::size_t j) {
        return parameters{(face[i % n][0] + face[j % n][0]) / 2, (face[i % n][1] + face[j % n][1]) / 2};
    };
    if (n == 4)
        return {face[k], middle(k, k + 1), middle(0, 2), middle(k + 3, k)};
    if (k == 3)
        return {middle(2, 0), middle(0, 1), middle(1, 2)};
    return {face[k], middle(k, k + 1), middle(k + 2, k)};
}

/// Makes 12 steps around a face by the scheme's own code. Each step keeps the neighbourhood of one child of the
/// previous face.
template <class Scheme>
deep_vertex go_deep(const basic_mesh<>& control, Scheme scheme, std::size_t control_face, random_numbers& random)
{
    using index = std::uint32_t;
    constexpr bool has_quads = kith::detail::has_quad_parameters<Scheme>;
    constexpr int levels = 12, rings = 4;
    basic_mesh<> mesh = control;
    index face = index(control_face);
    std::size_t corner = 0; // of the sub-face
    const std::size_t degree = control.face(control_face).size();
    std::vector<parameters> corners{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    if (not has_quads)
        corners = {{0, 0}, {1, 0}, {0, 1}};
    for (int level = 0; level < levels; ++level) {
        const bool is_polygon = has_quads and mesh.face(face).size() != 4;
        const std::size_t child = random.below(is_polygon ? degree : 4);
        if (is_polygon)
            corner = child;
        else
            corners = child_of(corners, child);
        kith::numbering_of<Scheme, index> ids;
        const auto fine = kith::refine_mesh<kith::connect::everything>(mesh, scheme, ids);
        kith::advance(scheme, kith::level_of<basic_mesh<>>(mesh), mesh.generation(), ids, fine);
        const std::size_t first_corner = mesh.topology().first_corner(face);
        index fine_face = 0;
        if constexpr (has_quads)
            fine_face = index(ids.faces.template id<kith::tuple_kind::vf>(first_corner + child));
        else
            fine_face = child == 3 ? index(ids.faces.template id<kith::tuple_kind::f>(face))
                                   : index(ids.faces.template id<kith::tuple_kind::vf>(first_corner + child));
        kith::submesh_cutter<std::array<double, 3>, index> cutter(fine);
        auto part = cutter.cut(cutter.faces_around(std::array{fine_face}, rings));
        kith::detail::restrict_state(scheme, scheme, part.numbers());
        face = index(std::ranges::lower_bound(part.face_from, fine_face) - part.face_from.begin());
        mesh = std::move(part.mesh);
    }
    return {{control_face, corners[0][0], corners[0][1], corner},
            limit_surface_of(mesh, scheme).positions[mesh.face(face)[0]]};
}

/// Compares vertices of level 12 with the surface.
template <class Scheme>
void compare_levels(const basic_mesh<>& mesh, const Scheme& scheme, random_numbers& random, tally& sum)
{
    std::vector<kith::surface_place> places;
    std::vector<std::array<double, 3>> limits;
    for (int i = 0; i < 2; ++i) {
        const auto [place, limit] = go_deep(mesh, scheme, random.below(mesh.face_count()), random);
        places.push_back(place);
        limits.push_back(limit);
    }
    const auto made = kith::surface_locator(mesh, scheme).locate(places).evaluate(mesh.points());
    for (std::size_t i = 0; i < places.size(); ++i) {
        double here = 0;
        for (std::size_t axis = 0; axis < 3; ++axis)
            here = std::max(here, std::abs(made.points[i][axis] - limits[i][axis]));
        ++sum.deep_places;
        sum.deep = std::max(sum.deep, here);
        if (not(here <= 1e-12))
            throw std::runtime_error(std::string(kith::scheme_name<Scheme>()) + ", face " +
                                     std::to_string(places[i].face) + ": level 12 is off by " + std::to_string(here));
    }
}

/// A face of a level as a part of a face of the control mesh.
struct part_of_face {
    std::size_t face, corner;
    std::vector<parameters> corners;
};

/// Returns the parts that one step makes of a face: one at each corner, or for 4-8 one at each end of its first edge.
template <class Scheme>
std::vector<part_of_face> parts_of(const part_of_face& whole)
{
    const auto& [face, corner, c] = whole;
    if constexpr (std::is_same_v<Scheme, kith::four_eight>) {
        const parameters middle{(c[0][0] + c[1][0]) / 2, (c[0][1] + c[1][1]) / 2};
        return {{face, corner, {c[2], c[0], middle}}, {face, corner, {c[1], c[2], middle}}};
    } else {
        std::vector<part_of_face> result;
        for (std::size_t k = 0; k < c.size(); ++k)
            result.push_back(c.size() == 4 ? part_of_face{face, corner, child_of(c, k)}
                                           : part_of_face{face, k, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
        return result;
    }
}

/// Compares all vertices of a level that the scheme makes with the surface.
template <class Scheme>
void compare_own_level(const basic_mesh<>& control, const Scheme& scheme, int level, tally& sum)
{
    std::vector<part_of_face> parts;
    for (std::size_t f = 0; f < control.face_count(); ++f)
        parts.push_back({f, 0, std::vector<parameters>(control.face(f).size())});
    for (auto& [face, corner, corners] : parts)
        if (corners.size() == 4)
            corners = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
        else if (corners.size() == 3)
            corners = {{0, 0}, {1, 0}, {0, 1}};
    for (int step = 0; step < level; ++step) {
        std::vector<part_of_face> next;
        for (const part_of_face& part : parts)
            for (auto& child : parts_of<Scheme>(part))
                next.push_back(std::move(child));
        parts = std::move(next);
    }
    std::vector<kith::surface_place> places;
    for (const auto& [face, corner, corners] : parts)
        for (const auto& [u, v] : corners)
            places.push_back({face, u, v, corner});
    kith::hierarchy<basic_mesh<>, Scheme> levels(control, scheme);
    levels.refine(level);
    const auto limits = limit_surface_of(levels, level).positions;
    const auto made = kith::surface_locator(control, scheme).locate(places).evaluate(control.points());
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto& limit = limits[levels[level].topology().corner_vertex[i]];
        double here = 0;
        for (std::size_t axis = 0; axis < 3; ++axis)
            here = std::max(here, std::abs(made.points[i][axis] - limit[axis]));
        ++sum.own_places;
        sum.own = std::max(sum.own, here);
        if (not(here <= 1e-11))
            throw std::runtime_error(std::string(kith::scheme_name<Scheme>()) + ", face " +
                                     std::to_string(places[i].face) + ": level " + std::to_string(level) +
                                     " is off by " + std::to_string(here));
    }
}

/// Compares the surfaces of schemes that OpenSubdiv does not have with their own levels.
void compare_others(const shapes::shape& shape, tally& sum)
{
    const auto mesh = kith::make_mesh(shape.points, shape.faces);
    compare_own_level(tri_quad(mesh), kith::four_eight{}, 4, sum);
    if (mesh.topology().is_closed())
        for (const int degree : {1, 3, 5})
            compare_own_level(mesh, kith::unified{.degree = degree}, 2, sum);
}

/// Compares both boundary rules on one mesh, without creases and with creases of each kind.
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
        compare_levels(mesh, scheme, random, sum);
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
            compare_others(random_polygons(random), sum);
        });
        const auto print = [](const char* where, const tally::of_kind& kind) {
            std::cout << kind.places << " places " << where << "; largest differences of points " << kind.largest[0]
                      << ", of first derivatives " << kind.largest[1] << ", of second ones " << kind.largest[2] << '\n';
        };
        print("in regular faces", sum.regular);
        print("in irregular faces", sum.irregular);
        std::cout << sum.turned << " of them where Bfr's second derivatives have the other sign\n";
        print("at vertices of these, where Bfr approximates", sum.near_vertices);
        std::cout << sum.deep_places << " vertices of level 12; largest difference of limits " << sum.deep << '\n';
        std::cout << sum.own_places << " vertices of levels of 4-8 and unified; largest difference of limits "
                  << sum.own << '\n';
        std::cout << opensubdiv_peer::version() << ", " << runs->count << " meshes for each scheme, "
                  << runs->different() << " different\n";
        runs->require_same();
    });
}
