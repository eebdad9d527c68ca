// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/mesh/connectivity.hpp>
#include <kith/numbering/association/columns.hpp>
#include <kith/numbering/step/scheme.hpp>
#include <kith/schemes/split/quad_split.hpp>
#include <kith/schemes/split/sqrt3_split.hpp>
#include <kith/schemes/split/ternary_split.hpp>
#include <kith/schemes/split/triangle_split.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace kith::detail {

/// The parameters s and t in a face of some level. They have derivatives by u and v of the face in the control mesh.
struct face_parameters {
    double s, t;
    double s_u = 1, s_v = 0, t_u = 0, t_v = 1;

    /// Replaces s and t by linear functions of them, constant + of_s * s + of_t * t.
    void replace(double new_s, double s_by_s, double s_by_t, double new_t, double t_by_s, double t_by_t)
    {
        *this = {new_s,
                 new_t,
                 s_by_s * s_u + s_by_t * t_u,
                 s_by_s * s_v + s_by_t * t_v,
                 t_by_s * s_u + t_by_t * t_u,
                 t_by_s * s_v + t_by_t * t_v};
    }
};

/// A cell of a child face. The cells of a face are its parts with parameters of their own: the face itself, or a
/// sub-face per corner.
struct child_cell {
    std::size_t child, cell;
};
/// The facts about a face that determine how a step cuts its parameters.
struct domain_face {
    std::size_t number; ///< of the face in its mesh
    std::size_t degree;
    std::array<bool, 4> is_wall{}; ///< of the first four sides, true if they lie at the boundary
    bool is_odd = false;           ///< of the generation of the mesh
    bool is_dual = false;          ///< true if a scheme of both kinds makes faces of vertices
};

/// Returns the domain_face of a face.
template <std::unsigned_integral Index, class Scheme>
domain_face look_at(const connectivity<Index>& mesh, const Scheme& scheme, int generation, std::size_t face)
{
    const std::size_t first = mesh.first_corner(face), degree = mesh.first_corner(face + 1) - first;
    domain_face result{face, degree, {}, sqrt3_split::is_odd(generation)};
    if constexpr (requires { scheme.is_primal(); })
        result.is_dual = not scheme.is_primal();
    for (std::size_t k = 0; k < std::min(degree, result.is_wall.size()); ++k)
        result.is_wall[k] = mesh.across(Index(first + k)) == mesh.none;
    return result;
}

/// The common members of the domains of most splits.
struct domain_of_rings {
    static constexpr bool splits_in_four = false;
    static constexpr bool keeps_first_corners = false;
    static constexpr int steps_at_once = 1;
    static constexpr int rings = 0; // 0 for the rings of the scheme
    static constexpr int most_steps = 100;

    /// Returns the faces within `ring_count` rings of a face.
    template <class Cutter, std::unsigned_integral Index>
    static std::vector<Index> faces_around(Cutter& cutter, const connectivity<Index>&, Index face, int ring_count)
    {
        return cutter.faces_around(std::span<const Index>(&face, 1), ring_count);
    }
};

/// The parameters of the corners of a face.
template <std::size_t Sides>
inline constexpr auto corners_of_faces = [] {
    if constexpr (Sides == 4)
        return std::array<std::array<double, 2>, 4>{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    else
        return std::array<std::array<double, 2>, 3>{{{0, 0}, {1, 0}, {0, 1}}};
}();

/// The common members of the domains of faces whose corners are vertices.
template <std::size_t Sides>
struct domain_at_vertices : domain_of_rings {
    static constexpr std::size_t sides = Sides;
    static constexpr bool is_cut_off_by_boundaries = false;
    static constexpr bool has_polynomials_at_boundaries = true;

    static bool has_vertices_at_corners(const domain_face&) { return true; }
    static std::size_t cells(const domain_face& face) { return face.degree == sides ? 1 : face.degree; }
    static std::size_t enter(const domain_face&, std::size_t corner, face_parameters&) { return corner; }
    static std::size_t corner_at(const domain_face&, std::size_t, const std::array<double, 2>& at)
    {
        return std::size_t(std::ranges::find(corners_of_faces<Sides>, at) - corners_of_faces<Sides>.begin());
    }
    /// Returns -1: children begin at the corner from which their sub-faces are counted.
    template <class... Parts>
    static std::size_t vertex_of_child(const Parts&...)
    {
        return std::size_t(-1);
    }
    static std::size_t cell_of_child(const domain_face&, std::size_t, std::size_t cell) { return cell; }
};

/// The parameters of quads under splits that keep them quads. All other polygons consist of sub-faces.
struct domain_of_quads : domain_at_vertices<4> {
    static constexpr bool is_tensor = true;
    static constexpr auto corners = corners_of_faces<4>;

    static constexpr std::size_t degree = 3; ///< of the splines that are searched for
    /// Turns the parameters of a quad a quarter: corner 1 becomes the origin.
    static void turn(face_parameters& at) { at.replace(at.t, 0, 1, 1 - at.s, -1, 0); }
};

/// The rules by which a split cuts the parameters of faces. Members of a specialization:
///
///   sides, corners                            of a face with parameters of its own
///   cells(face)                               the number of cells of a domain_face
///   enter(face, corner, parameters)           the cell of a place; replaces its parameters by those in the cell
///   corner_at(face, cell, parameters)         the corner of the face at a corner of a cell; `sides` if there is none.
///                                             0 for the centre of the face if its corners are no vertices
///   is_tensor, degree                         of the splines that are searched for in cells
///   fineness                                  of a lattice that has points in all children
///   steps                                     number of steps after which a net is small
///   most_steps                                number of steps after which it is a point, up to rounding
///   rings                                     around a face that determine its surface; 0 for those of the scheme
///   faces_around(cutter, mesh, f, rings)      the faces within these rings
///   steps_at_once                             from a face to its children
///   children(face)                            the number of children after one step
///   child(mesh, ids, face, k)                 the number of child k after one step
///   vertex_of_child(mesh, ids, face, k)       its vertex from which cells are counted; -1 for its first corner
///   descend(face, cell, parameters)           the child_cell of a place; replaces its parameters by those in it
///   cell_of_child(child, first, cell)         the number of that cell; `first` is the corner of vertex_of_child
///   is_at_wall(face, cell, parameters)        true if a place lies on the boundary of the surface; needed only without
///                                             has_polynomials_at_boundaries
///   keeps_first_corners                       true if the first corners of faces have a meaning
///   has_vertices_at_corners(face), splits_in_four, is_cut_off_by_boundaries, has_polynomials_at_boundaries
template <class Columns>
struct face_domain;

template <>
struct face_domain<decltype(quad_split::columns())> : domain_of_quads {
    static constexpr bool splits_in_four = true;
    static constexpr std::size_t fineness = 2;
    static constexpr int steps = 27;

    static std::size_t children(const domain_face& face) { return face.degree; }
    template <std::unsigned_integral Index, class Ids>
    static std::size_t child(const connectivity<Index>& mesh, const Ids& ids, const domain_face& face, std::size_t k)
    {
        return ids.faces.template id<tuple_kind::vf>(mesh.first_corner(face.number) + k);
    }
    static child_cell descend(const domain_face& face, std::size_t cell, face_parameters& at)
    {
        if (face.degree != sides)
            return {cell, 0};
        const std::size_t corner = at.t < .5 ? at.s < .5 ? 0 : 1 : at.s < .5 ? 3 : 2;
        move_to_quarter(corner, at);
        return {corner, 0};
    }
    /// Replaces parameters of a quad by those of the quarter at a corner.
    static void move_to_quarter(std::size_t corner, face_parameters& at)
    {
        const double s = at.s, t = at.t;
        switch (corner) {
        case 0: at.replace(2 * s, 2, 0, 2 * t, 0, 2); break;
        case 1: at.replace(2 * t, 0, 2, 2 * (1 - s), -2, 0); break;
        case 2: at.replace(2 * (1 - s), -2, 0, 2 * (1 - t), 0, -2); break;
        default: at.replace(2 * (1 - t), 0, -2, 2 * s, 2, 0); break;
        }
    }
};

/// The domain of the ternary split. Polygons stay, in the middle, with their sub-faces.
template <>
struct face_domain<decltype(ternary_split::columns())> : domain_of_quads {
    static constexpr std::size_t fineness = 3;
    static constexpr int steps = 17;

    static std::size_t children(const domain_face& face) { return 2 * face.degree + 1; }
    /// Returns the number of child k. Children are the faces at corners, those at sides, and the one in the middle.
    template <std::unsigned_integral Index, class Ids>
    static std::size_t child(const connectivity<Index>& mesh, const Ids& ids, const domain_face& face, std::size_t k)
    {
        const std::size_t first = mesh.first_corner(face.number), n = face.degree;
        return k < n       ? ids.faces.template id<tuple_kind::vf>(first + k)
               : k < 2 * n ? ids.faces.template id<tuple_kind::ef>(first + k - n)
                           : ids.faces.template id<tuple_kind::f>(face.number);
    }
    static child_cell descend(const domain_face& face, std::size_t cell, face_parameters& at)
    {
        const std::size_t n = face.degree;
        constexpr double third = 1. / 3;
        if (n != sides) { // sub-faces have half of a side
            const bool is_far_in_s = at.s >= 2 * third, is_far_in_t = at.t >= 2 * third;
            if (is_far_in_s and is_far_in_t) {
                at.replace(3 * at.s - 2, 3, 0, 3 * at.t - 2, 0, 3);
                return {2 * n, cell};
            }
            if (is_far_in_t) {
                at.replace(2 - 1.5 * at.t, 0, -1.5, 1.5 * at.s, 1.5, 0);
                return {n + (cell + n - 1) % n, 0};
            }
            at.replace(1.5 * at.s - (is_far_in_s ? 1 : 0), 1.5, 0, 1.5 * at.t, 0, 1.5);
            return {is_far_in_s ? n + cell : cell, 0};
        }
        const auto third_of = [](double x) { return x <= third ? 0 : x < 2 * third ? 1 : 2; };
        const int i = third_of(at.s), j = third_of(at.t);
        if (i == 1 and j == 1) {
            at.replace(3 * at.s - 1, 3, 0, 3 * at.t - 1, 0, 3);
            return {2 * n, 0};
        }
        const std::size_t corner = j == 0 and i < 2 ? 0 : i == 2 and j < 2 ? 1 : j == 2 and i > 0 ? 2 : 3;
        for (std::size_t k = 0; k < corner; ++k)
            turn(at);
        const bool is_at_side = i == 1 or j == 1;
        at.replace(3 * at.s - (is_at_side ? 1 : 0), 3, 0, 3 * at.t, 0, 3);
        return {is_at_side ? n + corner : corner, 0};
    }
};

/// The parameters of triangles.
struct domain_of_triangles : domain_at_vertices<3> {
    static constexpr bool is_tensor = false;
    static constexpr auto corners = corners_of_faces<3>;

    static constexpr std::size_t degree = 4; ///< of the splines that are searched for
    /// Turns the parameters of a triangle: corner 1 becomes the origin.
    static void turn(face_parameters& at) { at.replace(at.t, 0, 1, std::max(1 - at.s - at.t, 0.), -1, -1); }
};

template <>
struct face_domain<decltype(triangle_split::columns())> : domain_of_triangles {
    static constexpr bool splits_in_four = true;
    static constexpr std::size_t fineness = 2;
    static constexpr int steps = 27;

    static std::size_t children(const domain_face&) { return 4; }
    /// Returns the number of child k. Children are the faces at corners, and the one in the middle.
    template <std::unsigned_integral Index, class Ids>
    static std::size_t child(const connectivity<Index>& mesh, const Ids& ids, const domain_face& face, std::size_t k)
    {
        return k < 3 ? ids.faces.template id<tuple_kind::vf>(mesh.first_corner(face.number) + k)
                     : ids.faces.template id<tuple_kind::f>(face.number);
    }
    static child_cell descend(const domain_face&, std::size_t, face_parameters& at)
    {
        const double s = at.s, t = at.t, r = std::max(1 - s - t, 0.);
        const std::size_t child = s + t <= .5 ? 0 : s >= .5 ? 1 : t >= .5 ? 2 : 3;
        switch (child) {
        case 0: at.replace(2 * s, 2, 0, 2 * t, 0, 2); break;
        case 1: at.replace(2 * t, 0, 2, 2 * r, -2, -2); break;
        case 2: at.replace(2 * r, -2, -2, 2 * s, 2, 0); break;
        default: at.replace(1 - 2 * t, 0, -2, std::max(1 - 2 * r, 0.), 2, 2); break; // in the middle
        }
        return {child, 0};
    }
};

} // namespace kith::detail
