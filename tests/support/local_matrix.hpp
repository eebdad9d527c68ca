// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "native_shape.hpp"

#include <kith/hierarchy.hpp>
#include <kith/limits/limit.hpp>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

/// Returns n quads around vertex 0, which has valence n.
inline shapes::shape quad_umbrella(std::size_t n)
{
    const double turn = 2 * std::acos(-1.) / double(n);
    shapes::shape result{{{0, 0, 0}}, {}};
    for (std::size_t j = 0; j < n; ++j) {
        const double a = turn * double(j), b = a + turn / 2;
        result.points.push_back({std::cos(a), std::sin(a), 0});
        result.points.push_back({1.4 * std::cos(b), 1.4 * std::sin(b), 0});
        result.faces.push_back({0, 1 + 2 * j, 2 + 2 * j, 1 + 2 * ((j + 1) % n)});
    }
    return result;
}

/// Returns k quads around vertex 0, which lies on the boundary.
inline shapes::shape half_quad_umbrella(std::size_t k)
{
    auto result = quad_umbrella(k + 1);
    result.faces.pop_back();
    result.points.pop_back(); // the vertex that belonged to the last quad only
    return result;
}
/// Returns k triangles around vertex 0, which lies on the boundary.
inline shapes::shape half_umbrella(std::size_t k)
{
    auto result = shapes::umbrella(k + 1);
    result.faces.pop_back();
    return result;
}

/// Returns the corners around the vertex of `from`, beginning with `from`. At a boundary vertex the fan begins at the
/// boundary instead.
template <class Corner>
std::vector<Corner> fan_of(const Corner& from)
{
    std::vector<Corner> result;
    if (from.v().is_boundary())
        for (const auto& c : from.v().corners())
            result.push_back(c);
    else
        for (const auto& c : from.fan_from_here())
            result.push_back(c);
    return result;
}

/// Returns the numbers of the vertices within `rings` rings of faces around the vertices of the given corners. Their
/// order depends on the connectivity alone, so that equal neighbourhoods give equal orders.
template <class Corner>
std::vector<std::size_t> patch(std::vector<Corner> found, int rings)
{
    const auto is_new = [&found](const Corner& c) {
        return std::ranges::none_of(found, [&c](const Corner& d) { return d.v() == c.v(); });
    };
    for (std::size_t begin = 0; rings > 0; --rings)
        for (const std::size_t end = found.size(); begin < end; ++begin)
            for (const auto& c : fan_of(found[begin])) {
                for (auto d = c.next(); not(d == c); d = d.next())
                    if (is_new(d))
                        found.push_back(d);
            }
    std::vector<std::size_t> result;
    for (const auto& c : found)
        result.push_back(c.v().index());
    return result;
}

/// The subdivision matrix around an element: stencil rows of a scheme from one level to a later level with an equal
/// neighbourhood. The limit masks of the element on both levels are rows, too.
struct local_matrix {
    Eigen::MatrixXd matrix;
    double leak = 0;                          ///< largest weight of a point outside the patch
    Eigen::MatrixXd position[2], tangents[2]; ///< coarse and fine; without rows if there are no masks

    /// Returns the moduli of the eigenvalues, the largest first.
    [[nodiscard]] std::vector<double> spectrum() const
    {
        const Eigen::VectorXcd values = Eigen::EigenSolver<Eigen::MatrixXd>(matrix, false).eigenvalues();
        std::vector<double> result;
        for (const auto& value : values)
            result.push_back(std::abs(value));
        std::ranges::sort(result, std::greater());
        return result;
    }
};

namespace detail {

inline Eigen::RowVectorXd as_row(const kith::stencil_row& row, const std::vector<std::size_t>& vertices, double& leak)
{
    Eigen::RowVectorXd result = Eigen::RowVectorXd::Zero(Eigen::Index(vertices.size()));
    for (const auto& [column, weight] : row.entries)
        if (const auto i = std::ranges::find(vertices, column); i != vertices.end())
            result[i - vertices.begin()] += weight;
        else
            leak = std::max(leak, std::abs(weight));
    return result;
}

inline Eigen::MatrixXd stacked(const std::vector<Eigen::RowVectorXd>& rows)
{
    Eigen::MatrixXd result(Eigen::Index(rows.size()), rows.empty() ? 0 : rows[0].size());
    for (std::size_t i = 0; i < rows.size(); ++i)
        result.row(Eigen::Index(i)) = rows[i];
    return result;
}

} // namespace detail

/// Returns the matrix around element_of(level). Its patches begin with the corners in corners_of(element).
template <class Mesh, class Scheme, class ElementOf, class CornersOf>
local_matrix make_local_matrix(const kith::hierarchy<Mesh, Scheme>& levels, int from, int to, int rings,
                               const ElementOf& element_of, const CornersOf& corners_of)
{
    local_matrix result;
    std::vector<std::size_t> vertices[2];
    for (const int which : {0, 1}) {
        const int i = which == 0 ? from : to;
        const auto& level = levels.elements(i);
        const auto x = element_of(i);
        vertices[which] = patch(corners_of(x), rings);
        using level_type = std::remove_cvref_t<decltype(level)>;
        std::vector<kith::stencil_row> unit(level.vertex_count());
        for (std::size_t v = 0; v < unit.size(); ++v)
            unit[v].entries = {{v, 1.}};
        const kith::attribute_values<kith::stencil_row> values{std::span<const kith::stencil_row>(unit)};
        std::vector<Eigen::RowVectorXd> position, tangents;
        const auto take = [&](std::vector<Eigen::RowVectorXd>& rows) {
            return [&](const auto&... mask) {
                (rows.push_back(detail::as_row(mask.evaluate(values), vertices[which], result.leak)), ...);
            };
        };
        const auto scheme = levels.scheme(i);
        const auto& rules = kith::limit_rules<Scheme>::on(scheme, level);
        if constexpr (kith::has_limit_positions<Scheme, std::remove_cvref_t<decltype(x)>, level_type>)
            kith::limit_rules<Scheme>::position(rules, x, take(position));
        if constexpr (kith::has_limit_tangents<Scheme, std::remove_cvref_t<decltype(x)>, level_type>)
            kith::limit_rules<Scheme>::tangents(rules, x, take(tangents));
        result.position[which] = detail::stacked(position);
        result.tangents[which] = detail::stacked(tangents);
    }
    const auto all = levels.matrix(from, to);
    std::vector<Eigen::RowVectorXd> rows;
    for (const std::size_t v : vertices[1]) {
        kith::stencil_row row;
        for (std::size_t k = all.begin_of_row(v); k < all.begin_of_row(v + 1); ++k)
            row.entries.emplace_back(all.column[k], all.weight[k]);
        rows.push_back(detail::as_row(row, vertices[0], result.leak));
    }
    result.matrix = detail::stacked(rows);
    return result;
}

/// Returns the matrix around vertex 0, which is vertex 0 on all levels.
template <class Scheme>
local_matrix matrix_around_vertex(const mesh3d& mesh, const Scheme& scheme, int from, int to, int rings)
{
    kith::hierarchy levels(mesh, scheme);
    levels.refine(to);
    return make_local_matrix(
        levels,
        from,
        to,
        rings,
        [&](int i) { return levels.elements(i).vertices()[0]; },
        [](const auto& v) { return std::vector{v.first_corner()}; });
}

/// Returns the matrix around face 0, which is face 0 on all levels of schemes that keep faces.
template <class Scheme>
local_matrix matrix_around_face(const mesh3d& mesh, const Scheme& scheme, int from, int to, int rings)
{
    kith::hierarchy levels(mesh, scheme);
    levels.refine(to);
    return make_local_matrix(
        levels,
        from,
        to,
        rings,
        [&](int i) { return levels.elements(i).faces()[0]; },
        [](const auto& f) {
            std::vector<decltype(f.first_corner())> corners;
            for (const auto& c : f.corners())
                corners.push_back(c);
            return corners;
        });
}
