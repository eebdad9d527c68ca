// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "parametric_faces.hpp"
#include "tessellation_rates.hpp"
#include "triangle_pattern.hpp"

#include <kith/core/base/error.hpp>
#include <kith/core/base/for_parts.hpp>
#include <kith/core/base/storage.hpp>
#include <kith/core/mesh/connectivity.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace kith::detail {

/// The numbers of all vertices, edges and triangles of a tessellation. Elements at corners come first, then those on
/// curves, then those inside faces. Faces with the same rates share a pattern. The faces and rates must outlive this
/// object.
class tessellation_numbers {
public:
    using index = std::uint32_t;

    /// Takes faces and their rates. Errors: mesh_error for more corners than an index can number. Cost: O(faces), and
    /// that of the patterns.
    tessellation_numbers(const parametric_faces& faces, const tessellation_rates& rates) : faces_(faces), rates_(rates)
    {
        std::size_t vertices = 0, edges = 0, triangles = 0;
        for (const parametric_faces::start& start : faces.starts()) {
            at_corners_.push_back(index(vertices));
            vertices += start.face < faces.faces().size() ? 1 : 0;
        }
        corners_ = vertices;
        for (const std::size_t rate : rates.of_curves) {
            on_curves_.push_back({index(vertices), index(edges), 0});
            vertices += rate - 1;
            edges += rate;
            require_room(edges);
        }
        std::map<face_rates, std::size_t> known;
        for (std::size_t f = 0; f < faces.faces().size(); ++f) {
            const face_rates here = rates_of(f);
            if (f == 0 or here != patterns_[pattern_of_face_.back()].rates()) {
                const auto [pattern, is_new] = known.emplace(here, patterns_.size());
                if (is_new)
                    patterns_.emplace_back(here);
                pattern_of_face_.push_back(pattern->second);
            } else {
                pattern_of_face_.push_back(pattern_of_face_.back());
            }
            const triangle_pattern& pattern = patterns_[pattern_of_face_.back()];
            in_faces_.push_back({index(vertices), index(edges), index(triangles)});
            vertices += pattern.vertices_inside();
            edges += pattern.edges_inside();
            triangles += pattern.triangles();
            require_room(3 * triangles);
        }
        in_faces_.push_back({index(vertices), index(edges), index(triangles)});
    }

    /// Returns the number of vertices at corners.
    [[nodiscard]] std::size_t corners() const { return corners_; }
    [[nodiscard]] std::size_t vertices() const { return in_faces_.back().vertex; }
    [[nodiscard]] std::size_t triangles() const { return in_faces_.back().triangle; }
    [[nodiscard]] std::size_t first_triangle(std::size_t face) const { return in_faces_[face].triangle; }
    [[nodiscard]] const triangle_pattern& pattern(std::size_t number) const { return patterns_[number]; }
    [[nodiscard]] std::size_t pattern_of(std::size_t face) const { return pattern_of_face_[face]; }
    /// Returns the number of the vertex at the begin of a part of a side.
    [[nodiscard]] index vertex_at(const part_of_side& part) const { return at_corners_[faces_.corner_of(part)]; }

    /// Writes the numbers of the vertices on the sides of a face to a list.
    void list_vertices_on_sides(std::size_t f, std::vector<index>& result) const
    {
        result.clear();
        for (const part_of_side& part : faces_.faces()[f].parts()) {
            const auto n = index(rates_.of_curves[part.curve]);
            result.push_back(vertex_at(part));
            for (index i = 1, v = first_on(part, n); i < n; ++i, v += part.is_reversed ? index(-1) : index(1))
                result.push_back(v);
        }
    }
    /// Writes the numbers of all vertices of a face to a list.
    void list_vertices(std::size_t f, std::vector<index>& result) const
    {
        list_vertices_on_sides(f, result);
        for (index v = in_faces_[f].vertex; v < in_faces_[f + 1].vertex; ++v)
            result.push_back(v);
    }
    /// Calls take(begin, end, first, step) for runs of vertices in the pattern of a face that no other face owns.
    /// Vertex `begin` of the pattern has the number `first`, and each next one `step` more.
    template <class Take>
    void for_own_vertices(std::size_t f, const Take& take) const
    {
        const triangle_pattern& pattern = patterns_[pattern_of_face_[f]];
        const parametric_face& face = faces_.faces()[f];
        for (std::size_t q = 0; q < face.parts().size(); ++q) {
            const part_of_side& part = face.parts()[q];
            const shared_curve& curve = faces_.curves()[part.curve];
            const std::size_t begin = pattern.begin_of_part(q), end = pattern.begin_of_part(q + 1);
            if (begins_here(f, q))
                take(begin, begin + 1, vertex_at(part), index(1));
            if (const auto n = index(end - begin); curve.face == f and curve.part == q and n > 1)
                take(begin + 1, end, first_on(part, n), part.is_reversed ? index(-1) : index(1));
        }
        if (pattern.vertices_inside() > 0)
            take(pattern.vertices_on_sides(), pattern.parameters().size(), in_faces_[f].vertex, index(1));
    }

    /// Returns the triangles. Their edges follow from the numbers. Runs on threads. Cost: O(triangles).
    [[nodiscard]] connectivity<index> connect() const
    {
        connectivity<index> result;
        result.vertices = vertices();
        result.faces = triangles();
        result.degree = 3;
        result.corner_vertex = storage<index>(3 * result.faces);
        result.corner_halfedge = storage<index>(3 * result.faces);
        result.halfedge_corner = storage<index>(2 * in_faces_.back().edge);
        result.vertex_corner = storage<index>(result.vertices);
        for_parts(
            faces_.faces().size(),
            is_worth_threads(result.faces),
            [&](std::size_t begin, std::size_t end) {
                std::vector<index> vertices, halfedges;
                for (std::size_t f = begin; f < end; ++f)
                    connect_face(f, vertices, halfedges, result);
            },
            2);
        return result;
    }

private:
    /// The first numbers on a curve or in a face.
    struct first_numbers {
        index vertex, edge, triangle;
    };

    /// Returns the first vertex within a part of a side that has n segments.
    [[nodiscard]] index first_on(const part_of_side& part, index n) const
    {
        return on_curves_[part.curve].vertex + (part.is_reversed ? n - 2 : 0);
    }
    /// Returns true if the face owns the corner at which a part begins.
    [[nodiscard]] bool begins_here(std::size_t f, std::size_t q) const
    {
        const parametric_faces::start& start = faces_.starts()[faces_.corner_of(faces_.faces()[f].parts()[q])];
        return start.face == f and start.part == q;
    }
    static void require_room(std::size_t corners)
    {
        if (corners >= connectivity<index>::none / 2)
            throw mesh_error("tessellate: there would be " + std::to_string(corners) +
                             " corners or more, too many for their numbers of 32 bits; ask for less");
    }
    [[nodiscard]] face_rates rates_of(std::size_t f) const
    {
        const parametric_face& face = faces_.faces()[f];
        face_rates result{face.sides, face.parts_of_side, {}, index(rates_.of_faces[f].u), index(rates_.of_faces[f].v)};
        for (std::size_t q = 0; q < face.parts().size(); ++q)
            result.of_parts[q] = index(rates_.of_curves[face.parts()[q].curve]);
        return result;
    }

    /// Writes the triangles of a face.
    void connect_face(std::size_t f, std::vector<index>& vertices, std::vector<index>& halfedges,
                      connectivity<index>& to) const
    {
        const triangle_pattern& pattern = patterns_[pattern_of_face_[f]];
        const auto on_sides = index(pattern.vertices_on_sides());
        const index first_corner = 3 * in_faces_[f].triangle;
        const index vertex_offset = in_faces_[f].vertex - on_sides, edge_offset = 2 * in_faces_[f].edge - on_sides;
        const auto vertex = pattern.corner_vertex(), halfedge = pattern.corner_halfedge(),
                   corner = pattern.halfedge_corner(), start = pattern.vertex_corner();
        list_vertices_on_sides(f, vertices);
        halfedges.resize(on_sides);
        join_sides(f, first_corner, halfedges, to);
        index* const new_vertex = to.corner_vertex.data() + first_corner;
        index* const new_halfedge = to.corner_halfedge.data() + first_corner;
        const std::size_t inside = 3 * pattern.triangles_inside();
        for (std::size_t c = 0; c < inside; ++c)
            new_vertex[c] = vertex[c] + vertex_offset;
        for (std::size_t c = 0; c < inside; ++c)
            new_halfedge[c] = halfedge[c] + edge_offset;
        for (std::size_t c = inside; c < vertex.size(); ++c) {
            const index v = vertex[c], h = halfedge[c];
            const index vertex_on_side = vertices[std::min(v, on_sides - 1)],
                        halfedge_on_side = halfedges[std::min(h, on_sides - 1)];
            new_vertex[c] = v < on_sides ? vertex_on_side : v + vertex_offset;
            new_halfedge[c] = h < on_sides ? halfedge_on_side : h + edge_offset;
        }
        index* const new_corner = to.halfedge_corner.data() + 2 * in_faces_[f].edge;
        for (std::size_t h = on_sides; h < corner.size(); ++h)
            new_corner[h - on_sides] = corner[h] + first_corner;
        for (std::size_t v = 0; v < start.size(); ++v)
            to.vertex_corner[in_faces_[f].vertex + v] = start[v] + first_corner;
    }
    /// Lists the half-edges on the sides of a face. Writes the corners of these half-edges and of the vertices on the
    /// sides.
    void join_sides(std::size_t f, index first_corner, std::vector<index>& halfedges, connectivity<index>& to) const
    {
        const triangle_pattern& pattern = patterns_[pattern_of_face_[f]];
        const auto corner = pattern.halfedge_corner();
        const parametric_face& face = faces_.faces()[f];
        std::size_t b = 0;
        for (std::size_t q = 0; q < face.parts().size(); ++q) {
            const part_of_side& part = face.parts()[q];
            const shared_curve& curve = faces_.curves()[part.curve];
            const first_numbers first = on_curves_[part.curve];
            const auto n = index(rates_.of_curves[part.curve]);
            const bool owns_curve = curve.face == f and curve.part == q;
            if (begins_here(f, q))
                to.vertex_corner[vertex_at(part)] = first_corner + corner[b];
            for (index i = 0; i < n; ++i, ++b) {
                const index along = part.is_reversed ? n - 1 - i : i;
                const index halfedge = 2 * (first.edge + along) + (part.is_reversed ? 1 : 0);
                halfedges[b] = halfedge;
                to.halfedge_corner[halfedge] = first_corner + corner[b];
                if (curve.is_boundary)
                    to.halfedge_corner[halfedge ^ 1] = connectivity<index>::none;
                if (owns_curve and i > 0)
                    to.vertex_corner[first.vertex + (part.is_reversed ? n - i : i) - 1] = first_corner + corner[b];
            }
        }
    }

    const parametric_faces& faces_;
    const tessellation_rates& rates_;
    std::size_t corners_ = 0; // number of vertices at corners
    std::vector<index> at_corners_;
    std::vector<first_numbers> on_curves_, in_faces_; // by curve; by face, with an end
    std::vector<triangle_pattern> patterns_;
    std::vector<std::size_t> pattern_of_face_;
};

} // namespace kith::detail
