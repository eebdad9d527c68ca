// SPDX-License-Identifier: BSD-3-Clause
#include "compare_files.hpp"
#include "random_place.hpp"

#include <kith/core/mesh/make_mesh.hpp>
#include <kith/limits/unit_normal.hpp>
#include <kith/presets.hpp>
#include <kith/surface.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace {

using namespace kith::comparison;
using point = std::array<double, 3>;

point difference(const point& a, const point& b)
{
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
double product(const point& a, const point& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Returns the square of the distance from a point to a segment that starts at the origin.
double square_to_segment(const point& p, const point& end)
{
    const double square = product(end, end);
    const double t = square > 0 ? std::clamp(product(p, end) / square, 0., 1.) : 0;
    const point rest = difference(p, {t * end[0], t * end[1], t * end[2]});
    return product(rest, rest);
}
/// Returns the distance from a point to a triangle.
double distance(const point& p, const std::array<point, 3>& triangle)
{
    const auto& [a, b, c] = triangle;
    const point ab = difference(b, a), ac = difference(c, a), ap = difference(p, a);
    const double bb = product(ab, ab), bc = product(ab, ac), cc = product(ac, ac), pb = product(ap, ab),
                 pc = product(ap, ac), determinant = bb * cc - bc * bc;
    const double u = (cc * pb - bc * pc) / determinant, v = (bb * pc - bc * pb) / determinant;
    if (u >= 0 and v >= 0 and u + v <= 1) {
        const point foot{u * ab[0] + v * ac[0], u * ab[1] + v * ac[1], u * ab[2] + v * ac[2]};
        const point rest = difference(ap, foot);
        return std::sqrt(product(rest, rest));
    }
    return std::sqrt(std::min(
        {square_to_segment(ap, ab), square_to_segment(ap, ac), square_to_segment(difference(p, b), difference(c, b))}));
}

/// Returns the distance from a point to the plane of a triangle, or to the triangle itself if it is degenerate.
double distance_to_plane(const point& p, const std::array<point, 3>& triangle)
{
    const auto normal = kith::unit_normal(difference(triangle[1], triangle[0]), difference(triangle[2], triangle[0]));
    return normal ? std::abs(product(difference(p, triangle[0]), *normal)) : distance(p, triangle);
}

/// Returns the largest distance from the surface, at random places in each face, to the plane of the nearest triangle
/// of the face.
template <class Scheme>
double largest_distance(const kith::basic_mesh<>& control, const Scheme& scheme, const kith::tessellation<point>& made)
{
    constexpr int places_of_face = 100;
    std::vector<std::vector<std::array<point, 3>>> triangles(control.face_count());
    for (std::size_t t = 0; t < made.faces.size(); ++t) {
        const auto vertices = made.mesh.face(t);
        triangles[made.faces[t]].push_back(
            {made.mesh.point(vertices[0]), made.mesh.point(vertices[1]), made.mesh.point(vertices[2])});
    }
    random_numbers random(1);
    std::vector<kith::surface_place> places;
    for (std::size_t f = 0; f < control.face_count(); ++f)
        for (int i = 0; i < places_of_face; ++i)
            places.push_back(random_place<Scheme>(control, f, random));
    const auto points = kith::surface_locator(control, scheme).locate(places).evaluate(control.points()).points;
    double largest = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto& of_face = triangles[places[i].face];
        const auto nearest = std::ranges::min_element(
            of_face, {}, [&](const auto& triangle) { return distance(points[i], triangle); });
        largest = std::max(largest, distance_to_plane(points[i], *nearest));
    }
    return largest;
}

/// Tessellates by a chord error and checks the result. kith measures the error at the midpoints of triangles and edges;
/// between them the surface may be slightly further away.
template <class Scheme>
void compare(const control_mesh& control, const std::string& name, const Scheme& scheme, verdicts& verdicts)
{
    constexpr double between_middles = 1.1;
    const double asked = control.diagonal() / 1000;
    const auto made = tessellate(control.mesh, scheme, {.chord_error = asked});
    const auto euler = [](const auto& mesh) {
        return std::ptrdiff_t(mesh.vertex_count() + mesh.face_count()) - std::ptrdiff_t(mesh.edge_count());
    };
    const bool is_closed = made.mesh.corner_count() == 2 * made.mesh.edge_count();
    const double found = largest_distance(control.mesh, scheme, made);
    if (not validate(made.mesh).ok() or is_closed != control.is_closed() or euler(made.mesh) != euler(control.mesh))
        verdicts.different(control.name, name, "the triangles do not fit together");
    else if (not(found <= between_middles * asked))
        verdicts.different(control.name, name, "the surface is " + std::to_string(found / asked) + " chord errors off");
    else
        verdicts.same(control.name,
                      name,
                      std::to_string(made.mesh.face_count()) + " triangles, " + std::to_string(found / asked) +
                          " of the chord error",
                      found / control.diagonal());
}
template <class Scheme>
void compare(const control_mesh& control, verdicts& verdicts)
{
    auto scheme = kith::like<Scheme>(kith::library::opensubdiv);
    compare(control, std::string(kith::scheme_name<Scheme>()), scheme, verdicts);
    for (std::uint32_t edge = 0; edge < control.mesh.edge_count(); edge += 7)
        scheme.sharpness.sharpen_edge(edge, edge % 2 == 0 ? kith::infinitely_sharp : 1.5);
    compare(control, std::string(kith::scheme_name<Scheme>()) + " with creases", scheme, verdicts);
}

} // namespace

int main(int count, char** words)
{
    return compare_files(count,
                         words,
                         "Tessellates limit surfaces by a chord error, and compares the triangles with the surface.",
                         [](const control_mesh& control, int, verdicts& verdicts) {
                             compare<kith::catmull_clark>(control, verdicts);
                             if (control.is_triangles())
                                 compare<kith::loop>(control, verdicts);
                         });
}
