// SPDX-License-Identifier: BSD-3-Clause
#include "compiled_refine.hpp"

#include "support/native_shape.hpp"
#include "support/same_mesh.hpp"
#include "support/shapes.hpp"

#include <kith/compiled_schemes.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <utility>

namespace {

/// Returns the native mesh with the same elements.
template <class M>
mesh3d native_of(const M& mesh)
{
    const auto lifted = kith::to_native(mesh);
    kith::storage<std::array<double, 3>> points(lifted.vertex_count());
    for (std::size_t v = 0; v < points.size(); ++v)
        for (int i = 0; i < 3; ++i)
            points[v][std::size_t(i)] = lifted.point(v)[i];
    return {std::move(points), lifted.topology()};
}

/// Returns true if a mesh has the faces of a native mesh, and its points bit for bit.
template <class M>
bool has_bits_of(const M& mesh, const mesh3d& native)
{
    const kith::level_of<M> level(mesh);
    if (faces_of(mesh) != faces_of(native) or level.vertex_count() != native.vertex_count())
        return false;
    for (std::size_t v = 0; v < level.vertex_count(); ++v) {
        const auto& point = kith::mesh_traits<M>::point_of(mesh, level.vertex_at(v));
        for (int i = 0; i < 3; ++i)
            if (bits_of(double(point[i])) != bits_of(native.point(v)[std::size_t(i)]))
                return false;
    }
    return true;
}

TEST(compiled_refine, is_what_refine_is_when_another_file_has_compiled_it)
{
    const auto house = shapes::shaken(shapes::house());
    const auto cage = user_mesh<surface_mesh<epick>>::make(house.points, house.faces);
    EXPECT_TRUE(has_bits_of(refine(cage, kith::catmull_clark{}, 2), refine(native_of(cage), kith::catmull_clark{}, 2)));

    const auto triangles = shapes::shaken(shapes::triangulated(shapes::house()));
    const auto mesh = user_mesh<tri_mesh>::make(triangles.points, triangles.faces);
    EXPECT_TRUE(has_bits_of(kith::refine(mesh, kith::loop{}, 2), refine(native_of(mesh), kith::loop{}, 2)));
}

} // namespace
