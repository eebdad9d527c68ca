// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/mesh/connectivity.hpp>
#include <kith/core/mesh/make_mesh.hpp>
#include <kith/engine/neighbourhood/sparse_state.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace kith::detail {

/// Returns a torus of quads or triangles with size x size vertices, all of which are regular. Precondition: degree is 3
/// or 4, and size at least 3.
basic_mesh<> regular_torus(std::size_t degree, std::size_t size);
#ifdef KITH_HAS_BODIES
KITH_IN_LIBRARY basic_mesh<> regular_torus(std::size_t degree, std::size_t size)
{
    std::vector<std::array<double, 3>> points;
    std::vector<std::vector<std::size_t>> faces;
    for (std::size_t i = 0; i < size * size; ++i) {
        const std::size_t x = i % size, right = (x + 1) % size, y = i - x, up = (y + size) % (size * size);
        points.push_back({double(x), double(y), 0});
        if (degree == 4) {
            faces.push_back({x + y, right + y, right + up, x + up});
        } else {
            faces.push_back({x + y, right + y, right + up});
            faces.push_back({x + y, right + up, x + up});
        }
    }
    return make_mesh(points, faces);
}
#endif

/// A corner of a face, given relative to the corner by which the face was reached.
struct corner_from {
    std::uint16_t reached; ///< the number of the corner by which the face was reached
    std::uint16_t on;      ///< number of corners from there to this one, around the face
};

/// The ways from the first corner of a regular vertex to the vertices of the faces within some rings of faces around
/// its own. They do not depend on where the faces and the other fans begin.
struct regular_walk {
    std::vector<corner_from> steps;     ///< each reaches one more corner: the one across the edge after this one
    std::vector<corner_from> vertices;  ///< the vertex itself comes first
    std::vector<std::uint32_t> numbers; ///< of these vertices, in the mesh in which the walk was made
    std::size_t valence;                ///< number of corners of the vertex, which are reached first

    /// Takes the walk around a vertex of a mesh. Precondition: the mesh is closed and all its faces have one degree.
    regular_walk(const connectivity<std::uint32_t>& mesh, std::size_t vertex, int rings);

private:
    [[nodiscard]] std::uint32_t degree() const { return std::uint32_t(mesh_.degree); }
    void reach(std::uint32_t corner)
    {
        reached_by_[mesh_.face_of(corner)] = std::uint32_t(reached_.size());
        reached_.push_back(corner);
    }
    /// Reaches the faces around the vertex of a corner, counter-clockwise from its face.
    void turn_around(std::uint32_t start)
    {
        for (std::uint32_t c = start, next = mesh_.next_in_fan(c); next != start; c = next, next = mesh_.next_in_fan(c))
            if (reached_by_[mesh_.face_of(next)] == mesh_.none) {
                steps.push_back(from_reached(mesh_.prev(c)));
                reach(next);
            }
    }
    /// Returns a corner relative to the corner by which its face was reached. Precondition: the face has been reached.
    [[nodiscard]] corner_from from_reached(std::uint32_t corner) const
    {
        const std::uint32_t by = reached_by_[mesh_.face_of(corner)];
        return {std::uint16_t(by), std::uint16_t((corner + degree() - reached_[by]) % degree())};
    }

    const connectivity<std::uint32_t>& mesh_;
    std::vector<std::uint32_t> reached_, reached_by_; // the corner that reached each face, and its index by face
};

#ifdef KITH_HAS_BODIES
KITH_IN_LIBRARY regular_walk::regular_walk(const connectivity<std::uint32_t>& mesh, std::size_t vertex, int rings)
    : mesh_(mesh), reached_by_(mesh.faces, mesh.none)
{
    std::vector<unsigned char> is_met(mesh.vertices, 0);
    reach(mesh.vertex_corner[vertex]);
    turn_around(reached_[0]);
    valence = reached_.size();
    for (int ring = 0; ring < rings; ++ring)
        for (std::size_t r = 0, end = reached_.size(); r < end; ++r)
            for (std::uint32_t i = 0, c = reached_[r]; i < degree(); ++i, c = mesh.next(c))
                turn_around(c);
    for (const std::uint32_t start : reached_)
        for (std::uint32_t i = 0, c = start; i < degree(); ++i, c = mesh.next(c))
            if (const std::uint32_t v = mesh.corner_vertex[c]; is_met[v] == 0) {
                is_met[v] = 1;
                numbers.push_back(v);
                vertices.push_back(from_reached(c));
            }
}
#endif

/// Returns a mark for each vertex around which a mask within some rings may meet an irregularity: state, a boundary, a
/// face of another degree or a vertex of another valence. Without rings, boundaries and valences are not marked, since
/// the faces of a vertex show them. The list is empty if no vertex can need a mark. Cost: O(corners).
template <std::unsigned_integral Index>
std::vector<unsigned char> irregular_vertices(const connectivity<Index>& mesh, state_marks<Index> state,
                                              std::size_t degree, std::size_t valence, int rings)
{
    const bool has_other_faces = std::size_t(mesh.degree) != degree;
    if (rings == 0 and not has_other_faces and state.empty())
        return {};
    std::vector<unsigned char> result(mesh.vertices, 0);
    const auto corners_of = [&](std::size_t f) {
        return std::span(std::as_const(mesh.corner_vertex).data() + mesh.first_corner(f),
                         std::as_const(mesh.corner_vertex).data() + mesh.first_corner(f + 1));
    };
    if (has_other_faces or not state.empty())
        for (std::size_t f = 0; f < mesh.faces; ++f)
            if (corners_of(f).size() != degree or (not state.empty() and state.number_of_face(f) != 0))
                for (const Index v : corners_of(f))
                    result[v] = 1;
    if (rings == 0)
        return result;
    std::vector<unsigned char> fan(mesh.vertices, 0);
    for (const Index v : mesh.corner_vertex)
        fan[v] = (unsigned char)(fan[v] + (fan[v] <= valence));
    for (std::size_t e = 0; not mesh.is_closed() and e < mesh.edges(); ++e)
        if (mesh.is_boundary(e))
            for (const Index v : mesh.ends(e))
                fan[v] = 0;
    std::vector<Index> last;
    for (std::size_t v = 0; v < mesh.vertices; ++v) {
        result[v] |= fan[v] != valence;
        if (result[v] != 0)
            last.push_back(Index(v));
    }
    for (int ring = 0; ring < rings; ++ring) {
        std::vector<Index> next;
        for (const Index v : last) {
            Index c = mesh.vertex_corner[v];
            do {
                for (const Index u : corners_of(mesh.face_of(c)))
                    if (std::exchange(result[u], 1) == 0)
                        next.push_back(u);
                c = mesh.next_in_fan(c);
            } while (c != mesh.none and c != mesh.vertex_corner[v]);
        }
        last = std::move(next);
    }
    return result;
}

} // namespace kith::detail
