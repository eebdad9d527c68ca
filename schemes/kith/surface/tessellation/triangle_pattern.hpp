// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "parametric_faces.hpp"

#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace kith::detail {

/// The numbers of segments around a face and within it.
struct face_rates {
    std::uint32_t sides = 0, parts_of_side = 1;
    std::array<std::uint32_t, 8> of_parts{}; ///< segments of the curves around the face
    std::uint32_t u = 1, v = 1;              ///< segments of the grid inside; both are the same in a triangle

    auto operator<=>(const face_rates&) const = default;
};

/// The triangles of a face, in numbers of its own. A grid, or a lattice, lies inside. Strips of triangles join it with
/// the vertices on the sides; each side may have any number of these. So faces that share a side fit together.
///
/// Vertices on the sides come first, counter-clockwise, then those inside. Half-edge b is the segment that leaves
/// vertex b of the sides. Then come both half-edges of each edge inside.
class triangle_pattern {
public:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    /// Makes the pattern of a face with these rates. Cost: O(triangles).
    explicit triangle_pattern(const face_rates& rates) : rates_(rates)
    {
        std::uint32_t most_segments = 1;
        for (std::size_t q = 0; q < rates.sides * rates.parts_of_side; ++q) {
            const std::uint32_t n = rates.of_parts[q];
            begins_[q] = boundary();
            most_segments = std::max(most_segments, n);
            for (std::uint32_t i = 0; i < n; ++i)
                parameters_.push_back(parameters_on_side(rates.sides,
                                                         q / rates.parts_of_side,
                                                         (double(q % rates.parts_of_side) + double(i) / double(n)) /
                                                             double(rates.parts_of_side)));
        }
        begins_[rates.sides * rates.parts_of_side] = boundary_ = boundary();
        if (std::max({rates.u, rates.v, most_segments, rates.parts_of_side}) == 1) {
            add(0, 1, 2);
            if (rates.sides == 4)
                add(0, 2, 3);
        } else if (rates.sides == 4) {
            fill_quad(std::max(rates.u, 2U), std::max(rates.v, 2U));
        } else {
            fill_triangle(std::max(rates.u, 3U));
        }
        pair_corners();
    }

    [[nodiscard]] const face_rates& rates() const { return rates_; }
    [[nodiscard]] std::size_t triangles() const { return corner_vertex_.size() / 3; }
    /// Returns the number of triangles, which come first, that have no vertex on a side.
    [[nodiscard]] std::size_t triangles_inside() const { return triangles_inside_; }
    [[nodiscard]] std::size_t vertices_on_sides() const { return boundary_; }
    [[nodiscard]] std::size_t vertices_inside() const { return vertex_corner_.size(); }
    [[nodiscard]] std::size_t edges_inside() const { return (halfedge_corner_.size() - boundary_) / 2; }
    /// Returns the vertex at which a part of the sides begins; the index after the last part gives the end.
    [[nodiscard]] std::size_t begin_of_part(std::size_t part) const { return begins_[part]; }

    /// Returns u and v of the vertices.
    [[nodiscard]] std::span<const std::array<double, 2>> parameters() const { return parameters_; }
    /// Returns the vertices of the corners, three for each triangle, counter-clockwise.
    [[nodiscard]] std::span<const std::uint32_t> corner_vertex() const { return corner_vertex_; }
    [[nodiscard]] std::span<const std::uint32_t> corner_halfedge() const { return corner_halfedge_; }
    [[nodiscard]] std::span<const std::uint32_t> halfedge_corner() const { return halfedge_corner_; }
    /// Returns a corner of each vertex inside.
    [[nodiscard]] std::span<const std::uint32_t> vertex_corner() const { return vertex_corner_; }

private:
    using number = std::uint32_t;
    using row = std::vector<number>;

    [[nodiscard]] number boundary() const { return number(parameters_.size()); }
    void add(number a, number b, number c) { corner_vertex_.insert(corner_vertex_.end(), {a, b, c}); }
    [[nodiscard]] row side(std::size_t k) const
    {
        row result;
        for (number b = begins_[k * rates_.parts_of_side]; b <= begins_[(k + 1) * rates_.parts_of_side]; ++b)
            result.push_back(b == boundary_ ? 0 : b);
        return result;
    }
    number add_vertex(double u, double v)
    {
        parameters_.push_back(parameters_within(rates_.sides, u, v));
        return boundary() - 1;
    }

    void fill_quad(number u_segments, number v_segments)
    {
        const number columns = u_segments - 1, rows = v_segments - 1;
        for (number j = 1; j <= rows; ++j)
            for (number i = 1; i <= columns; ++i)
                add_vertex(double(i) / double(u_segments), double(j) / double(v_segments));
        const auto grid = [&](number i, number j) { return boundary_ + j * columns + i; };
        for (number j = 0; j + 1 < rows; ++j)
            for (number i = 0; i + 1 < columns; ++i) {
                add(grid(i, j), grid(i + 1, j), grid(i + 1, j + 1));
                add(grid(i, j), grid(i + 1, j + 1), grid(i, j + 1));
            }
        triangles_inside_ = triangles();
        row bottom, right, top, left;
        for (number i = 0; i < columns; ++i) {
            bottom.push_back(grid(i, 0));
            top.push_back(grid(columns - 1 - i, rows - 1));
        }
        for (number j = 0; j < rows; ++j) {
            right.push_back(grid(columns - 1, j));
            left.push_back(grid(0, rows - 1 - j));
        }
        join(side(0), bottom, [](double u, double) { return u; });
        join(side(1), right, [](double, double v) { return v; });
        join(side(2), top, [](double u, double) { return 1 - u; });
        join(side(3), left, [](double, double v) { return 1 - v; });
    }
    void fill_triangle(number segments)
    {
        // Row j has the vertices at v = (j + 1) / segments.
        std::vector<row> lattice(segments - 2);
        for (number j = 0; j < lattice.size(); ++j)
            for (number i = 1; i + j + 1 < segments; ++i)
                lattice[j].push_back(add_vertex(double(i) / double(segments), double(j + 1) / double(segments)));
        for (std::size_t j = 0; j + 1 < lattice.size(); ++j)
            for (std::size_t i = 0; i + 1 < lattice[j].size(); ++i) {
                add(lattice[j][i], lattice[j][i + 1], lattice[j + 1][i]);
                if (i + 1 < lattice[j + 1].size())
                    add(lattice[j][i + 1], lattice[j + 1][i + 1], lattice[j + 1][i]);
            }
        triangles_inside_ = triangles();
        row right, left;
        for (const row& r : lattice) {
            right.push_back(r.back());
            left.push_back(r.front());
        }
        std::ranges::reverse(left);
        // Along a side: the coordinate of its end, and half of that of the corner opposite.
        join(side(0), lattice.front(), [](double u, double v) { return u + v / 2; });
        join(side(1), right, [](double u, double v) { return v + (1 - u - v) / 2; });
        join(side(2), left, [](double u, double v) { return 1 - v - u / 2; });
    }
    /// Joins a side and the row of inner vertices beside it, both in their order along the side.
    template <class Along>
    void join(const row& side, const row& inner, const Along& along_side)
    {
        const auto along = [&](number vertex) { return along_side(parameters_[vertex][0], parameters_[vertex][1]); };
        std::size_t i = 0, j = 0;
        while (i + 1 < side.size() or j + 1 < inner.size()) {
            const bool goes_on_at_side = j + 1 == inner.size() or
                                         (i + 1 < side.size() and
                                          along(side[i]) + along(side[i + 1]) <= along(inner[j]) + along(inner[j + 1]));
            if (goes_on_at_side) {
                add(side[i], side[i + 1], inner[j]);
                ++i;
            } else {
                add(side[i], inner[j + 1], inner[j]);
                ++j;
            }
        }
    }

    /// Returns the next corner of a triangle.
    static number after(number corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
    /// Numbers the half-edges: corners across from each other have the two half-edges of one edge.
    void pair_corners()
    {
        const number corners = number(corner_vertex_.size());
        vertex_corner_.assign(parameters_.size() - boundary_, 0);
        corner_halfedge_.assign(corners, none);
        halfedge_corner_.assign(boundary_, none);
        row newest(parameters_.size(), none), older(corners, none); // lists of corners without a partner, by vertex
        for (number c = 0; c < corners; ++c) {
            const number from = corner_vertex_[c], to = corner_vertex_[after(c)];
            if (from >= boundary_)
                vertex_corner_[from - boundary_] = c;
            if (from < boundary_ and to == (from + 1 == boundary_ ? 0 : from + 1)) {
                corner_halfedge_[c] = from;
                halfedge_corner_[from] = c;
                continue;
            }
            const auto looks_here = [&](number other) {
                return corner_vertex_[other] == to and corner_vertex_[after(other)] == from;
            };
            number* other = &newest[std::min(from, to)];
            while (*other != none and not looks_here(*other))
                other = &older[*other];
            if (*other == none) {
                older[c] = newest[std::min(from, to)];
                newest[std::min(from, to)] = c;
                continue;
            }
            corner_halfedge_[*other] = number(halfedge_corner_.size());
            corner_halfedge_[c] = number(halfedge_corner_.size()) + 1;
            halfedge_corner_.insert(halfedge_corner_.end(), {*other, c});
            *other = older[*other];
        }
    }

    face_rates rates_;
    number boundary_ = 0; // number of vertices on the sides
    std::array<number, 9> begins_{};
    std::size_t triangles_inside_ = 0;
    std::vector<std::array<double, 2>> parameters_;
    row corner_vertex_, corner_halfedge_, halfedge_corner_, vertex_corner_;
};

} // namespace kith::detail
