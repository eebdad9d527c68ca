// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/affine.hpp>
#include <kith/core/base/storage.hpp>
#include <kith/core/level/to_native.hpp>
#include <kith/fields/property/copy_properties.hpp>
#include <kith/fields/property_mesh.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <utility>

namespace kith {

/// A mesh that `convert` has made, and a report of what was left out or narrowed.
template <mesh M>
struct conversion {
    M mesh;
    conversion_report report;
};

namespace detail {

/// The conversion of points of one type to points of another type.
template <class To, class From>
struct point_conversion {
    static To convert(const From& point)
    {
        const auto& from = affine<From>::load(point);
        typename affine<To>::sum to;
        static_assert(std::tuple_size_v<std::remove_cvref_t<decltype(from)>> == std::tuple_size_v<decltype(to)>,
                      "kith::convert: the points of the two meshes have different numbers of coordinates");
        for (std::size_t i = 0; i < from.size(); ++i)
            to[i] = as_coordinate<scalar_of<To>>(from[i]);
        return affine<To>::store(to);
    }
    static bool is_exact(const From& before, const To& after)
    {
        return same_numbers(affine<From>::load(before), affine<From>::load(point_conversion<From, To>::convert(after)));
    }
};

/// Returns the mesh with points of another type, and reports if that narrowed them.
template <class To, class From>
basic_mesh<To, std::uint32_t> with_points(basic_mesh<From, std::uint32_t>&& mesh, conversion_report& report)
{
    if constexpr (std::same_as<To, From>) {
        return std::move(mesh);
    } else {
        storage<To> points(mesh.vertex_count());
        bool is_exact = true;
        for (std::size_t v = 0; v < points.size(); ++v) {
            points[v] = point_conversion<To, From>::convert(mesh.point(v));
            is_exact = is_exact and point_conversion<To, From>::is_exact(mesh.point(v), points[v]);
        }
        if (not is_exact)
            report.narrowed.emplace_back("points");
        return {std::move(points), mesh.topology(), mesh.generation()};
    }
}

/// Returns the native mesh of a mesh that can be refined, or of a mesh without elements. Errors: mesh_error with
/// everything that `validate` finds.
template <mesh From>
auto lift_valid_or_empty(const From& mesh)
{
    using traits = mesh_traits<From>;
    const auto is_empty = [](auto&& elements) { return elements.begin() == elements.end(); };
    if (is_empty(traits::vertices(mesh)) and is_empty(traits::edges(mesh)) and is_empty(traits::faces(mesh)))
        return to_native(mesh);
    if constexpr (requires { mesh.topology(); }) // in native meshes `validate` checks where fans start, too
        validate(mesh).require_ok();
    return to_native_valid<From, typename traits::point>(mesh);
}

} // namespace detail

/// Returns a mesh of another library with the same elements and with all properties that both types can hold. The
/// order, direction and start of each element are the same. Removed elements are left out.
/// A property keeps its name, its type and its values, also on half-edges beyond the boundary. Libraries have their own
/// names for colours, normals and texture coordinates: CGAL "v:color", "v:normal" and "v:texcoord", OpenMesh
/// "v:colors", "v:normals" and "v:texcoords2D". A property with such a name of the library of `mesh` gets the name and
/// type of the other library. Coordinates are rounded if To has another type of numbers. The report names everything
/// that was left out or narrowed. `convert` looks for values of the types that property_access knows for either
/// library, and of the types More.
/// Errors: mesh_error with everything that `validate` finds, and for faces that To cannot hold. A mesh without elements
/// becomes a mesh without elements.
/// Cost: O(elements), and as much for each property.
template <refinable_mesh To, class... More, mesh From>
conversion<To> convert(const From& mesh)
{
    require_edges(mesh);
    conversion_report report;
    auto native = detail::with_points<typename mesh_traits<To>::point>(detail::lift_valid_or_empty(mesh), report);
    conversion<To> result{mesh_traits<To>::build(std::move(native)), std::move(report)};
    detail::copy_properties<More...>(mesh, result.mesh, result.report);
    return result;
}

} // namespace kith
