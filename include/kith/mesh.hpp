// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Meshes: `make_mesh` makes a mesh from points and faces, `mesh_builder` vertex by vertex and face by face.
/// `mesh_traits` lets kith refine a mesh of another library as it is; `to_native` makes a native mesh of it. Queries
/// are here, too.

#include <kith/core/level/to_native.hpp>
#include <kith/core/mesh/make_mesh.hpp>
#include <kith/core/mesh/mesh_traits.hpp>
#include <kith/core/query/incidence.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <ranges>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace kith {

/// A builder of a native mesh, element by element. Numbers count from 0 in the order of the calls; the mesh keeps them.
template <affine_value Point = std::array<double, 3>>
class mesh_builder {
public:
    /// Adds a vertex and returns its number.
    std::size_t add_vertex(const Point& point)
    {
        points_.push_back(point);
        return points_.size() - 1;
    }
    /// Adds a face by the numbers of its vertices, counter-clockwise, and returns its number. Errors: mesh_error for a
    /// vertex that does not exist.
    template <std::ranges::forward_range Vertices>
        requires std::integral<std::ranges::range_value_t<Vertices>>
    std::size_t add_face(const Vertices& vertices)
    {
        for (const auto v : vertices)
            if (std::cmp_less(v, 0) or std::cmp_greater_equal(v, points_.size()))
                throw mesh_error("face " + std::to_string(faces_.size()) + " has vertex " + std::to_string(v) + " of " +
                                 std::to_string(points_.size()) + "; add its vertices first");
        faces_.push_back(vertices);
        return faces_.size() - 1;
    }
    template <std::integral... Vertices>
        requires(sizeof...(Vertices) > 2)
    std::size_t add_face(Vertices... vertices)
    {
        using number = std::common_type_t<Vertices...>;
        return add_face(std::array{number(vertices)...});
    }

    [[nodiscard]] std::size_t vertex_count() const { return points_.size(); }
    [[nodiscard]] std::size_t face_count() const { return faces_.size(); }

    /// Returns the mesh of the vertices and faces that were added so far. Errors and cost: as make_mesh.
    template <std::unsigned_integral Index = std::uint32_t>
    [[nodiscard]] basic_mesh<Point, Index> mesh() const
    {
        return make_mesh<Index>(points_, faces_);
    }

private:
    std::vector<Point> points_;
    face_list faces_;
};

} // namespace kith
