// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "native_shape.hpp"

#include <kith/fields/with_fields.hpp>
#include <kith/four_eight.hpp>
#include <kith/hierarchy.hpp>
#include <kith/refine_with_fields.hpp>
#include <kith/sqrt3.hpp>
#include <kith/tri_quad.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

/// The marks of 4-8 and the parity of sqrt(3) as fields. On every level, these must agree with the marks in the
/// connectivity and with the generation.
namespace marks_and_parity {

/// Returns an open or closed triangle mesh whose elements have different neighbourhoods.
inline mesh3d some_triangles(bool open)
{
    return native(
        shapes::triangulated(open ? shapes::shaken(shapes::grid(4, 5)) : shapes::shaken(shapes::torus(6, 6))));
}
/// Returns a mesh that 4-8 refines: closed, from quads with diagonals, or open, with a vertex in the middle of every
/// face.
inline mesh3d some_tri_quad(bool open)
{
    return kith::tri_quad(native(open ? shapes::shaken(shapes::open_house()) : shapes::shaken(shapes::torus(6, 6))));
}

/// The parity of a new vertex: the opposite of the parity of the coarse level, which all its vertices have.
struct other_parity {
    bool operator()(const auto&, const auto& values) const { return values[0] == 0; }
};

/// Returns 4-8 with the marks of the mesh as a field.
template <class M>
auto with_marks(const M& mesh)
{
    return kith::with_fields(kith::four_eight{}, kith::marked_edges(mesh));
}
/// Returns sqrt(3) with a field that is true at each vertex if the next step is an odd one.
template <class M>
auto with_parity(const M& mesh, bool is_odd)
{
    const std::vector<char> odd(kith::level_of<M>(mesh).vertex_count(), char(is_odd));
    return kith::with_fields(kith::sqrt3{},
                             kith::on_vertices(odd, kith::from_vertex<std::logical_not<>, other_parity>{}));
}

/// Returns how the field differs from the marks of the level, or "".
template <class M, class Scheme>
std::string wrong_marks(const M& mesh, const Scheme& scheme)
{
    const kith::level_of<M> level(mesh);
    const auto& marks = scheme.field();
    if (marks.size() != level.edge_count())
        return std::to_string(marks.size()) + " marks of " + std::to_string(level.edge_count()) + " edges";
    for (const auto e : level.edges())
        if (marks[e.index()] != kith::bisection_split::is_marked(e))
            return "edge " + std::to_string(e.index());
    return {};
}
/// Returns how the field differs from the parity of the level, or "".
template <class M, class Scheme>
std::string wrong_parity(const M& mesh, const Scheme& scheme, int generation)
{
    const auto& odd = scheme.field();
    if (odd.size() != kith::level_of<M>(mesh).vertex_count())
        return std::to_string(odd.size()) + " values";
    for (std::size_t v = 0; v < odd.size(); ++v)
        if (bool(odd[v]) != kith::sqrt3_split::is_odd(generation))
            return "vertex " + std::to_string(v);
    return {};
}

/// Expects right marks and parities on every level of a hierarchy and after `refine_with_fields`.
template <class M>
void expect_marks_and_parity(const M& tri_quad, const M& triangles)
{
    auto last = with_marks(tri_quad);
    kith::hierarchy halved(tri_quad, last);
    halved.refine(4);
    for (int level = 0; level <= 4; ++level)
        EXPECT_EQ(wrong_marks(halved[level], halved.scheme(level)), "") << level;
    EXPECT_EQ(wrong_marks(kith::refine_with_fields(tri_quad, last, 3), last), "");

    auto odd = with_parity(triangles, false);
    kith::hierarchy levels(triangles, odd);
    levels.refine(3);
    for (int level = 0; level <= 3; ++level)
        EXPECT_EQ(wrong_parity(levels[level], levels.scheme(level), level), "") << level;
    const auto once = kith::refine_with_fields(triangles, odd, 1);
    EXPECT_EQ(wrong_parity(once, odd, 1), "");
    EXPECT_EQ(wrong_parity(kith::refine_with_fields(once, odd, 2), odd, 3), "");
}

} // namespace marks_and_parity
