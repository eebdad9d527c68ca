// SPDX-License-Identifier: BSD-3-Clause
#include "support/local_matrix.hpp"

#include <kith/compiled_schemes.hpp>
#include <kith/core/base/exact_cos.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <vector>

// Computes local subdivision matrices from the schemes' own stencil rows. Their eigenvalues are those of
// docs/schemes.md and of the papers. The limit and tangent masks are their left eigenvectors.

namespace {

mesh3d triangles_around(std::size_t n, int splits = 2)
{
    return kith::refine(native(shapes::umbrella(n)), kith::linear_triangles(), splits);
}
mesh3d quads_around(std::size_t n, int splits = 2)
{
    return kith::refine(native(quad_umbrella(n)), kith::linear(), splits);
}
/// Makes four rings of quads around face 0, which has n corners.
mesh3d quads_around_face(std::size_t n)
{
    return kith::refine(native(shapes::polygon(n)), kith::nasri_hasbini(), 2);
}

/// The tolerance for defective matrices: eigenvalues that coincide without as many eigenvectors lose half of the digits
/// or more.
constexpr double defective = 1e-5;

/// Expects that the matrix depends on the patch alone, and that its largest eigenvalues are these.
void expect_spectrum(const local_matrix& local, const std::vector<double>& largest, double tolerance = 1e-12)
{
    EXPECT_EQ(local.leak, 0);
    const auto values = local.spectrum();
    ASSERT_GE(values.size(), largest.size());
    for (std::size_t i = 0; i < largest.size(); ++i)
        EXPECT_NEAR(values[i], largest[i], tolerance) << "eigenvalue " << i;
}

/// Expects that the mask of the position is a left eigenvector to the eigenvalue 1 whose weights sum to one.
void expect_position(const local_matrix& local)
{
    ASSERT_EQ(local.position[0].rows(), 1);
    ASSERT_EQ(local.position[1].rows(), 1);
    EXPECT_NEAR(local.position[0].sum(), 1, 1e-14);
    EXPECT_LT((local.position[1] * local.matrix - local.position[0]).cwiseAbs().maxCoeff(), 1e-14);
}

/// Expects that the masks of the tangents span the left eigenvectors of a pair of eigenvalues of this modulus.
void expect_tangents(const local_matrix& local, double modulus)
{
    const auto &coarse = local.tangents[0], &fine = local.tangents[1];
    ASSERT_EQ(coarse.rows(), 2);
    ASSERT_EQ(fine.rows(), 2);
    const Eigen::MatrixXd image = fine * local.matrix;
    const Eigen::MatrixXd change = coarse.transpose().colPivHouseholderQr().solve(image.transpose()).transpose();
    const double size = coarse.cwiseAbs().maxCoeff();
    EXPECT_LT((change * coarse - image).cwiseAbs().maxCoeff(), 1e-13 * size);
    EXPECT_NEAR(coarse.rowwise().sum().cwiseAbs().maxCoeff(), 0, 1e-13 * size);
    const Eigen::VectorXcd values = change.eigenvalues();
    for (const auto& value : values)
        EXPECT_NEAR(std::abs(value), modulus, 1e-13);
}

double cosine(std::size_t turns, std::size_t n)
{
    return kith::exact_cos(std::int64_t(turns), std::int64_t(n));
}

/// Returns Catmull-Clark's subdominant eigenvalue for valence n by the formulas of Doo & Sabin and of Ball & Storry.
double catmull_clark_eigenvalue(std::size_t n)
{
    const double c = cosine(1, n), half = cosine(1, 2 * n);
    return 5. / 16 + (c + half * std::sqrt(2 * (9 + c))) / 16;
}

} // namespace

TEST(spectrum, catmull_clark)
{
    const std::map<std::size_t, double> next{
        {3, .16667}, {4, .25}, {5, .34011}, {6, .41010}, {7, .46186}, {8, .5}, {12, .57968}, {20, .62634}};
    for (std::size_t n = 3; n <= 20; ++n) {
        SCOPED_TRACE(n);
        const auto local = matrix_around_vertex(quads_around(n), kith::catmull_clark(), 0, 1, 2);
        const double l = catmull_clark_eigenvalue(n);
        expect_spectrum(local, {1, l, l});
        if (const auto mu = next.find(n); mu != next.end()) {
            EXPECT_NEAR(local.spectrum()[3], mu->second, 5e-6);
        }
        expect_position(local);
        expect_tangents(local, l);
    }
}

TEST(spectrum, loop)
{
    const std::map<std::size_t, double> next{{4, .140625}, {5, .20453}, {6, .25}, {7, .31937}, {8, .375}, {12, .5}};
    for (std::size_t n = 3; n <= 20; ++n) {
        SCOPED_TRACE(n);
        const double l = 3. / 8 + cosine(1, n) / 4;
        const auto local = matrix_around_vertex(triangles_around(n), kith::loop(), 0, 1, 2);
        expect_spectrum(local, {1, l, l});
        if (const auto mu = next.find(n); mu != next.end()) {
            EXPECT_NEAR(local.spectrum()[3], mu->second, 5e-6);
        }
        const kith::loop warren{.weights = kith::loop_weights::warren, .corners = {}, .sharpness = {}};
        for (const auto& each : {local, matrix_around_vertex(triangles_around(n), warren, 0, 1, 2)}) {
            expect_position(each);
            expect_tangents(each, l);
        }
    }
}

TEST(spectrum, boundary_of_catmull_clark)
{
    for (std::size_t k = 2; k <= 11; ++k) {
        SCOPED_TRACE(k);
        const auto mesh = kith::refine(native(half_quad_umbrella(k)), kith::linear(), 2);
        const auto local = matrix_around_vertex(mesh, kith::catmull_clark(), 0, 1, 2);
        EXPECT_EQ(local.leak, 0);
        expect_position(local);
        const Eigen::MatrixXd image = local.tangents[1] * local.matrix;
        EXPECT_LT((image.row(0) - .5 * local.tangents[0].row(0)).cwiseAbs().maxCoeff(), 1e-14);
        const double l = catmull_clark_eigenvalue(2 * k);
        EXPECT_LT((image.row(1) - l * local.tangents[0].row(1)).cwiseAbs().maxCoeff(), 2e-13 * double(k));
    }
}

TEST(spectrum, boundary_of_loop)
{
    for (std::size_t k = 2; k <= 11; ++k) {
        SCOPED_TRACE(k);
        const auto mesh = kith::refine(native(half_umbrella(k)), kith::linear_triangles(), 2);
        const auto local = matrix_around_vertex(mesh, kith::loop(), 0, 1, 2);
        EXPECT_EQ(local.leak, 0);
        expect_position(local);
        const Eigen::MatrixXd image = local.tangents[1] * local.matrix;
        EXPECT_LT((image.row(0) - .5 * local.tangents[0].row(0)).cwiseAbs().maxCoeff(), 1e-14);
        const double l = 3. / 8 + cosine(1, 2 * k) / 4;
        EXPECT_LT((image.row(1) - l * local.tangents[0].row(1)).cwiseAbs().maxCoeff(), 2e-13 * double(k));
    }
}

TEST(spectrum, doo_sabin)
{
    for (std::size_t n = 3; n <= 20; ++n) {
        SCOPED_TRACE(n);
        const auto local = matrix_around_face(quads_around_face(n), kith::doo_sabin(), 0, 1, 1);
        expect_spectrum(local, {1, .5, .5});
        expect_spectrum(local, {1, .5, .5, .25}, defective);
        expect_position(local);
        expect_tangents(local, .5);
    }
}

TEST(spectrum, doo_sabin_by_averaging)
{
    const kith::doo_sabin averaging{.weights = kith::doo_sabin_weights::averaging};
    for (std::size_t n = 3; n <= 20; ++n) {
        SCOPED_TRACE(n);
        const double l = 1. / 2 + cosine(1, n) / 4; // .375 for valence 3, .625 for valence 6
        const auto local = matrix_around_face(quads_around_face(n), averaging, 0, 1, 1);
        expect_spectrum(local, {1, l, l});
        expect_position(local);
        expect_tangents(local, l);
    }
}

TEST(spectrum, sqrt3)
{
    for (std::size_t n = 3; n <= 20; ++n) {
        SCOPED_TRACE(n);
        const double l = 2. / 3 * cosine(1, 2 * n);
        const auto local = matrix_around_vertex(triangles_around(n), kith::sqrt3(), 0, 1, 2);
        expect_spectrum(local, {1, l, l});
        const auto values = local.spectrum();
        EXPECT_TRUE(std::ranges::any_of(values, [l](double x) { return std::abs(x - l * l) < 1e-12; })); // the center
        expect_position(local);
        expect_tangents(local, l);
    }
}

TEST(spectrum, butterfly)
{
    for (std::size_t n = 3; n <= 20; ++n) {
        SCOPED_TRACE(n);
        // Quadratics give one, two or three eigenvalues 1/4. The regular rule reaches two rings and has more of them,
        // then 3/16.
        std::vector<double> largest{1, .5, .5};
        largest.resize(n == 6 ? 10 : 3 + std::min<std::size_t>(n - 2, 3), .25);
        largest.push_back(n == 6 ? 3. / 16 : 1. / 8);
        const auto local = matrix_around_vertex(triangles_around(n, 3), kith::butterfly(), 0, 1, 3);
        expect_spectrum(local, {1, .5, .5});
        expect_spectrum(local, largest, defective);
        expect_position(local);
        expect_tangents(local, .5);
    }
}

TEST(spectrum, kobbelt)
{
    struct row {
        std::size_t n;
        double l, next;
    };
    for (const auto& [n, l, next] : {row{3, .42633, .25},
                                     row{4, .5, .25},
                                     row{5, .53794, .36193},
                                     row{6, .55968, .42633},
                                     row{7, .57320, .46972},
                                     row{8, .58213, .5},
                                     row{12, .59870, .55968}}) {
        SCOPED_TRACE(n);
        const auto local = matrix_around_vertex(quads_around(n, 3), kith::kobbelt(), 0, 1, 3);
        expect_spectrum(local, {1, l, l, next}, 6e-6);
        expect_position(local);
    }
    for (const double tension : {.5, 1., 2.})
        expect_tangents(matrix_around_vertex(quads_around(4, 3), kith::kobbelt{.tension = tension}, 0, 1, 3), .5);
}

TEST(spectrum, nasri_hasbini)
{
    for (std::size_t n = 3; n <= 20; ++n) {
        SCOPED_TRACE(n);
        const auto local = matrix_around_vertex(quads_around(n), kith::nasri_hasbini(), 0, 1, 1);
        expect_spectrum(local, {1, 1. / 3, 1. / 3, 1. / 9});
        expect_position(local);
        expect_tangents(local, 1. / 3);
    }
}

TEST(spectrum, faces_of_nasri_hasbini)
{
    const std::map<std::size_t, double> further{
        {3, .0569}, {5, .0690}, {6, .1111}, {7, .1181}, {8, .1286}, {12, .1553}, {20, .1731}};
    for (const auto& [m, value] : further) {
        SCOPED_TRACE(m);
        const auto local = matrix_around_face(quads_around_face(m), kith::nasri_hasbini(), 0, 1, 1);
        expect_spectrum(local, {1, 1. / 3, 1. / 3});
        EXPECT_NEAR(
            local.spectrum()[3], std::max(value, 1. / 9), 1e-4); // the largest of the rest is at least that of the cup
        const auto values = local.spectrum();
        EXPECT_TRUE(std::ranges::any_of(values, [&](double x) { return std::abs(x - value) < 1e-4; }));
    }
}

TEST(spectrum, four_eight)
{
    struct row {
        std::size_t n;
        double l, next;
    };
    for (const auto& [n, l, next] : {row{3, .40831, .25},
                                     row{4, .5, .25},
                                     row{5, .55132, .33801},
                                     row{6, .58187, .40831},
                                     row{7, .60125, .46098},
                                     row{8, .61423, .5},
                                     row{12, .63862, .58187}}) {
        SCOPED_TRACE(n);
        const auto local = matrix_around_vertex(kith::tri_quad(quads_around(n)), kith::four_eight(), 1, 3, 4);
        expect_spectrum(local, {1, l, l, next}, 6e-6);
    }
    for (std::size_t n = 3; n <= 20; ++n) {
        SCOPED_TRACE(n);
        const auto local = matrix_around_vertex(kith::tri_quad(quads_around(n)), kith::four_eight(), 1, 3, 4);
        const double rho = kith::limit_rules<kith::four_eight>::subdominant(std::int64_t(n));
        expect_spectrum(local, {1, rho * rho, rho * rho});
        expect_position(local);
        expect_tangents(local, rho * rho);
    }
}

TEST(spectrum, mid_edge)
{
    for (std::size_t m = 4; m <= 20; ++m) {
        SCOPED_TRACE(m);
        const double l = cosine(1, 2 * m) * cosine(1, 2 * m);
        expect_spectrum(matrix_around_face(quads_around_face(m), kith::mid_edge(), 0, 2, 1), {1, l, l});
    }
}

TEST(spectrum, linear)
{
    for (std::size_t n = 3; n <= 20; ++n) {
        SCOPED_TRACE(n);
        const auto quads = matrix_around_vertex(quads_around(n), kith::linear(), 0, 1, 1);
        const auto triangles = matrix_around_vertex(triangles_around(n), kith::linear_triangles(), 0, 1, 1);
        for (const auto& local : {quads, triangles}) {
            expect_spectrum(local, {1, .5, .5});
            expect_position(local);
        }
    }
}

TEST(spectrum, four_eight_is_the_four_directional_box_spline)
{
    // Rows of (v) have weights 1/2 and four times 1/8; rows of (e) have four times 1/4. This is the symbol with each
    // direction twice, of degree six.
    const auto mesh = kith::tri_quad(native(shapes::torus(6, 6)));
    kith::hierarchy levels(mesh, kith::four_eight());
    levels.refine(1);
    const auto matrix = levels.matrix(0, 1);
    for (std::size_t i = 0; i < matrix.rows(); ++i) {
        std::vector<double> row(matrix.weight.begin() + matrix.row_start[i],
                                matrix.weight.begin() + matrix.row_start[i + 1]);
        std::ranges::sort(row, std::greater());
        EXPECT_EQ(row, i < 36 ? (std::vector{.5, .125, .125, .125, .125}) : (std::vector{.25, .25, .25, .25}));
    }
}

namespace {

/// Returns the height of a cubic over a point of the plane.
double cubic(double x, double y)
{
    return 1 + x - 2 * y + x * x / 2 - x * y + y * y / 4 + x * x * x / 8 - x * x * y / 3 + x * y * y - y * y * y / 5;
}
template <class Scheme>
void expect_cubics(shapes::shape flat, const Scheme& scheme)
{
    for (auto& p : flat.points)
        p[2] = cubic(p[0], p[1]);
    const auto fine = kith::refine(native(flat), scheme, 1);
    std::size_t inside = 0;
    for (std::size_t v = 0; v < fine.vertex_count(); ++v) {
        const auto& p = fine.point(v);
        if (p[0] < 3 or p[0] > 5 or p[1] < 3 or p[1] > 5)
            continue;
        EXPECT_NEAR(p[2], cubic(p[0], p[1]), 1e-12) << p[0] << ", " << p[1];
        ++inside;
    }
    EXPECT_EQ(inside, 25U);
}

} // namespace

TEST(spectrum, butterfly_reproduces_cubics)
{
    expect_cubics(shapes::triangulated(shapes::grid(8, 8)), kith::butterfly());
}

TEST(spectrum, kobbelt_reproduces_cubics)
{
    expect_cubics(shapes::grid(8, 8), kith::kobbelt());
}
