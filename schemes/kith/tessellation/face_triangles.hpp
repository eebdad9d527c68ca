// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace kith::detail {

/// A vertex of a tessellation, at parameters of a face.
struct face_vertex {
    double u, v;
    std::size_t number;
};

/// Cuts one face into triangles. Inside lies a grid, or a lattice; strips of triangles join it with the vertices on the
/// sides, of which each side has any number. So faces that share a side fit together.
class face_triangles {
public:
    /// `sides` has for each side the vertices from corner to corner, with both. Of a quad the grid has u_segments and
    /// v_segments; of a triangle both are the same. add_vertex(u, v) returns the number of a new vertex.
    template <class AddVertex>
    face_triangles(std::span<const std::vector<face_vertex>> sides, std::size_t u_segments, std::size_t v_segments,
                   const AddVertex& add_vertex)
        : sides_(sides)
    {
        const bool has_inner_vertices = std::max(u_segments, v_segments) > 1 or
                                        std::ranges::any_of(sides, [](const auto& side) { return side.size() > 2; });
        if (not has_inner_vertices) {
            add(sides[0][0], sides[0][1], sides[1][1]);
            if (sides.size() == 4)
                add(sides[0][0], sides[1][1], sides[2][1]);
        } else if (sides.size() == 4) {
            fill_quad(std::max<std::size_t>(u_segments, 2), std::max<std::size_t>(v_segments, 2), add_vertex);
        } else {
            fill_triangle(std::max<std::size_t>({u_segments, v_segments, 3}), add_vertex);
        }
    }

    /// Three vertices for each triangle, counter-clockwise.
    [[nodiscard]] const std::vector<std::array<face_vertex, 3>>& triangles() const { return triangles_; }

private:
    using row = std::vector<face_vertex>;

    void add(const face_vertex& a, const face_vertex& b, const face_vertex& c) { triangles_.push_back({a, b, c}); }

    template <class AddVertex>
    void fill_quad(std::size_t u_segments, std::size_t v_segments, const AddVertex& add_vertex)
    {
        std::vector<row> grid(v_segments - 1);
        for (std::size_t j = 1; j < v_segments; ++j)
            for (std::size_t i = 1; i < u_segments; ++i) {
                const double u = double(i) / double(u_segments), v = double(j) / double(v_segments);
                grid[j - 1].push_back({u, v, add_vertex(u, v)});
            }
        for (std::size_t j = 0; j + 1 < grid.size(); ++j)
            for (std::size_t i = 0; i + 1 < grid[j].size(); ++i) {
                add(grid[j][i], grid[j][i + 1], grid[j + 1][i + 1]);
                add(grid[j][i], grid[j + 1][i + 1], grid[j + 1][i]);
            }
        row right, left;
        for (const row& r : grid) {
            right.push_back(r.back());
            left.push_back(r.front());
        }
        std::ranges::reverse(left);
        row top = grid.back();
        std::ranges::reverse(top);
        join(sides_[0], grid.front(), [](const face_vertex& x) { return x.u; });
        join(sides_[1], right, [](const face_vertex& x) { return x.v; });
        join(sides_[2], top, [](const face_vertex& x) { return 1 - x.u; });
        join(sides_[3], left, [](const face_vertex& x) { return 1 - x.v; });
    }
    template <class AddVertex>
    void fill_triangle(std::size_t segments, const AddVertex& add_vertex)
    {
        // Row j has the vertices at v = (j + 1) / segments.
        std::vector<row> lattice(segments - 2);
        for (std::size_t j = 0; j < lattice.size(); ++j)
            for (std::size_t i = 1; i + j + 1 < segments; ++i) {
                const double u = double(i) / double(segments), v = double(j + 1) / double(segments);
                lattice[j].push_back({u, v, add_vertex(u, v)});
            }
        for (std::size_t j = 0; j + 1 < lattice.size(); ++j)
            for (std::size_t i = 0; i + 1 < lattice[j].size(); ++i) {
                add(lattice[j][i], lattice[j][i + 1], lattice[j + 1][i]);
                if (i + 1 < lattice[j + 1].size())
                    add(lattice[j][i + 1], lattice[j + 1][i + 1], lattice[j + 1][i]);
            }
        row right, left;
        for (const row& r : lattice) {
            right.push_back(r.back());
            left.push_back(r.front());
        }
        std::ranges::reverse(left);
        // Along a side: the coordinate of its end, and half of that of the corner opposite.
        join(sides_[0], lattice.front(), [](const face_vertex& x) { return x.u + x.v / 2; });
        join(sides_[1], right, [](const face_vertex& x) { return x.v + (1 - x.u - x.v) / 2; });
        join(sides_[2], left, [](const face_vertex& x) { return 1 - x.v - x.u / 2; });
    }
    /// Joins a side and the row of inner vertices beside it, both in the order of their places along the side.
    template <class Along>
    void join(const row& side, const row& inner, const Along& along)
    {
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

    std::span<const std::vector<face_vertex>> sides_;
    std::vector<std::array<face_vertex, 3>> triangles_;
};

} // namespace kith::detail
