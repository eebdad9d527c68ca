// SPDX-License-Identifier: BSD-3-Clause
#include <kith/numbering/association/column_ids.hpp>

#include "support/every_level.hpp"

#include <gtest/gtest.h>

#include <concepts>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

using kith::tuple_kind;

namespace {

const mesh3d closed = native(shapes::house());
const mesh3d open = native(shapes::grid(2, 2)); // edges 0-1 0-3 1-2 1-4 2-5 3-4 3-6 4-5 4-7 5-8 6-7 7-8
const std::vector<std::size_t> inner_edges_of_open{3, 5, 7, 8};

template <class... Columns>
auto ids_on(const mesh3d& mesh, const Columns&... columns)
{
    return kith::column_ids<std::uint32_t, Columns...>(level_type(mesh), std::tuple(columns...));
}

constexpr auto never = [](const auto&) { return false; };
constexpr auto always = [](const auto&) { return true; };

/// Expects that the origin of every id is the tuple with this id.
template <tuple_kind... Kinds>
void expect_inverse(const auto& ids)
{
    for (std::size_t id = 0; id < ids.total(); ++id) {
        const auto [kind, index] = ids.origin(id);
        const bool same = ((kind == Kinds and ids.template id<Kinds>(index) == id) or ...);
        EXPECT_TRUE(same) << "id " << id;
    }
}

} // namespace

TEST(columns, every_kind_has_as_many_tuples_as_it_has_incidences)
{
    const level_type level(open);
    EXPECT_EQ(tuple_count(level, tuple_kind::v), 9U);
    EXPECT_EQ(tuple_count(level, tuple_kind::e), 12U);
    EXPECT_EQ(tuple_count(level, tuple_kind::f), 4U);
    EXPECT_EQ(tuple_count(level, tuple_kind::vf), 16U);
    EXPECT_EQ(tuple_count(level, tuple_kind::ef), 16U);
    EXPECT_EQ(tuple_count(level, tuple_kind::ve), 24U);
    EXPECT_EQ(tuple_count(level, tuple_kind::vfe), 32U);
}

TEST(columns, an_id_is_the_base_of_its_column_plus_the_index_of_its_tuple)
{
    const auto ids = ids_on(closed, kith::per_vertex, kith::per_edge, kith::per_face);
    EXPECT_EQ(ids.id<tuple_kind::v>(10), 10U);
    EXPECT_EQ(ids.id<tuple_kind::e>(0), 11U);
    EXPECT_EQ(ids.id<tuple_kind::f>(4), 11U + 20 + 4);
    EXPECT_EQ(ids.total(), 42U);
    EXPECT_EQ(ids.base(2), 31U);
    EXPECT_EQ(ids.count(1), 20U);
}

TEST(columns, the_origin_is_the_inverse)
{
    expect_inverse<tuple_kind::ve, tuple_kind::f>(ids_on(closed, kith::per_end, kith::per_face));
    expect_inverse<tuple_kind::ef, tuple_kind::vfe>(ids_on(closed, kith::per_side, kith::per_corner_side));
    expect_inverse<tuple_kind::e, tuple_kind::v>(
        ids_on(open, kith::per_edge.inside(), kith::per_vertex.on_boundary(always)));
}

TEST(columns, inner_tuples_alone_are_numbered_without_gaps)
{
    const auto ids = ids_on(open, kith::per_face, kith::per_edge.inside());
    EXPECT_EQ(ids.count(1), inner_edges_of_open.size());
    for (std::size_t i = 0; i < inner_edges_of_open.size(); ++i)
        EXPECT_EQ(ids.id<tuple_kind::e>(inner_edges_of_open[i]), 4 + i);
    EXPECT_EQ(ids.id<tuple_kind::e>(0), ids.none);
}

TEST(columns, boundary_tuples_can_be_added_by_a_condition)
{
    const auto at_vertex_0 = [](const auto& e) { return e.org().index() == 0 or e.dst().index() == 0; };
    const auto ids = ids_on(open, kith::per_edge.inside_or(at_vertex_0));
    EXPECT_EQ(ids.total(), 6U);
    EXPECT_EQ(ids.id<tuple_kind::e>(0), 0U);
    EXPECT_EQ(ids.id<tuple_kind::e>(1), 1U);
    EXPECT_EQ(ids.id<tuple_kind::e>(3), 2U);
    EXPECT_EQ(ids.id<tuple_kind::e>(2), ids.none);
}

TEST(columns, boundary_tuples_can_be_the_only_ones)
{
    const auto ids = ids_on(open, kith::per_vertex.on_boundary([](const auto& v) { return v.face_count() == 1; }));
    EXPECT_EQ(ids.total(), 4U);
    EXPECT_EQ(ids.id<tuple_kind::v>(8), 3U);
    EXPECT_EQ(ids.id<tuple_kind::v>(4), ids.none);
    EXPECT_EQ(ids.origin(2).second, 6U);
}

TEST(columns, on_a_closed_mesh_the_inner_tuples_are_all)
{
    const auto ids = ids_on(closed, kith::per_edge.inside(), kith::per_vertex.inside_or(never));
    EXPECT_EQ(ids.total(), 31U);
    EXPECT_EQ(ids.id<tuple_kind::e>(19), 19U);
    EXPECT_EQ(ids.id<tuple_kind::v>(3), 23U);
}

TEST(columns, on_a_closed_mesh_there_are_no_boundary_tuples)
{
    const auto ids = ids_on(closed, kith::per_vertex.on_boundary(always), kith::per_face);
    EXPECT_EQ(ids.count(0), 0U);
    EXPECT_EQ(ids.id<tuple_kind::v>(0), ids.none);
    EXPECT_EQ(ids.origin(0).first, tuple_kind::f);
}

TEST(columns, a_condition_may_pick_tuples_anywhere)
{
    const auto odd = [](const auto& e) { return e.index() % 2 == 1; };
    const auto ids = ids_on(closed, kith::per_face, kith::per_edge.only(odd));
    EXPECT_EQ(ids.count(1), 10U);
    EXPECT_EQ(ids.id<tuple_kind::e>(5), 11U + 2);
    EXPECT_EQ(ids.id<tuple_kind::e>(4), ids.none);
    EXPECT_EQ(ids.origin(13).second, 5U);
}

TEST(columns, tuples_that_follow_one_another_are_numbered_without_gaps)
{
    for (const auto& [first, last] : {std::pair(0, 0), {0, 6}, {3, 7}, {8, 20}, {19, 20}, {0, 20}}) {
        const auto among = [first, last](const auto& e) { return int(e.index()) >= first and int(e.index()) < last; };
        const auto ids = ids_on(closed, kith::per_face, kith::per_edge.only(among), kith::per_end.only(among));
        const auto count = std::size_t(last - first);
        ASSERT_EQ(ids.count(1), count);
        ASSERT_EQ(ids.count(2), 2 * count);
        for (int e = 0; e < 20; ++e) {
            const auto expected = [&](std::size_t id) { return e >= first and e < last ? id : ids.none; };
            const auto rank = std::size_t(e - first), edge = std::size_t(e);
            EXPECT_EQ(ids.id<tuple_kind::e>(edge), expected(11 + rank));
            EXPECT_EQ(ids.id<tuple_kind::ve>(2 * edge), expected(11 + count + 2 * rank));
            EXPECT_EQ(ids.id<tuple_kind::ve>(2 * edge + 1), expected(11 + count + 2 * rank + 1));
        }
        expect_inverse<tuple_kind::f, tuple_kind::e, tuple_kind::ve>(ids);
    }
}

TEST(columns, a_form_of_a_scheme_may_have_all_tuples_or_none)
{
    const auto ids = ids_on(open, kith::per_vertex.when(false), kith::per_edge.when(true), kith::per_face.when(false));
    EXPECT_EQ(ids.total(), 12U);
    EXPECT_EQ(ids.id<tuple_kind::v>(0), ids.none);
    EXPECT_EQ(ids.id<tuple_kind::e>(7), 7U);
    EXPECT_EQ(ids.id<tuple_kind::f>(3), ids.none);
    expect_inverse<tuple_kind::v, tuple_kind::e, tuple_kind::f>(ids);
}

TEST(columns, a_condition_sees_the_element_of_the_tuple)
{
    const auto ids = ids_on(open,
                            kith::per_end.on_boundary([](const auto& e) { return e.index() == 6; }),
                            kith::per_corner.on_boundary([](const auto& c) { return c.v().index() == 0; }));
    EXPECT_EQ(ids.count(0), 2U); // both ends of edge 6
    EXPECT_EQ(ids.id<tuple_kind::ve>(13), 1U);
    EXPECT_EQ(ids.count(1), 1U);
}

TEST(columns, a_column_may_tell_the_degree_of_its_faces)
{
    EXPECT_EQ(triangles(kith::per_side).degree(0), 3U);
    EXPECT_EQ(quads(kith::per_corner.inside()).degree(0), 4U);
    const auto valence = kith::per_vertex.inside().of_degree([](const auto& v) { return v.valence(); });
    EXPECT_EQ(valence.degree(level_type(closed).vertices()[0]), 5U);
}

TEST(columns, know_while_compiling_what_they_have)
{
    using ids = decltype(ids_on(open, kith::per_edge.inside(), kith::per_vertex));
    EXPECT_TRUE(ids::has<tuple_kind::e> and ids::has<tuple_kind::v>);
    EXPECT_FALSE(ids::has<tuple_kind::f>);
    EXPECT_TRUE(ids::is_full<tuple_kind::v>);
    EXPECT_FALSE(ids::is_full<tuple_kind::e>);
}

TEST(columns, come_in_any_order)
{
    using namespace kith;
    constexpr new_vertices vertices(per_vertex, per_edge);
    constexpr new_edges edges(per_end);
    constexpr new_faces faces(triangles(per_corner));
    using right = kith::columns<std::remove_const_t<decltype(vertices)>,
                                std::remove_const_t<decltype(edges)>,
                                std::remove_const_t<decltype(faces)>>;
    static_assert(std::same_as<decltype(kith::columns(vertices, edges, faces)), right>);
    static_assert(std::same_as<decltype(kith::columns(vertices, faces, edges)), right>);
    static_assert(std::same_as<decltype(kith::columns(faces, edges, vertices)), right>);
    static_assert(std::same_as<decltype(kith::columns(edges, vertices, faces)), right>);
    static_assert(std::same_as<decltype(kith::columns(faces, vertices)), decltype(kith::columns(vertices, faces))>);
    // The condition of a column is kept.
    const auto only_two = per_edge.when(false);
    EXPECT_FALSE(std::get<0>(kith::columns(faces, new_vertices(only_two)).vertices.list).where.all);
}
