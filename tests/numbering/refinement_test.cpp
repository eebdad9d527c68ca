// SPDX-License-Identifier: BSD-3-Clause
#include <kith/numbering/step/refinement.hpp>

#include "support/consistent.hpp"
#include "support/error_text.hpp"
#include "support/own_scheme.hpp"
#include "support/same_mesh.hpp"

#include <kith/doo_sabin.hpp>
#include <kith/numbering/step/blocks.hpp>
#include <kith/refine.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <vector>

namespace {

using namespace kith::targets;
using kith::connect;
using kith::new_edges;
using kith::new_faces;
using kith::new_vertices;

/// Schemes that copy a mesh: its vertices and faces; derived schemes also copy its edges.
constexpr auto degree_of = [](const auto& f) { return f.degree(); };
struct copy_by_faces {
    static constexpr auto columns()
    {
        return kith::columns(new_vertices(kith::per_vertex), new_faces(kith::per_face.of_degree(degree_of)));
    }
    template <class R>
    void operator()(const R& r) const
    {
        for (auto v : r.coarse.vertices())
            r.assoc(v, V) = v;
        for (auto f : r.coarse.faces())
            r.assoc(f, F) = polygon(r.assoc(f.vertices(), V));
    }
};
struct copy_with_edges {
    static constexpr auto columns()
    {
        return kith::columns(
            new_vertices(kith::per_vertex), new_edges(kith::per_edge), new_faces(kith::per_face.of_degree(degree_of)));
    }
    template <class R>
    void operator()(const R& r) const
    {
        const auto& assoc = r.assoc;
        for (auto v : r.coarse.vertices())
            assoc(v, V) = v;
        for (auto f : r.coarse.faces())
            assoc(f, F) = polygon(f.corners(), [&](auto c) {
                const auto e = c.next_edge();
                return assoc(c.v(), V) >> assoc(e, E).along(e);
            });
    }
};
struct copy_with_starts : copy_with_edges {
    template <class R>
    void operator()(const R& r) const
    {
        copy_with_edges::operator()(r);
        for (auto v : r.coarse.vertices()) {
            const auto c = v.first_corner();
            const auto e = c.next_edge();
            r.assoc(v, V).starts_at(r.assoc(c.f(), F).corner(c.index() - c.f().first_corner().index()),
                                    r.assoc(e, E).along(e));
        }
    }
};

/// A copying scheme that records the generation and the scalar type of its last step.
struct asks : copy_by_faces {
    static inline int generation = -1;
    static inline std::size_t scalar_bytes = 0;
    template <class R>
    void operator()(const R& r) const
    {
        generation = r.generation;
        scalar_bytes = sizeof(kith::scalar_type<R>);
        copy_by_faces::operator()(r);
    }
};

template <connect Connect, class Scheme>
mesh3d step(const mesh3d& mesh, const Scheme& scheme)
{
    kith::numbering_of<Scheme, std::uint32_t> ids;
    return kith::refine_mesh<Connect>(mesh, scheme, ids);
}

} // namespace

TEST(refinement, faces_alone_are_matched)
{
    for (const auto& shape : {shapes::house(), shapes::open_house(), shapes::cube(), shapes::polygon(7)}) {
        const auto mesh = native(shape);
        EXPECT_TRUE(same_arrays(step<connect::everything>(mesh, copy_by_faces()).topology(), mesh.topology()));
    }
}

TEST(refinement, declared_edges_need_no_matching)
{
    for (const auto& shape : {shapes::house(), shapes::open_house(), shapes::cube(), shapes::polygon(7)}) {
        const auto mesh = native(shape);
        EXPECT_TRUE(same_arrays(step<connect::everything>(mesh, copy_with_starts()).topology(), mesh.topology()));
    }
}

TEST(refinement, fans_without_a_start_get_one)
{
    for (const auto& shape : {shapes::house(), shapes::open_house()})
        expect_consistent(step<connect::everything>(native(shape), copy_with_edges()).topology());
}

TEST(refinement, faces_of_one_degree_need_no_offsets)
{
    EXPECT_EQ(kith::refine(native(shapes::torus(3, 4)), kith::doo_sabin(), 1).topology().degree, 4);
    EXPECT_EQ(kith::refine(native(shapes::cube()), kith::doo_sabin(), 1).topology().degree, 0);
    EXPECT_EQ(step<connect::everything>(native(shapes::tetrahedron()), copy_by_faces()).topology().degree, 3);
}

TEST(refinement, lists_of_faces_have_no_edges)
{
    const auto fine = step<connect::faces>(native(shapes::house()), copy_with_edges());
    EXPECT_TRUE(fine.topology().faces_only());
    EXPECT_EQ(fine.edge_count(), 0U);
    EXPECT_EQ(fine.face(10)[1], 10U);
}

TEST(refinement, values_alone_have_no_connectivity)
{
    const auto fine = step<connect::nothing>(native(shapes::house()), copy_with_edges());
    EXPECT_EQ(fine.points().size(), 11U);
    EXPECT_EQ(fine.face_count() + fine.corner_count() + fine.edge_count(), 0U);
}

TEST(refinement, tells_the_scheme_the_generation_and_the_scalar_type)
{
    const std::vector<std::array<float, 3>> points(11);
    EXPECT_EQ(kith::refine(kith::make_mesh(points, shapes::house().faces), asks(), 3).generation(), 3);
    EXPECT_EQ(asks::generation, 2);
    EXPECT_EQ(asks::scalar_bytes, sizeof(float));
}

namespace {

/// A scheme with a quad for each corner, whose degree is not known at compile time. It declares no edges.
struct cut_by_faces {
    static constexpr auto columns()
    {
        const auto four = [](const auto&) { return std::size_t(4); };
        return kith::columns(new_vertices(kith::per_vertex, kith::per_edge, kith::per_face),
                             new_faces(kith::per_corner.of_degree(four)));
    }
    template <class R>
    void operator()(const R& r) const
    {
        const auto& assoc = r.assoc;
        for (auto v : r.coarse.vertices())
            assoc(v, V) = v;
        for (auto e : r.coarse.edges())
            assoc(e, V) = average(e.org(), e.dst());
        for (auto f : r.coarse.faces())
            assoc(f, V) = average(f.vertices());
        for (auto c : r.coarse.corners())
            assoc(c, F) = polygon(assoc(c.v(), V), assoc(c.next_edge(), V), assoc(c.f(), V), assoc(c.prev_edge(), V));
    }
};

} // namespace

namespace {

/// A copying scheme whose functions take their arguments by non-const reference.
struct by_reference : copy_by_faces {
    template <class R>
    void operator()(R& r) const
    {
        in_blocks(r, [](auto& part) { static_cast<void>(part.generation); });
        copy_by_faces::operator()(r);
    }
};

} // namespace

TEST(refinement, may_be_taken_by_any_reference)
{
    EXPECT_TRUE(same_bits(kith::refine(native(shapes::house()), by_reference(), 1),
                          kith::refine(native(shapes::house()), copy_by_faces(), 1)));
}

TEST(refinement, refuses_more_corners_than_the_index_can_number)
{
    const auto refine_grid = [](std::size_t n, connect last) {
        const auto [points, faces] = shapes::grid(n, n);
        return error_text<kith::mesh_error>(
            [&] { kith::refine(kith::make_mesh<std::uint16_t>(points, faces), cut_by_faces(), 1, {last}); });
    };
    EXPECT_EQ(refine_grid(70, connect::faces),
              "the next level has 78400 corners, more than a 16-bit index can number; refine fewer times or use "
              "basic_mesh<Point, std::uint64_t>");
    EXPECT_EQ(refine_grid(50, connect::faces), "no error"); // 40000
    EXPECT_NE(refine_grid(50, connect::everything).find("40000 corners"), std::string::npos);
    EXPECT_EQ(refine_grid(40, connect::everything), "no error");
}
