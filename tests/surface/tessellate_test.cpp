// SPDX-License-Identifier: BSD-3-Clause
#include <kith/surface.hpp>

#include "support/error_text.hpp"
#include "support/every_scheme.hpp"
#include "support/thread_count.hpp"

#include <kith/limits/limit_surface.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace {

using kith::tessellation_options;
using point = std::array<double, 3>;

/// Returns V - E + F and the number of boundary edges.
std::array<long, 2> topology_of(const mesh3d& mesh)
{
    const auto c = count(mesh.topology());
    return {long(c.vertices) - long(c.edges) + long(c.faces), long(c.boundary_edges)};
}

/// A control mesh with its surface, against which its tessellations are checked.
template <class Scheme>
class checked_surface {
public:
    checked_surface(const mesh3d& control, const Scheme& scheme)
        : control_(control)
        , scheme_(scheme)
        , surface_(control, scheme)
        , limits_(limit_surface_of(control, scheme).positions)
    {
    }

    /// Expects a conforming surface with the topology of the control mesh, whose vertices lie at their places.
    kith::tessellation<point> expect_conforming(const tessellation_options& options)
    {
        auto made = tessellate(control_, scheme_, options);
        EXPECT_EQ(topology_of(made.mesh)[0], topology_of(control_)[0]);
        EXPECT_EQ(topology_of(made.mesh)[1] != 0, topology_of(control_)[1] != 0);
        const auto there = surface_.locate(made.places).evaluate(control_.points());
        for (std::size_t v = 0; v < there.points.size(); ++v)
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_NEAR(made.mesh.point(v)[k], there.points[v][k], 1e-12);
        EXPECT_TRUE(validate(made.mesh).ok());
        EXPECT_EQ(made.faces.size(), made.mesh.face_count());
        for (std::size_t v = 0; v < control_.vertex_count(); ++v) // the control vertices come first
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_NEAR(made.mesh.point(v)[k], limits_[v][k], 1e-12);
        for (const auto& [x, y, z] : made.normals)
            EXPECT_NEAR(x * x + y * y + z * z, 1, 1e-9);
        return made;
    }

private:
    const mesh3d& control_;
    Scheme scheme_;
    kith::surface_locator<Scheme, std::uint32_t> surface_;
    kith::storage<point> limits_;
};

template <class Scheme>
kith::tessellation<point> expect_conforming(const mesh3d& control, const Scheme& scheme,
                                            const tessellation_options& options)
{
    return checked_surface(control, scheme).expect_conforming(options);
}

TEST(tessellate, fits_together_on_all_shapes)
{
    const auto test = [](const auto& scheme, const mesh3d& mesh) {
        if constexpr (kith::parametric_scheme<std::remove_cvref_t<decltype(scheme)>>) {
            using domain = kith::detail::domain_of<std::remove_cvref_t<decltype(scheme)>>;
            if (domain::is_cut_off_by_boundaries and not mesh.topology().is_closed())
                return;
            checked_surface surface(mesh, scheme);
            for (const auto& options : {tessellation_options{.segments = 1},
                                        tessellation_options{.segments = 3},
                                        tessellation_options{.chord_error = .02},
                                        tessellation_options{.longest_edge = .4},
                                        tessellation_options{.angle = .3}})
                surface.expect_conforming(options);
        }
    };
    for_each_scheme_and_shape(test);
}

TEST(tessellate, cuts_edges_into_segments)
{
    const auto quads = native(shapes::shaken(shapes::torus(4, 5)));
    const auto c = count(quads.topology());
    for (const std::size_t n : {2, 5}) {
        const auto made = expect_conforming(quads, kith::catmull_clark{}, {.segments = n});
        EXPECT_EQ(made.mesh.vertex_count(), c.vertices + (n - 1) * c.edges + (n - 1) * (n - 1) * c.faces);
        EXPECT_EQ(made.mesh.face_count(), 2 * n * n * c.faces);
    }
    const auto triangles = native(shapes::triangulated(shapes::cube()));
    const auto made = expect_conforming(triangles, kith::loop{}, {.segments = 4});
    EXPECT_EQ(made.mesh.face_count(), 16 * triangles.face_count());
    EXPECT_EQ(expect_conforming(triangles, kith::loop{}, {}).mesh.face_count(), triangles.face_count());
}

/// Returns the largest distance of the surface to the planes of the triangles, at some places in each triangle.
template <class Scheme>
double largest_distance(const mesh3d& control, const Scheme& scheme, const kith::tessellation<point>& made)
{
    kith::surface_locator surface(control, scheme);
    double largest = 0;
    for (std::size_t f = 0; f < made.mesh.face_count(); ++f) {
        const auto v = made.mesh.face(f);
        const auto difference = [](const point& a, const point& b) {
            return point{a[0] - b[0], a[1] - b[1], a[2] - b[2]};
        };
        const point& p = made.mesh.point(v[0]);
        const auto normal = kith::unit_normal(difference(made.mesh.point(v[1]), p),
                                              difference(made.mesh.point(v[2]), p));
        if (not normal or made.places[v[0]].face != made.faces[f] or made.places[v[1]].face != made.faces[f] or
            made.places[v[2]].face != made.faces[f] or made.places[v[0]].corner != made.places[v[1]].corner or
            made.places[v[0]].corner != made.places[v[2]].corner)
            continue; // its parameters belong to another face
        std::vector<kith::surface_place> places;
        for (const auto& w : {point{.4, .3, .3}, point{.6, .2, .2}, point{.15, .7, .15}, point{.1, .45, .45}}) {
            kith::surface_place place{made.faces[f], 0, 0, made.places[v[0]].corner};
            for (std::size_t k = 0; k < 3; ++k) {
                place.u += w[k] * made.places[v[k]].u;
                place.v += w[k] * made.places[v[k]].v;
            }
            places.push_back(place);
        }
        for (const point& q : surface.locate(places).evaluate(control.points()).points) {
            const auto d = difference(q, p);
            largest = std::max(largest, std::abs(d[0] * (*normal)[0] + d[1] * (*normal)[1] + d[2] * (*normal)[2]));
        }
    }
    return largest;
}

TEST(tessellate, keeps_to_a_chord_error)
{
    for (const double error : {.05, .004}) {
        const auto quads = native(shapes::shaken(shapes::pentacube()));
        kith::catmull_clark creased;
        for (std::size_t e = 0; e < quads.edge_count(); e += 3)
            creased.sharpness.sharpen_edge(e, e % 2 == 0 ? kith::infinitely_sharp : 1.5);
        const auto made = expect_conforming(quads, creased, {.chord_error = error});
        EXPECT_LT(largest_distance(quads, creased, made), 1.1 * error);
        const auto triangles = native(shapes::shaken(shapes::triangulated(shapes::torus(5, 6))));
        const auto of_triangles = expect_conforming(triangles, kith::loop{}, {.chord_error = error});
        EXPECT_LT(largest_distance(triangles, kith::loop{}, of_triangles), 1.1 * error);
        EXPECT_GT(of_triangles.mesh.face_count(), triangles.face_count());
    }
}

TEST(tessellate, keeps_to_an_edge_length)
{
    const auto mesh = native(shapes::shaken(shapes::torus(5, 6)));
    const auto made = expect_conforming(mesh, kith::catmull_clark{}, {.longest_edge = .15});
    for (std::size_t f = 0; f < made.mesh.face_count(); ++f)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto v = made.mesh.face(f);
            const point &a = made.mesh.point(v[k]), &b = made.mesh.point(v[(k + 1) % 3]);
            EXPECT_LE(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), .15);
        }
}

TEST(tessellate, has_the_same_bits_on_any_number_of_threads)
{
    const auto mesh = native(shapes::shaken(shapes::triangulated(shapes::torus(8, 9))));
    const auto one = tessellate(mesh, kith::catmull_clark{}, {.segments = 6});
    const thread_count three(3);
    const auto other = tessellate(mesh, kith::catmull_clark{}, {.segments = 6});
    EXPECT_TRUE(std::ranges::equal(one.mesh.points(), other.mesh.points()));
    EXPECT_TRUE(std::ranges::equal(one.normals, other.normals));
    EXPECT_TRUE(std::ranges::equal(one.places, other.places));
    EXPECT_TRUE(std::ranges::equal(one.mesh.topology().corner_vertex, other.mesh.topology().corner_vertex));
    EXPECT_TRUE(std::ranges::equal(one.mesh.topology().halfedge_corner, other.mesh.topology().halfedge_corner));
}

TEST(tessellate, carries_other_values)
{
    const auto mesh = native(shapes::shaken(shapes::house()));
    const auto made = tessellate(mesh, kith::catmull_clark{}, {.segments = 4});
    std::vector<double> heights;
    for (const auto& p : mesh.points())
        heights.push_back(p[2]);
    const auto values = kith::surface_locator(mesh, kith::catmull_clark{}).locate(made.places).evaluate(heights).points;
    for (std::size_t v = 0; v < values.size(); ++v)
        EXPECT_NEAR(values[v], made.mesh.point(v)[2], 1e-13);
}

TEST(tessellate, refuses_options_that_make_no_sense)
{
    const auto mesh = native(shapes::cube());
    const auto text = [&](const tessellation_options& options) {
        return error_text<kith::mesh_error>(
            [&] { static_cast<void>(tessellate(mesh, kith::catmull_clark{}, options)); });
    };
    const std::string positive = "tessellate: segments, longest edge, chord error and angle must be positive";
    EXPECT_EQ(text({.segments = 0}), positive);
    EXPECT_EQ(text({.chord_error = -1}), positive);
    EXPECT_EQ(text({.longest_edge = std::numeric_limits<double>::quiet_NaN()}), positive);
    EXPECT_EQ(text({.segments = 5000}), "tessellate: an edge would have more than 4096 segments; ask for less");
    EXPECT_EQ(text({.chord_error = 1e-12}), "tessellate: an edge would have more than 4096 segments; ask for less");
}

} // namespace
