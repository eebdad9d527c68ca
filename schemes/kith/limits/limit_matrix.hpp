// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limit_surface.hpp"

#include <kith/core/mask/stencil.hpp>
#include <kith/hierarchy.hpp>

#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>

namespace kith {

namespace detail {

/// A point, and its weights of the vertices of an earlier level. A search for limits of these points finds the weights
/// of the limits, too.
template <class Point>
struct traced_point {
    Point point;
    stencil_row row;
};

template <class Point>
struct bare_point<traced_point<Point>> {
    using type = Point;
    static const Point& of(const traced_point<Point>& traced) { return traced.point; }
};

} // namespace detail

template <class Point>
struct affine<detail::traced_point<Point>> {
    using traced = detail::traced_point<Point>;
    using scalar = scalar_of<Point>;
    struct sum {
        typename affine<Point>::sum point;
        stencil_row row;

        auto operator[](std::size_t axis) const { return point[axis]; }
    };

    static sum load(const traced& value) { return {affine<Point>::load(value.point), value.row}; }
    static traced store(const sum& total) { return {affine<Point>::store(total.point), total.row}; }
    static void add(sum& total, const sum& more)
    {
        affine<Point>::add(total.point, more.point);
        affine<stencil_row>::add(total.row, more.row);
    }
    static void scale(sum& total, const scalar& weight)
    {
        affine<Point>::scale(total.point, weight);
        affine<stencil_row>::scale(total.row, double(weight));
    }
};

/// Returns the limit matrix. It maps the vertices of level `from` to the limits of the vertices of level `to`, as
/// limit_surface_of finds them. If a limit is found by refining the neighbourhood of a vertex until it is one point, so
/// are its weights. The row may then depend on the points in its last digits. For points of three coordinates. Errors:
/// mesh_error unless from <= to, and those of limit_surface_of. Cost: that of matrix(from, to) and of limit_surface_of.
template <mesh M, searchable_scheme Scheme>
subdivision_matrix limit_matrix_of(const hierarchy<M, Scheme>& levels, int from, int to)
{
    using point = typename mesh_traits<M>::point;
    using traced = detail::traced_point<point>;
    const std::size_t columns = levels.elements(from).vertex_count();
    const auto unit = unit_rows(columns);
    const auto rows = levels.carry(from, to, std::span<const stencil_row>(unit));
    const auto& native = native_of(levels[to], levels.elements(to), generation_of(levels[0]) + to);
    using index = typename std::remove_cvref_t<decltype(native)>::index_type;
    storage<traced> points(native.vertex_count());
    for (std::size_t v = 0; v < points.size(); ++v)
        points[v] = {native.point(v), rows[v]};
    const basic_mesh<traced, index> mesh_of_rows(std::move(points), native.topology(), native.generation());
    const auto limits = limit_surface_of(mesh_of_rows, levels.scheme(to));
    storage<stencil_row> result(limits.positions.size());
    for (std::size_t v = 0; v < result.size(); ++v)
        result[v] = limits.positions[v].row;
    return make_matrix(result, columns);
}

} // namespace kith
