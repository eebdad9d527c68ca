// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/butterfly.hpp>
#include <kith/figures.hpp>
#include <kith/loop.hpp>
#include <kith/make_mesh.hpp>
#include <kith/plan.hpp>

#include <cmath>
#include <concepts>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace kith::comparison {

/// What the benchmark refines besides its tori, and how far.
struct course_settings {
    double faces_target;
    std::string mesh_name;                    ///< of the mesh of a file
    std::shared_ptr<const basic_mesh<>> mesh; ///< or none
};

/// A control mesh, refined until it has about as many faces as the settings say.
struct course {
    std::string name;
    std::shared_ptr<const basic_mesh<>> control;
    int levels;
    std::uint64_t faces; ///< of the last level
};

template <class Scheme>
course make_course(std::string name, std::shared_ptr<const basic_mesh<>> control, const Scheme& scheme, double target)
{
    course result{std::move(name), control, 0, control->face_count()};
    for (int levels = 1;; ++levels) {
        const std::uint64_t faces = plan(count(control->topology()), scheme, levels).back().counts.faces;
        if (std::abs(std::log(double(faces) / target)) > std::abs(std::log(double(result.faces) / target)))
            return result;
        result.levels = levels;
        result.faces = faces;
    }
}

/// A torus of 12 times 24 quads, or of their triangles, or of 24 times 24 where triangles are cut in four, so that all
/// come to the same number of faces; then the mesh of the file, if the scheme takes it.
template <class Scheme>
std::vector<course> courses(const Scheme& scheme, const course_settings& settings)
{
    constexpr bool quadruples_triangles = std::same_as<Scheme, loop> or std::same_as<Scheme, butterfly>;
    auto torus = figures::torus(quadruples_triangles ? 24 : 12, 24);
    if (needs_triangles<Scheme>)
        torus = figures::triangulated(torus);
    auto control = std::make_shared<const basic_mesh<>>(make_mesh(torus.points, torus.faces));
    const std::string name = "torus of " + std::to_string(torus.faces.size()) +
                             (needs_triangles<Scheme> ? " triangles" : " quads");
    std::vector<course> result{make_course(name, control, scheme, settings.faces_target)};
    if (settings.mesh and (not needs_triangles<Scheme> or settings.mesh->topology().degree == 3))
        result.push_back(make_course(settings.mesh_name, settings.mesh, scheme, settings.faces_target));
    return result;
}

} // namespace kith::comparison
