// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../../tests/support/figures.hpp"

#include <kith/compiled_schemes.hpp>
#include <kith/core/mesh/make_mesh.hpp>
#include <kith/plan.hpp>

#include <cmath>
#include <concepts>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace kith::comparison {

/// The settings of the benchmark: the meshes to refine, and the number of faces to reach.
struct course_settings {
    double faces_target;
    bool torus = true, patch = false;              ///< a closed and a bounded mesh, of quads or triangles
    std::string mesh_name = {};                    ///< name of the mesh that was read from a file
    std::shared_ptr<const basic_mesh<>> mesh = {}; ///< mesh that was read from a file, or none
};

/// A control mesh and the number of levels, at least one, that brings it nearest to the wanted number of faces.
struct course {
    std::string name;
    std::shared_ptr<const basic_mesh<>> control;
    int levels;
    std::uint64_t faces; ///< on the last level
};

template <class Scheme>
course make_course(std::string name, std::shared_ptr<const basic_mesh<>> control, const Scheme& scheme, double target)
{
    const auto faces_after = [&](int levels) {
        return plan(count(control->topology()), scheme, levels).back().counts.faces;
    };
    course result{std::move(name), control, 1, faces_after(1)};
    for (int levels = 2;; ++levels) {
        const std::uint64_t faces = faces_after(levels);
        if (std::abs(std::log(double(faces) / target)) > std::abs(std::log(double(result.faces) / target)))
            return result;
        result.levels = levels;
        result.faces = faces;
    }
}

/// Makes a bounded mesh: a torus without the faces that close it.
inline figures::shape patch(std::size_t rows, std::size_t columns)
{
    figures::shape result = figures::torus(rows, columns);
    std::erase_if(result.faces,
                  [columns](const auto& face) { return face[2] < face[0] or face[2] % columns < face[0] % columns; });
    return result;
}

/// Makes the courses of a scheme: a torus, the same mesh with a boundary, and the mesh of the file if the scheme takes
/// it. The torus has 12 times 24 quads, cut into triangles for schemes that need them. Loop and butterfly, which
/// quadruple triangles, get 24 times 24. For 4-8 all meshes become tri-quad meshes.
template <class Scheme>
std::vector<course> courses(const Scheme& scheme, const course_settings& settings)
{
    constexpr bool quadruples_triangles = std::same_as<Scheme, loop> or std::same_as<Scheme, butterfly>;
    constexpr bool bisects = std::same_as<Scheme, four_eight>;
    constexpr std::size_t rows = quadruples_triangles ? 24 : 12, columns = 24;
    std::vector<course> result;
    const auto prepared = [](basic_mesh<> mesh) {
        if constexpr (bisects)
            mesh = tri_quad(mesh);
        return std::make_shared<const basic_mesh<>>(std::move(mesh));
    };
    const auto add = [&](std::string name, figures::shape shape) {
        if (needs_triangles<Scheme> and not bisects)
            shape = figures::triangulated(shape);
        auto control = prepared(make_mesh(shape.points, shape.faces));
        name += " of " + std::to_string(control->face_count()) + (needs_triangles<Scheme> ? " triangles" : " quads");
        result.push_back(make_course(name, control, scheme, settings.faces_target));
    };
    if (settings.torus)
        add("torus", figures::torus(rows, columns));
    if (settings.patch)
        add("patch", patch(rows, columns));
    if (const int degree = settings.mesh ? settings.mesh->topology().degree : 0;
        settings.mesh and (bisects or not needs_triangles<Scheme> or degree == 3) and
        (not needs_quads<Scheme> or degree == 4))
        result.push_back(make_course(settings.mesh_name, prepared(*settings.mesh), scheme, settings.faces_target));
    return result;
}

} // namespace kith::comparison
