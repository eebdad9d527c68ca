// SPDX-License-Identifier: BSD-3-Clause
// No function may cost more than O(n log n) in a valence or in the degree of a face. The tests measure no times: they
// count the additions of values and the steps from half-edge to half-edge.
#include "support/large_shapes.hpp"
#include "support/native_shape.hpp"

#include <kith/butterfly.hpp>
#include <kith/catmull_clark.hpp>
#include <kith/doo_sabin.hpp>
#include <kith/four_eight.hpp>
#include <kith/hierarchy.hpp>
#include <kith/interpolatory_sqrt3.hpp>
#include <kith/kobbelt.hpp>
#include <kith/linear.hpp>
#include <kith/loop.hpp>
#include <kith/make_creases.hpp>
#include <kith/mid_edge.hpp>
#include <kith/nasri_hasbini.hpp>
#include <kith/sqrt3.hpp>
#include <kith/unified.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace {

std::size_t work = 0;

/// A native mesh whose walks are counted.
struct counting_mesh : mesh3d {
    counting_mesh(mesh3d mesh) : mesh3d(std::move(mesh)) {}
};
/// A number whose sums are counted.
struct counted {
    double value;
};

} // namespace

template <>
struct kith::mesh_traits<counting_mesh> : kith::mesh_traits<mesh3d> {
    using native = kith::mesh_traits<mesh3d>;
    static halfedge next(const counting_mesh& m, halfedge h) { return ++work, native::next(m, h); }
    static halfedge prev(const counting_mesh& m, halfedge h) { return ++work, native::prev(m, h); }
    static halfedge opposite(const counting_mesh& m, halfedge h) { return ++work, native::opposite(m, h); }
    static counting_mesh build(mesh3d&& fine) { return {std::move(fine)}; }
};

template <>
struct kith::affine<counted> {
    using scalar = double;
    using sum = counted;
    static counted load(counted x) { return x; }
    static counted store(counted x) { return x; }
    static void add(counted& total, counted more) { ++work, total.value += more.value; }
    static void scale(counted& total, double weight) { ++work, total.value *= weight; }
};

namespace {

/// Returns the number of walks and sums in one step.
template <class Scheme>
std::size_t work_of(const mesh3d& mesh, const Scheme& scheme)
{
    work = 0;
    kith::hierarchy levels(counting_mesh(mesh), scheme);
    levels.refine();
    const std::vector<counted> values(mesh.vertex_count(), counted{1});
    const auto fine = levels.carry(0, 1, std::span<const counted>(values));
    EXPECT_NEAR(fine[fine.size() / 2].value, 1, 1e-12);
    return work;
}

/// Expects that the work of a step grows no faster than n log n in the size n of a shape. `prepare` changes the mesh of
/// the shape; scheme_of(mesh) returns the scheme.
template <class SchemeOf>
void expect_no_squares(
    const char* name, shapes::shape (*make)(std::size_t), const SchemeOf& scheme_of,
    mesh3d (*prepare)(const mesh3d&) = [](const mesh3d& mesh) { return mesh; })
{
    constexpr std::size_t n = 100;
    const auto work_at = [&](std::size_t size) {
        const auto mesh = prepare(native(make(size)));
        return double(work_of(mesh, scheme_of(mesh))) / (double(size) * std::log(double(size)));
    };
    const double small = work_at(n), large = work_at(4 * n);
    EXPECT_LT(large, 1.1 * small) << name;
}
template <class Scheme>
auto always(const Scheme& scheme)
{
    return [scheme](const auto&) { return scheme; };
}

} // namespace

TEST(degree_work, of_polygons)
{
    for (const auto shape : {shapes::prism, shapes::polygon}) {
        expect_no_squares("catmull-clark", shape, always(kith::catmull_clark()));
        for (const auto boundary :
             {kith::doo_sabin_boundary::thesis, kith::doo_sabin_boundary::clamped, kith::doo_sabin_boundary::drop})
            expect_no_squares("doo-sabin", shape, always(kith::doo_sabin{.boundary = boundary}));
        expect_no_squares("nasri-hasbini", shape, always(kith::nasri_hasbini()));
        expect_no_squares("linear", shape, always(kith::linear()));
        expect_no_squares("mid-edge", shape, always(kith::mid_edge()));
        expect_no_squares("4-8", shape, always(kith::four_eight()), [](const mesh3d& m) { return kith::tri_quad(m); });
    }
    expect_no_squares("unified", shapes::prism, always(kith::unified{.degree = 4}));
    expect_no_squares("unified", shapes::prism, always(kith::unified{.degree = 5}));
}

TEST(degree_work, of_fans)
{
    expect_no_squares("loop", shapes::double_pyramid, always(kith::loop()));
    expect_no_squares("sqrt3", shapes::double_pyramid, always(kith::sqrt3()));
    expect_no_squares("butterfly", shapes::double_pyramid, always(kith::butterfly()));
    expect_no_squares("interpolatory-sqrt3", shapes::double_pyramid, always(kith::interpolatory_sqrt3()));
    expect_no_squares("linear-triangles", shapes::double_pyramid, always(kith::linear_triangles()));
    expect_no_squares("doo-sabin", shapes::double_pyramid, always(kith::doo_sabin()));
    expect_no_squares("nasri-hasbini", shapes::double_pyramid, always(kith::nasri_hasbini()));
    expect_no_squares("mid-edge", shapes::double_pyramid, always(kith::mid_edge()));
    expect_no_squares("unified", shapes::double_pyramid, always(kith::unified{.degree = 4}));
    for (const auto shape : {shapes::quads_around}) {
        expect_no_squares("catmull-clark", shape, always(kith::catmull_clark()));
        expect_no_squares("kobbelt", shape, always(kith::kobbelt()));
        expect_no_squares("nasri-hasbini", shape, always(kith::nasri_hasbini()));
        expect_no_squares("4-8", shape, always(kith::four_eight()), [](const mesh3d& m) { return kith::tri_quad(m); });
    }
}

TEST(degree_work, of_creases)
{
    for (const auto method : {kith::crease_method::uniform, kith::crease_method::chaikin}) {
        const auto sharp = [method](const mesh3d& mesh) {
            return kith::make_creases(
                mesh, [](auto e) { return double(e.value % 3) / 2 + 1; }, [](auto) { return 0.; }, method);
        };
        expect_no_squares("catmull-clark with creases", shapes::quads_around, [&](const mesh3d& mesh) {
            return kith::catmull_clark{.sharpness = sharp(mesh)};
        });
        expect_no_squares("loop with creases", shapes::double_pyramid, [&](const mesh3d& mesh) {
            return kith::loop{.sharpness = sharp(mesh)};
        });
    }
}
