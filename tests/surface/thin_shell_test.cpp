// SPDX-License-Identifier: BSD-3-Clause
#include "../../examples/thin_shells/kirchhoff_love.hpp"

#include "support/native_shape.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/loop.hpp>
#include <kith/surface/curvature.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace {

using thin_shells::point;
using thin_shells::vector;

constexpr thin_shells::material steel{2.1, .3, .2};

/// A shell, or the part of a shell whose faces a predicate picks.
template <class Scheme>
struct shell {
    explicit shell(const shapes::shape& s, const std::function<bool(std::size_t)>& is_picked = {})
        : control(s.points.begin(), s.points.end())
    {
        const auto mesh = native(s);
        kith::surface_locator surface(mesh, Scheme());
        const auto all = kith::quadrature_places(mesh, Scheme(), 3);
        for (std::size_t i = 0; i < all.places.size(); ++i)
            if (not is_picked or is_picked(all.places[i].face)) {
                quadrature.places.push_back(all.places[i]);
                quadrature.weights.push_back(all.weights[i]);
            }
        located = surface.locate(quadrature.places);
        stiffness = thin_shells::integrate(located, control, quadrature, steel).stiffness;
    }
    /// Returns the energy of displacements that are a function of the control points.
    [[nodiscard]] double energy(const std::function<point(const point&)>& displacement) const
    {
        const vector u = displacements(displacement);
        return u.dot(stiffness * u) / 2;
    }
    [[nodiscard]] vector displacements(const std::function<point(const point&)>& displacement) const
    {
        vector result(3 * Eigen::Index(control.size()));
        for (std::size_t v = 0; v < control.size(); ++v)
            for (std::size_t axis = 0; axis < 3; ++axis)
                result[Eigen::Index(3 * v + axis)] = displacement(control[v])[axis];
        return result;
    }

    std::vector<point> control;
    kith::surface_quadrature quadrature{};
    kith::located_places located{};
    thin_shells::matrix stiffness{};
};

template <class Scheme>
void expect_no_forces_of_rigid_motions(const shapes::shape& s)
{
    const shell<Scheme> here(s);
    const double size = here.stiffness.norm();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const vector moved = here.displacements([&](const point&) {
            point result{};
            result[axis] = 1;
            return result;
        });
        const vector turned = here.displacements([&](const point& p) {
            point result{};
            result[(axis + 1) % 3] = -p[(axis + 2) % 3];
            result[(axis + 2) % 3] = p[(axis + 1) % 3];
            return result;
        });
        EXPECT_LT((here.stiffness * moved).norm(), 1e-13 * size);
        EXPECT_LT((here.stiffness * turned).norm(), 1e-13 * size);
    }
}

/// Expects the energy of a shell that grows in proportion to its size. Its normals stay, so its fundamental forms grow
/// by the same proportion.
template <class Scheme>
void expect_energy_of_growth(const shapes::shape& s)
{
    const shell<Scheme> here(s);
    const auto at = here.located.evaluate(here.control, kith::derivatives::second);
    const auto curvatures = kith::curvatures_of(at);
    const auto [young, poisson, thickness] = steel;
    double expected = 0;
    for (std::size_t i = 0; i < curvatures.size(); ++i) {
        const double e = Eigen::Vector3d(at.du[i].data()).cross(Eigen::Vector3d(at.dv[i].data())).norm();
        const double stretch = 2 * (1 + poisson);
        const double bending = 4 * curvatures[i].mean * curvatures[i].mean - 2 * (1 - poisson) * curvatures[i].gaussian;
        expected += here.quadrature.weights[i] * e * young * thickness / (1 - poisson * poisson) / 2 *
                    (stretch + thickness * thickness / 12 * bending);
    }
    EXPECT_NEAR(here.energy([](const point& p) { return p; }), expected, 1e-12 * expected);
}

/// Expects the energies of constant strains and curvatures in a plane of `area`. Faces outside of it are ghosts.
template <class Scheme>
void expect_constant_strains(const shell<Scheme>& here, double area)
{
    const auto [young, poisson, thickness] = steel;
    const double stretching = area * young * thickness / (1 - poisson * poisson) / 2;
    const double bending = stretching * thickness * thickness / 12;
    const auto expect = [&](double energy, const std::function<point(const point&)>& displacement) {
        EXPECT_NEAR(here.energy(displacement), energy, 1e-12 * energy);
    };
    expect(stretching, [](const point& p) { return point{p[0], 0, 0}; });
    expect(stretching, [](const point& p) { return point{0, p[1], 0}; });
    expect(stretching * 2 * (1 + poisson), [](const point& p) { return point{p[0], p[1], 0}; });
    expect(stretching * (1 - poisson) / 2, [](const point& p) { return point{p[1], 0, 0}; });
    expect(bending, [](const point& p) { return point{0, 0, p[0] * p[0] / 2}; });
    expect(bending, [](const point& p) { return point{0, 0, p[1] * p[1] / 2}; });
    expect(bending * 2 * (1 - poisson), [](const point& p) { return point{0, 0, p[0] * p[1]}; });
    expect(bending * 2 * (1 + poisson), [](const point& p) { return point{0, 0, (p[0] * p[0] + p[1] * p[1]) / 2}; });
}

} // namespace

TEST(thin_shell, does_not_resist_rigid_motions)
{
    expect_no_forces_of_rigid_motions<kith::catmull_clark>(shapes::shaken(shapes::house()));
    expect_no_forces_of_rigid_motions<kith::loop>(shapes::triangulated(shapes::shaken(shapes::house())));
}

TEST(thin_shell, has_the_energy_of_growth)
{
    expect_energy_of_growth<kith::catmull_clark>(shapes::shaken(shapes::house()));
    expect_energy_of_growth<kith::loop>(shapes::triangulated(shapes::shaken(shapes::house())));
}

TEST(thin_shell, has_the_energy_of_constant_strains)
{
    auto plane = shapes::grid(5, 6);
    for (auto& p : plane.points)
        p[2] = 0;
    const auto is_inside = [](std::size_t quad) { return quad / 6 % 4 != 0 and quad % 6 % 5 != 0; };
    expect_constant_strains(shell<kith::catmull_clark>(plane, is_inside), 12);

    shapes::shape triangles{plane.points, {}};
    for (const auto& f : plane.faces) {
        triangles.faces.push_back({f[0], f[1], f[2]});
        triangles.faces.push_back({f[0], f[2], f[3]});
    }
    expect_constant_strains(shell<kith::loop>(triangles, [&](std::size_t face) { return is_inside(face / 2); }), 12);
}
