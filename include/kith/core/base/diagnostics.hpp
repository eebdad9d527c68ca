// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "in_library.hpp"

/// The compiler errors for mistakes in the text of a scheme. A scheme is compiled for several kinds of levels. Each
/// message depends on the mistake alone, so the compiler prints it once. An expression with a mistake has a type that
/// fits everywhere, so that no further errors follow.
namespace kith::diagnostics {

template <bool Mistake>
struct face_of_other_things {
    static_assert(not Mistake, "kith: a new face takes its vertices: assoc(x, F) = polygon(assoc(a, V), assoc(b, V), "
                               "assoc(c, V)); a mask makes a vertex: assoc(x, V) = mask");
};
template <bool Mistake>
struct vertex_of_other_things {
    static_assert(not Mistake,
                  "kith: a new vertex takes a mask: vertices, associations assoc(x, V), and sums of them with "
                  "weights; an edge stands for average(e.org(), e.dst()), a face for average(f.vertices())");
};
template <bool Mistake>
struct edge_that_is_set {
    static_assert(not Mistake, "kith: a new edge is not set; the lines of its two faces name its sides: "
                               "assoc(v, V) >> assoc(e, E).left()");
};
template <bool Mistake>
struct no_target {
    static_assert(not Mistake,
                  "kith: assoc takes one to three elements, or a range of them, and last what they lead to: "
                  "assoc(e, V), assoc(v, e, E), assoc(f, f.vertices(), V)");
};
template <bool Mistake>
struct average_of_one {
    static_assert(not Mistake,
                  "kith: the average of one vertex is the vertex; leave average() out, or give it a range such "
                  "as f.vertices() or several operands");
};
template <bool Mistake>
struct sum_of_other_things {
    static_assert(not Mistake,
                  "kith: sum() and average() take vertices, associations assoc(x, V) and masks, or one range of "
                  "them: v.neighbors(), assoc(v.faces(), V); an edge stands for average(e.org(), e.dst()), a "
                  "face for average(f.vertices())");
};
template <bool Mistake>
struct product {
    static_assert(not Mistake, "kith: a mask is multiplied by a number that stands before it: 0.5 * v; masks have no "
                               "product");
};
template <bool Mistake>
struct polygon_of_few {
    static_assert(not Mistake,
                  "kith: a polygon has three vertices or more: polygon(a, b, c), polygon(assoc(f.vertices(), "
                  "V)), polygon(f.corners(), line_of)");
};
template <bool Mistake>
struct polygon_of_other_things {
    static_assert(not Mistake,
                  "kith: a polygon takes new vertices, assoc(v, V) or assoc(v, V) >> side; vertices of the "
                  "coarse level and masks are none");
};
template <bool Mistake>
struct scheme_call {
    static_assert(not Mistake, "kith: a scheme needs a const operator that takes its refinement by const reference: "
                               "template <class R> void operator()(const R& r) const");
};
template <bool Mistake>
struct scheme_columns {
    static_assert(not Mistake,
                  "kith: a scheme needs columns() or columns(int generation), const or static, that returns "
                  "kith::columns(...)");
};

template <bool Mistake>
struct columns_of_other_things {
    static_assert(not Mistake,
                  "kith: columns() takes new_vertices(...), new_faces(...) and, where the scheme declares its edges, "
                  "new_edges(...): each once, in any order");
};
template <bool Mistake>
struct points_in_a_mask {
    static_assert(not Mistake, "kith: a mask combines vertices, not their points: write average(e.org(), e.dst()) "
                               "instead of average(e.org().point(), e.dst().point())");
};
template <bool Mistake>
struct point_without_affine {
    static_assert(not Mistake,
                  "kith: these points or values have no kith::affine, which says how they are added and scaled; "
                  "specialise kith::affine for their type, or take std::array<double, 3>");
};
template <bool Mistake>
struct unnamed_state {
    static_assert(not Mistake,
                  "kith: a scheme keeps a container, a pointer or a class with memory of its own that traits().state "
                  "does not name; in tiles and on ranks it would be read by the numbers of other elements. Values per "
                  "element are state: .state = &its_scheme::its_member, such as a field; say .constants_only = true if "
                  "no value belongs to an element");
};
template <bool Mistake>
struct scheme_without_reach {
    static_assert(not Mistake,
                  "kith: tiles and ranks refine schemes that say in their traits() how far a step reaches: .reach = "
                  "[](int rings) {...}; selected refines some faces only, and schemes for closed meshes take no tile: "
                  "refine with hierarchy, or all faces with the scheme itself");
};

/// The sides of a polygon that is not valid.
struct any_lines {};

} // namespace kith::diagnostics
