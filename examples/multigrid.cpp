// SPDX-License-Identifier: BSD-3-Clause
// Solves Poisson's equation on a subdivision surface by multigrid. The prolongations are the matrices of the scheme;
// they turn the finest operator into the coarse ones. Cotangents (Pinkall & Polthier 1993) discretise the levels of
// Loop's scheme. On finer levels the number of V-cycles stays, and the error falls with the square of the mesh width.
// Sample run: multigrid [plot.svg]

#include "v_cycle.hpp"

#include <kith/core/mesh/make_mesh.hpp>
#include <kith/eigen.hpp>
#include <kith/hierarchy.hpp>
#include <kith/loop.hpp>
#include <kith/picture/plot.hpp>

#include <Eigen/Sparse>

#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>
#include <vector>

using mesh = kith::basic_mesh<>;
using vector = Eigen::VectorXd;
using matrix = multigrid::matrix;

/// Makes a bent torus of triangles. Each ring is turned by half an edge against the ring before, so that no triangle is
/// long and thin.
mesh control_mesh()
{
    constexpr std::size_t around = 20, across = 6;
    std::vector<std::array<double, 3>> points;
    std::vector<std::array<std::size_t, 3>> faces;
    for (std::size_t i = 0; i < around; ++i)
        for (std::size_t j = 0; j < across; ++j) {
            const double a = 2 * std::numbers::pi * double(i) / around;
            const double b = 2 * std::numbers::pi * (double(j) + double(i) / 2) / across;
            const double r = 3 + .4 * std::cos(2 * a) + std::cos(b);
            points.push_back({r * std::cos(a), r * std::sin(a), std::sin(b) + .5 * std::sin(3 * a)});
            const auto at = [&](std::size_t k, std::size_t l) {
                return k % around * across + (l + k / around * around / 2) % across;
            };
            faces.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
            faces.push_back({at(i, j + 1), at(i + 1, j), at(i + 1, j + 1)});
        }
    return kith::make_mesh(points, faces);
}

/// The stiffness matrix and the lumped masses of linear elements on a triangle mesh.
struct discretisation {
    matrix stiffness;
    vector mass;
};
discretisation discretise(const mesh& m)
{
    std::vector<Eigen::Triplet<double>> entries;
    vector mass = vector::Zero(Eigen::Index(m.vertex_count()));
    for (std::size_t f = 0; f < m.face_count(); ++f)
        for (int corner = 0; corner < 3; ++corner) {
            const auto at = [&](int c) { return Eigen::Index(m.face(f)[std::size_t(c % 3)]); };
            const auto i = at(corner + 1), j = at(corner + 2);
            const auto point = [&](Eigen::Index v) { return Eigen::Vector3d(m.point(std::size_t(v)).data()); };
            const Eigen::Vector3d a = point(i) - point(at(corner)), b = point(j) - point(at(corner));
            const double twice_area = a.cross(b).norm(), half_cotangent = a.dot(b) / twice_area / 2;
            for (const auto& [row, column, sign] :
                 {std::array{i, i, Eigen::Index(1)}, {j, j, 1}, {i, j, -1}, {j, i, -1}})
                entries.emplace_back(row, column, double(sign) * half_cotangent);
            mass[at(corner)] += twice_area / 6;
        }
    matrix stiffness(mass.size(), mass.size());
    stiffness.setFromTriplets(entries.begin(), entries.end());
    return {stiffness, mass};
}

struct solution {
    vector values; ///< with mean 0
    int cycles = 0;
};
solution solve(const mesh& m, const std::vector<matrix>& prolongations)
{
    const auto [stiffness, mass] = discretise(m);
    const auto without_mean = [&mass = mass](const vector& x) -> vector {
        return x.array() - mass.dot(x) / mass.sum();
    };
    vector source(mass.size());
    for (Eigen::Index v = 0; v < mass.size(); ++v) {
        const auto& [x, y, z] = m.point(std::size_t(v));
        source[v] = x * y + std::sin(2 * z);
    }
    const vector b = mass.cwiseProduct(without_mean(source));
    const multigrid solver(stiffness, prolongations);
    solution result{vector::Zero(mass.size())};
    while (result.cycles < 100 and (b - stiffness * result.values).norm() > 1e-10 * b.norm()) {
        solver.cycle(result.values, b);
        ++result.cycles;
    }
    result.values = without_mean(result.values);
    return result;
}

/// Draws errors and numbers of cycles over the level.
void draw(const char* file, const std::vector<int>& cycles, const std::vector<double>& errors)
{
    const auto over_levels = [](double first, const auto& values) {
        kith::picture::curve curve{.paint = {.12F, .38F, .55F}};
        for (const auto value : values)
            curve.points.push_back({first + double(curve.points.size()), double(value)});
        return curve;
    };
    std::ofstream svg(file);
    kith::picture::write_svg(svg,
                             {kith::picture::plot{.title = "Largest change to the level before",
                                                  .x = {"level"},
                                                  .y = {.is_logarithmic = true},
                                                  .curves = {over_levels(3, errors)},
                                                  .height = 140},
                              kith::picture::plot{.title = "V-cycles to 1e-10",
                                                  .x = {"level"},
                                                  .y = {},
                                                  .curves = {over_levels(2, cycles)},
                                                  .height = 140}});
}

int main(int count, char** arguments)
{
    constexpr int finest = 6;
    kith::hierarchy<mesh, kith::loop> levels(control_mesh());
    levels.refine(finest);

    std::vector<matrix> prolongations;
    std::vector<int> cycles;
    std::vector<double> errors; // of each level, compared with the next finer one
    vector coarser;
    std::printf("level  vertices  V-cycles  largest change to the level before\n");
    for (int level = 1; level <= finest; ++level) {
        const auto p = levels.matrix(level - 1, level);
        prolongations.emplace_back(kith::as_eigen(p));
        if (level < 2)
            continue;
        const auto [values, n] = solve(levels[level], prolongations);
        cycles.push_back(n);
        std::printf("%5d %9zu %9d", level, levels[level].vertex_count(), n);
        if (level > 2) { // the first vertices are those of the level before
            errors.push_back((values.head(coarser.size()) - coarser).cwiseAbs().maxCoeff() /
                             values.cwiseAbs().maxCoeff());
            std::printf("  %.2e", errors.back());
        }
        std::printf("\n");
        coarser = values;
    }
    if (count > 1)
        draw(arguments[1], cycles, errors);
    for (std::size_t i = 0; i < cycles.size(); ++i)
        if (cycles[i] > 15 or (i > 1 and i < errors.size() and errors[i] > errors[i - 1] / 3))
            return 1;
}
