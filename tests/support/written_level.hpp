// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/mesh/basic_mesh.hpp>
#include <kith/core/mesh/level_sink.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

/// A stand-in for a mesh of another library. It records what is written and returns it as a native mesh.
template <class Point, class Index>
class written_level final : public kith::level_writer<Point, Index> {
public:
    void make_room(std::size_t vertices, std::size_t edges, std::size_t faces, bool is_closed) override
    {
        points_ = kith::storage<Point>(vertices);
        leaving_.resize(vertices);
        faces_.resize(faces);
        edges_ = edges;
        is_closed_ = is_closed;
    }
    [[nodiscard]] Point* points() const override { return points_.data(); }
    void set_start(Index vertex, Index leaving) override { leaving_[vertex] = leaving; }
    void set_faces(Index first, std::size_t degree, std::span<const kith::face_line<Index>> lines) override
    {
        for (; not lines.empty(); lines = lines.subspan(degree))
            faces_[first++].assign(lines.begin(), lines.begin() + std::ptrdiff_t(degree));
    }
    void finish(int generation) override { generation_ = generation; }

    kith::basic_mesh<Point, Index> take()
    {
        kith::connectivity<Index> mesh;
        mesh.vertices = points_.size();
        const std::size_t first = faces_.empty() ? 0 : faces_[0].size();
        const bool are_alike = (first == 3 or first == 4) and
                               std::ranges::all_of(faces_, [&](const auto& f) { return f.size() == first; });
        mesh.allocate_faces(faces_.size(), are_alike ? int(first) : 0, [&](std::size_t f) { return faces_[f].size(); });
        mesh.allocate_edges(edges_);
        Index corner = 0;
        for (const auto& face : faces_)
            for (const auto& [vertex, halfedge] : face) {
                mesh.corner_vertex[corner] = vertex;
                mesh.set_side(corner++, halfedge);
            }
        EXPECT_EQ(is_closed_, std::ranges::count(mesh.halfedge_corner, mesh.none) == 0);
        mesh.vertex_corner = kith::storage<Index>(leaving_.size());
        for (std::size_t v = 0; v < leaving_.size(); ++v)
            mesh.vertex_corner[v] = mesh.halfedge_corner[leaving_[v]];
        return {kith::storage<Point>(points_), std::move(mesh), generation_};
    }

private:
    mutable kith::storage<Point> points_;
    std::vector<Index> leaving_;
    std::vector<std::vector<kith::face_line<Index>>> faces_;
    std::size_t edges_ = 0;
    bool is_closed_ = false;
    int generation_ = 0;
};
