// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/mesh/basic_mesh.hpp>
#include <kith/mesh/level_sink.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

/// A mesh of another library, as simple as can be: what is written into it, as native arrays.
template <class Point, class Index>
class written_level final : public kith::level_writer<Point, Index> {
public:
    void make_room(std::size_t vertices, std::size_t edges, std::size_t faces, bool is_closed) override
    {
        points_ = kith::storage<Point>(vertices);
        leaving_.resize(vertices);
        mesh_.vertices = vertices;
        mesh_.faces = faces;
        sides_ = 2 * edges;
        is_closed_ = is_closed;
    }
    [[nodiscard]] Point* points() const override { return points_.data(); }
    void set_start(Index vertex, Index leaving) override { leaving_[vertex] = leaving; }
    void set_faces(Index first, std::size_t degree, std::span<const kith::face_line<Index>> lines) override
    {
        if (mesh_.degree == 0) {
            mesh_.allocate_faces(mesh_.faces, int(degree), [degree](std::size_t) { return degree; });
            mesh_.allocate_edges(sides_ / 2);
        }
        Index corner = Index(degree * first);
        for (const auto& [vertex, halfedge] : lines) {
            mesh_.corner_vertex[corner] = vertex;
            mesh_.set_side(corner++, halfedge);
        }
    }
    void finish(int generation) override { generation_ = generation; }

    kith::basic_mesh<Point, Index> take()
    {
        EXPECT_EQ(is_closed_, std::ranges::count(mesh_.halfedge_corner, mesh_.none) == 0);
        mesh_.vertex_corner = kith::storage<Index>(leaving_.size());
        for (std::size_t v = 0; v < leaving_.size(); ++v)
            mesh_.vertex_corner[v] = mesh_.halfedge_corner[leaving_[v]];
        return {kith::storage<Point>(points_), std::move(mesh_), generation_};
    }

private:
    mutable kith::storage<Point> points_;
    std::vector<Index> leaving_;
    kith::connectivity<Index> mesh_;
    std::size_t sides_ = 0;
    bool is_closed_ = false;
    int generation_ = 0;
};
