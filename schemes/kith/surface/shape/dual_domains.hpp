// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "face_domain.hpp"

#include <kith/schemes/split/dual_split.hpp>
#include <kith/schemes/split/mid_edge_split.hpp>
#include <kith/unified.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <string>

namespace kith::detail {

/// The parameters of splits that make faces of vertices. The limits of vertices of the control mesh lie inside their
/// faces: the corners of parameters are the centres of the faces that vertices become. All faces consist of sub-faces,
/// also quads; the parameters of a quad are those of its four quarters. At a boundary steps make no faces of edges, nor
/// of some vertices, so parts of faces have no surface. The boundary of the surface lies inside faces, too.
struct domain_of_dual_faces : domain_of_rings {
    static constexpr std::size_t sides = 4;
    static constexpr std::size_t fineness = 2;
    static constexpr bool is_cut_off_by_boundaries = true;
    static constexpr bool has_polynomials_at_boundaries = false;
    static constexpr auto corners = domain_of_quads::corners;

    static constexpr std::size_t degree = 2; ///< of the splines that are searched for
    static bool has_vertices_at_corners(const domain_face&) { return false; }

    /// Returns the sub-face in which a place lies, and replaces its parameters by those of the sub-face. A place
    /// between two sub-faces belongs to the one further from walls, which has a surface.
    static std::size_t enter_sub_face(const domain_face& face, std::size_t corner, face_parameters& at)
    {
        if (face.degree != sides)
            return corner;
        const bool is_far_in_s = at.s > .5 or (at.s == .5 and not face.is_wall[1]);
        const bool is_far_in_t = at.t > .5 or (at.t == .5 and not face.is_wall[2]);
        const std::size_t quarter = is_far_in_t ? is_far_in_s ? 2 : 3 : is_far_in_s ? 1 : 0;
        face_domain<decltype(quad_split::columns())>::move_to_quarter(quarter, at);
        return quarter;
    }
};

/// The domain of the dual split. Children are the faces of the vertices, of the edges after them, and of the face.
template <>
struct face_domain<decltype(dual_split().columns())> : domain_of_dual_faces {
    static constexpr bool is_tensor = true;
    static constexpr int steps = 27;
    static constexpr int most_steps = 130; // strips along boundaries shrink by 3/4

    static std::size_t corner_at(const domain_face&, std::size_t, const std::array<double, 2>& at)
    {
        return at == std::array{1., 1.} ? 0 : sides;
    }
    /// Returns true on the border of the sub-faces that a boundary cuts off from a quad.
    static bool is_at_wall(const domain_face& face, std::size_t cell, const face_parameters& at)
    {
        return face.degree == sides and
               ((at.s == 1 and face.is_wall[(cell + 1) % sides]) or (at.t == 1 and face.is_wall[(cell + 2) % sides]));
    }
    static std::size_t cells(const domain_face& face) { return face.degree; }
    static std::size_t enter(const domain_face& face, std::size_t corner, face_parameters& at)
    {
        return enter_sub_face(face, corner, at);
    }
    static std::size_t children(const domain_face& face) { return 2 * face.degree + 1; }
    template <std::unsigned_integral Index, class Ids>
    static std::size_t child(const connectivity<Index>& mesh, const Ids& ids, const domain_face& face, std::size_t k)
    {
        const std::size_t first = mesh.first_corner(face.number), n = face.degree;
        return k < n       ? ids.faces.template id<tuple_kind::v>(mesh.corner_vertex[first + k])
               : k < 2 * n ? ids.faces.template id<tuple_kind::e>(mesh.corner_halfedge[first + k - n] / 2)
                           : ids.faces.template id<tuple_kind::f>(face.number);
    }
    /// Returns the vertex of child k from which its sub-faces are counted: the vertex that a corner gives birth to.
    template <std::unsigned_integral Index, class Ids>
    static std::size_t vertex_of_child(const connectivity<Index>& mesh, const Ids& ids, const domain_face& face,
                                       std::size_t k)
    {
        const std::size_t first = mesh.first_corner(face.number), n = face.degree;
        return ids.vertices.template id<tuple_kind::vf>(first + k % n);
    }
    static std::size_t cell_of_child(const domain_face& child, std::size_t first, std::size_t cell)
    {
        return (first + cell) % child.degree;
    }
    static child_cell descend(const domain_face& face, std::size_t cell, face_parameters& at)
    {
        const std::size_t n = face.degree;
        const double s = at.s, t = at.t;
        if (s >= .5 and t >= .5) {
            at.replace(2 * s - 1, 2, 0, 2 * t - 1, 0, 2);
            return {2 * n, cell};
        }
        if (s >= .5) {
            at.replace(1 - 2 * t, 0, -2, 2 * s - 1, 2, 0);
            return {n + cell, 0};
        }
        if (t >= .5) { // at the other end of the edge before
            at.replace(2 * t - 1, 0, 2, 1 - 2 * s, -2, 0);
            return {n + (cell + n - 1) % n, 3};
        }
        at.replace(1 - 2 * s, -2, 0, 1 - 2 * t, 0, -2);
        return {cell, 0};
    }
};

/// The domain of the mid-edge split. Children are the faces of the vertices and that of the face. A sub-face has two
/// cells, triangles on both sides of its diagonal from the corner to the centre. (0, 0) of a cell is the corner, (1, 0)
/// the middle of the edge, and (0, 1) the centre. The edge is that after the corner in the first cell, and that before
/// it in the second.
template <>
struct face_domain<decltype(mid_edge_split::columns())> : domain_of_dual_faces {
    static constexpr bool is_tensor = false;
    static constexpr int steps = 54;
    static constexpr int most_steps = 260; // two steps are one of the dual split
    static constexpr int rings = 2;        // two rings around a face contain two around each child

    static std::size_t corner_at(const domain_face&, std::size_t, const std::array<double, 2>& at)
    {
        return at == std::array{0., 1.} ? 0 : sides;
    }
    static bool is_at_wall(const domain_face&, std::size_t, const face_parameters&) { return false; }
    static std::size_t cells(const domain_face& face) { return 2 * face.degree; }
    static std::size_t enter(const domain_face& face, std::size_t corner, face_parameters& at)
    {
        const std::size_t sub_face = enter_sub_face(face, corner, at);
        const double s = at.s, t = at.t;
        if (s >= t)
            at.replace(s - t, 1, -1, t, 0, 1);
        else
            at.replace(t - s, -1, 1, s, 1, 0);
        return 2 * sub_face + (s >= t ? 0 : 1);
    }
    static std::size_t children(const domain_face& face) { return face.degree + 1; }
    template <std::unsigned_integral Index, class Ids>
    static std::size_t child(const connectivity<Index>& mesh, const Ids& ids, const domain_face& face, std::size_t k)
    {
        const std::size_t first = mesh.first_corner(face.number), n = face.degree;
        return k < n ? ids.faces.template id<tuple_kind::v>(mesh.corner_vertex[first + k])
                     : ids.faces.template id<tuple_kind::f>(face.number);
    }
    /// Returns the vertex of child k from which its sub-faces are counted: the vertex that an edge gives birth to.
    template <std::unsigned_integral Index, class Ids>
    static std::size_t vertex_of_child(const connectivity<Index>& mesh, const Ids& ids, const domain_face& face,
                                       std::size_t k)
    {
        const std::size_t first = mesh.first_corner(face.number), n = face.degree;
        return ids.vertices.template id<tuple_kind::e>(mesh.corner_halfedge[first + k % n] / 2);
    }
    static std::size_t cell_of_child(const domain_face& child, std::size_t first, std::size_t cell)
    {
        return 2 * ((first + cell / 2) % child.degree) + cell % 2;
    }
    static child_cell descend(const domain_face& face, std::size_t cell, face_parameters& at)
    {
        const std::size_t n = face.degree, corner = cell / 2;
        const bool is_first = cell % 2 == 0;
        const double s = at.s, t = at.t;
        if (s + 2 * t > 1) { // a vertex of the child is the middle of the edge
            at.replace(2 - 2 * s - 2 * t, -2, -2, s + 2 * t - 1, 1, 2);
            return {n, is_first ? 2 * corner + 1 : 2 * ((corner + n - 1) % n)};
        }
        at.replace(2 * t, 0, 2, 1 - s - 2 * t, -1, -2);
        return {corner, is_first ? std::size_t(0) : std::size_t(3)};
    }
};

/// The domain of unified: odd degrees have the quad split, even ones the dual split.
template <>
struct face_domain<decltype(unified{}.columns())> : domain_of_rings {
    using primal = face_domain<decltype(quad_split::columns())>;
    using dual = face_domain<decltype(dual_split().columns())>;
    static constexpr std::size_t sides = 4;
    static constexpr bool is_tensor = true;
    static constexpr std::size_t fineness = 2;
    static constexpr int steps = 27;
    static constexpr bool is_cut_off_by_boundaries = false; // closed meshes have none
    static constexpr bool has_polynomials_at_boundaries = true;
    static constexpr auto corners = domain_of_quads::corners;

    static constexpr std::size_t degree = 5; ///< polynomials of higher degrees drown in rounding errors

    /// Returns the degree of a scheme. Errors: mesh_error for a higher degree.
    static std::size_t degree_of(const unified& scheme)
    {
        if (scheme.degree > int(degree))
            throw mesh_error("unified: polynomials of degree " + std::to_string(scheme.degree) +
                             " are not found between control points; take a degree up to " + std::to_string(degree));
        return std::size_t(scheme.degree);
    }
    static bool has_vertices_at_corners(const domain_face& face) { return not face.is_dual; }
    static std::size_t corner_at(const domain_face& face, std::size_t cell, const std::array<double, 2>& at)
    {
        return face.is_dual ? dual::corner_at(face, cell, at) : primal::corner_at(face, cell, at);
    }
    static std::size_t cells(const domain_face& face) { return face.is_dual ? dual::cells(face) : primal::cells(face); }
    static std::size_t enter(const domain_face& face, std::size_t corner, face_parameters& at)
    {
        return face.is_dual ? dual::enter(face, corner, at) : primal::enter(face, corner, at);
    }
    static std::size_t children(const domain_face& face)
    {
        return face.is_dual ? dual::children(face) : primal::children(face);
    }
    template <std::unsigned_integral Index, class Ids>
    static std::size_t child(const connectivity<Index>& mesh, const Ids& ids, const domain_face& face, std::size_t k)
    {
        return face.is_dual ? dual::child(mesh, ids, face, k) : primal::child(mesh, ids, face, k);
    }
    template <std::unsigned_integral Index, class Ids>
    static std::size_t vertex_of_child(const connectivity<Index>& mesh, const Ids& ids, const domain_face& face,
                                       std::size_t k)
    {
        return face.is_dual ? dual::vertex_of_child(mesh, ids, face, k) : primal::vertex_of_child(mesh, ids, face, k);
    }
    static std::size_t cell_of_child(const domain_face& child, std::size_t first, std::size_t cell)
    {
        return child.is_dual ? dual::cell_of_child(child, first, cell) : primal::cell_of_child(child, first, cell);
    }
    static child_cell descend(const domain_face& face, std::size_t cell, face_parameters& at)
    {
        return face.is_dual ? dual::descend(face, cell, at) : primal::descend(face, cell, at);
    }
};

} // namespace kith::detail
