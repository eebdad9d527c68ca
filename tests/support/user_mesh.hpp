// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/mesh/make_mesh.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <vector>

/// A mesh type as its users make it, without help from kith. Specializations have these members.
///
///   make(points, faces) -> M     makes a mesh by the library's own functions.
///   tolerance                    error of a coordinate after a few steps, relative to the size of the control mesh.
///   triangles_only               true if all faces are triangles.
///   complaints(mesh) -> string   errors that the library's own checker finds; "" if there are none.
template <class M>
struct user_mesh;

template <class Scalar>
using native_mesh = kith::basic_mesh<std::array<Scalar, 3>>;

template <class Scalar, class Index>
struct user_mesh<kith::basic_mesh<std::array<Scalar, 3>, Index>> {
    static constexpr double tolerance = std::same_as<Scalar, float> ? 1e-6 : 1e-13;

    static auto make(const std::vector<std::array<double, 3>>& points,
                     const std::vector<std::vector<std::size_t>>& faces)
    {
        std::vector<std::array<Scalar, 3>> rounded;
        for (const auto& [x, y, z] : points)
            rounded.push_back({Scalar(x), Scalar(y), Scalar(z)});
        return kith::make_mesh<Index>(rounded, faces);
    }
};
