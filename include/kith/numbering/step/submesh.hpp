// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "level_state.hpp"

#include <kith/core/mesh/basic_mesh.hpp>

#include <concepts>
#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace kith {

/// A mesh of some faces of another mesh, and the elements of that mesh from which its elements come.
template <class Point, std::unsigned_integral Index>
struct submesh {
    basic_mesh<Point, Index> mesh;
    std::vector<Index> vertex_from, edge_from,
        face_from;                              ///< increasing; a vertex with several fans comes several times
    std::vector<unsigned char> edge_is_turned;  ///< its side 0 is the other mesh's side 1
    std::vector<unsigned char> edge_is_new_rim; ///< it has lost a face
    std::vector<typename part_numbers<Index>::face_corners> corners_from; ///< if faces have several degrees

    [[nodiscard]] part_numbers<Index> numbers() const
    {
        return {vertex_from, edge_from, face_from, std::size_t(mesh.topology().degree), corners_from};
    }
    /// Returns true if the vertex is a copy: of the vertices that come from one vertex, all but the first are copies.
    [[nodiscard]] bool is_copy(std::size_t vertex) const
    {
        return vertex != 0 and vertex_from[vertex] == vertex_from[vertex - 1];
    }
};

namespace detail {

/// Starts the fans that have a boundary, and gives every fan a vertex of its own. `vertex_from` tells from which vertex
/// each of them comes, and grows with them. Fans without a boundary remain to be started.
template <std::unsigned_integral Index, class From>
void split_fans(connectivity<Index>& fine, std::vector<From>& vertex_from)
{
    constexpr Index none = connectivity<Index>::none;
    std::vector<Index> fans(vertex_from.size(), 0);
    std::vector<Index> starts;
    for (std::size_t c = 0; c < fine.corners(); ++c)
        if (fine.across(Index(c)) == none) {
            ++fans[fine.corner_vertex[c]];
            starts.push_back(Index(c));
        }
    std::vector<Index> first(vertex_from.size() + 1,
                             0); // the first vertex that stands for each, in the new numbers
    for (std::size_t v = 0; v < fans.size(); ++v)
        first[v + 1] = first[v] + std::max(Index(1), fans[v]);
    if (first.back() != vertex_from.size()) {
        std::vector<From> from(first.back());
        for (std::size_t v = 0; v < fans.size(); ++v)
            std::fill(from.begin() + first[v], from.begin() + first[v + 1], vertex_from[v]);
        vertex_from = std::move(from);
        for (std::size_t c = 0; c < fine.corners(); ++c)
            fine.corner_vertex[c] = first[fine.corner_vertex[c]];
    }
    fine.vertices = vertex_from.size();
    fine.vertex_corner = storage<Index>(fine.vertices, none);
    for (const Index start : starts) {
        Index v = fine.corner_vertex[start];
        while (fine.vertex_corner[v] != none)
            ++v;
        fine.vertex_corner[v] = start;
        for (Index c = start; c != none; c = fine.next_in_fan(c))
            fine.corner_vertex[c] = v;
    }
}

} // namespace detail

/// A cutter of submeshes of one mesh. Cost of each submesh: O(n log n) for n elements.
template <class Point, std::unsigned_integral Index>
class submesh_cutter {
public:
    /// Takes a mesh, which must outlive the cutter. Precondition: the mesh has its edges.
    explicit submesh_cutter(const basic_mesh<Point, Index>& mesh)
        : mesh_(mesh)
        , vertex_(mesh.vertex_count(), none)
        , edge_(mesh.edge_count(), none)
        , face_(mesh.face_count(), none)
    {
    }

    /// Returns the faces within `rings` rings of the seeds, increasing. A ring consists of the faces that share a
    /// vertex with the faces before. Precondition: the seeds are increasing.
    [[nodiscard]] std::vector<Index> faces_around(std::span<const Index> seeds, int rings);
    /// Returns the submesh of these faces. Precondition: the faces are increasing.
    [[nodiscard]] submesh<Point, Index> cut(std::span<const Index> faces);

private:
    static constexpr Index none = connectivity<Index>::none;

    /// Removes the marks that are left by a call that ended by an exception.
    void begin()
    {
        if (is_marked_)
            for (auto* marks : {&vertex_, &edge_, &face_})
                std::fill(marks->begin(), marks->end(), none);
        is_marked_ = true;
    }
    [[nodiscard]] bool is_here(Index corner) const
    {
        return corner != none and face_[mesh_.topology().face_of(corner)] != none;
    }
    /// Sorts the marked elements, by a sweep over all marks if that is cheaper.
    static void put_in_order(std::vector<Index>& members, const std::vector<Index>& marks)
    {
        if (members.size() < marks.size() / 16) {
            std::sort(members.begin(), members.end());
            return;
        }
        std::size_t i = 0;
        for (std::size_t x = 0; x < marks.size(); ++x)
            if (marks[x] != none)
                members[i++] = Index(x);
    }
    void collect_elements(submesh<Point, Index>& result)
    {
        const auto& t = mesh_.topology();
        for (const Index f : result.face_from)
            for (Index c = t.first_corner(f); c < t.first_corner(std::size_t(f) + 1); ++c) {
                const Index v = t.corner_vertex[c], e = t.corner_halfedge[c] >> 1;
                if (vertex_[v] == none) {
                    vertex_[v] = 0;
                    result.vertex_from.push_back(v);
                }
                if (edge_[e] == none) {
                    edge_[e] = 0;
                    result.edge_from.push_back(e);
                }
            }
        put_in_order(result.vertex_from, vertex_);
        put_in_order(result.edge_from, edge_);
        for (std::size_t i = 0; i < result.vertex_from.size(); ++i)
            vertex_[result.vertex_from[i]] = Index(i);
        for (std::size_t i = 0; i < result.edge_from.size(); ++i)
            edge_[result.edge_from[i]] = Index(i);
    }

    const basic_mesh<Point, Index>& mesh_;
    std::vector<Index> vertex_, edge_, face_; // the numbers in the submesh that is being cut, else none
    bool is_marked_ = false;                  // a call is running, or has ended by an exception
};

// Defined outside of the class, so that files that declare it `extern template` do not compile them.

template <class Point, std::unsigned_integral Index>
std::vector<Index> submesh_cutter<Point, Index>::faces_around(std::span<const Index> seeds, int rings)
{
    begin();
    const auto& t = mesh_.topology();
    std::vector<Index> faces(seeds.begin(), seeds.end()), vertices;
    for (const Index f : faces)
        face_[f] = 0;
    std::size_t first_new = 0;
    for (int ring = 0; ring < rings; ++ring) {
        const std::size_t end = faces.size();
        for (; first_new < end; ++first_new)
            for (const Index v : mesh_.face(faces[first_new]))
                if (vertex_[v] == none) {
                    vertex_[v] = 0;
                    vertices.push_back(v);
                    Index c = t.vertex_corner[v];
                    do {
                        const Index f = t.face_of(c);
                        if (face_[f] == none) {
                            face_[f] = 0;
                            faces.push_back(f);
                        }
                        c = t.next_in_fan(c);
                    } while (c != none and c != t.vertex_corner[v]);
                }
    }
    for (const Index v : vertices)
        vertex_[v] = none;
    put_in_order(faces, face_);
    for (const Index f : faces)
        face_[f] = none;
    is_marked_ = false;
    return faces;
}

template <class Point, std::unsigned_integral Index>
submesh<Point, Index> submesh_cutter<Point, Index>::cut(std::span<const Index> faces)
{
    begin();
    const auto& t = mesh_.topology();
    submesh<Point, Index> result;
    result.face_from.assign(faces.begin(), faces.end());
    for (std::size_t i = 0; i < faces.size(); ++i)
        face_[faces[i]] = Index(i);
    collect_elements(result);

    connectivity<Index> fine;
    fine.allocate_faces(faces.size(), t.degree, [&](std::size_t i) { return mesh_.face(faces[i]).size(); });
    fine.allocate_edges(result.edge_from.size());
    result.edge_is_turned.resize(result.edge_from.size());
    result.edge_is_new_rim.resize(result.edge_from.size());
    for (std::size_t e = 0; e < result.edge_from.size(); ++e) {
        const std::size_t side0 = 2 * std::size_t(result.edge_from[e]);
        const bool left_is_here = is_here(t.halfedge_corner[side0]);
        const bool right_is_here = is_here(t.halfedge_corner[side0 + 1]);
        result.edge_is_turned[e] = not left_is_here;
        result.edge_is_new_rim[e] = not t.is_boundary(side0 / 2) and not(left_is_here and right_is_here);
    }
    Index corner = 0;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const Index first = t.first_corner(faces[i]);
        const Index end = t.first_corner(std::size_t(faces[i]) + 1);
        if (fine.degree == 0)
            result.corners_from.push_back({first, Index(end - first)});
        for (Index c = first; c < end; ++c, ++corner) {
            const Index e = edge_[t.corner_halfedge[c] >> 1];
            fine.set_side(corner, Index(2 * e + ((t.corner_halfedge[c] & 1) ^ result.edge_is_turned[e])));
            fine.corner_vertex[corner] = vertex_[t.corner_vertex[c]];
        }
    }

    detail::split_fans(fine, result.vertex_from);
    const auto first_of = [&](Index old) { // the corner of the submesh that comes from a corner of the mesh
        const Index f = t.face_of(old);
        return Index(fine.first_corner(face_[f]) + (old - t.first_corner(f)));
    };
    for (std::size_t v = 0; v < fine.vertices; ++v)
        if (fine.vertex_corner[v] == none)
            fine.vertex_corner[v] = first_of(t.vertex_corner[result.vertex_from[v]]);

    storage<Point> points(fine.vertices);
    for (std::size_t v = 0; v < fine.vertices; ++v)
        points[v] = mesh_.point(result.vertex_from[v]);
    for (const Index v : result.vertex_from)
        vertex_[v] = none;
    for (const Index e : result.edge_from)
        edge_[e] = none;
    for (const Index f : faces)
        face_[f] = none;
    is_marked_ = false;
    result.mesh = {std::move(points), std::move(fine), mesh_.generation()};
    return result;
}

} // namespace kith
