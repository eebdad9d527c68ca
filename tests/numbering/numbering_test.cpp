// SPDX-License-Identifier: BSD-3-Clause
#include <kith/numbering/association/numbering.hpp>

#include "support/error_text.hpp"
#include "support/every_level.hpp"
#include "support/every_scheme.hpp"

#include <gtest/gtest.h>

#include <cstdint>

using kith::tuple_kind;

namespace {

template <class Scheme>
using numbering_of = kith::numbering<decltype(kith::columns_of(Scheme(), 0)), std::uint32_t>;

/// Returns the id under a tuple whose kind is known only at run time; `none` if its column is missing.
template <class Ids>
std::size_t id_of(const Ids& ids, tuple_kind kind, std::size_t index)
{
    std::size_t result = ids.none;
    const auto look = [&]<tuple_kind Kind>(std::integral_constant<tuple_kind, Kind>) {
        if constexpr (Ids::template has<Kind>)
            if (kind == Kind)
                result = ids.template id<Kind>(index);
    };
    const auto look_all = [&]<tuple_kind... Kind>(std::integer_sequence<tuple_kind, Kind...>) {
        (look(std::integral_constant<tuple_kind, Kind>()), ...);
    };
    look_all(std::integer_sequence<tuple_kind,
                                   tuple_kind::v,
                                   tuple_kind::e,
                                   tuple_kind::f,
                                   tuple_kind::vf,
                                   tuple_kind::ve,
                                   tuple_kind::ef,
                                   tuple_kind::vfe>());
    return result;
}

/// Returns the number of tuples that have an id.
template <class Ids>
std::size_t count_ids(const Ids& ids, const level_type& level)
{
    std::size_t count = 0;
    for (const auto kind :
         {tuple_kind::v, tuple_kind::e, tuple_kind::f, tuple_kind::vf, tuple_kind::ve, tuple_kind::ef, tuple_kind::vfe})
        for (std::size_t i = 0; i < tuple_count(level, kind); ++i)
            count += id_of(ids, kind, i) != ids.none;
    return count;
}

template <class Test>
void for_each_numbering(const Test& test)
{
    for_each_scheme_and_shape([&](const auto& scheme, const mesh3d& mesh) {
        const level_type level(mesh);
        for (const int generation : {0, 1}) {
            const numbering_of<std::remove_cvref_t<decltype(scheme)>> ids(level, kith::columns_of(scheme, generation));
            test(level, ids.vertices);
            test(level, ids.edges);
            test(level, ids.faces);
        }
    });
}

} // namespace

TEST(numbering, every_element_has_an_origin_that_leads_back_to_it)
{
    for_each_numbering([](const level_type&, const auto& ids) {
        for (std::size_t id = 0; id < ids.total(); ++id) {
            const auto [kind, index] = ids.origin(id);
            EXPECT_EQ(id_of(ids, kind, index), id);
        }
    });
}

TEST(numbering, every_tuple_has_its_own_element)
{
    for_each_numbering([](const level_type& level, const auto& ids) { EXPECT_EQ(count_ids(ids, level), ids.total()); });
}

TEST(numbering, coarse_vertices_keep_their_numbers_in_primal_schemes)
{
    const auto mesh = native(shapes::open_house());
    const level_type level(mesh);
    const numbering_of<kith::catmull_clark> ids(level, kith::catmull_clark::columns());
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v)
        EXPECT_EQ(ids.vertices.id<tuple_kind::v>(v), v);
}

TEST(numbering, knows_the_degree_of_all_new_faces_while_compiling)
{
    EXPECT_EQ(numbering_of<kith::catmull_clark>::common_degree, 4U);
    EXPECT_EQ(numbering_of<kith::loop>::common_degree, 3U);
    EXPECT_EQ(numbering_of<kith::doo_sabin>::common_degree, 0U);
}

TEST(numbering, columns_may_depend_on_the_generation)
{
    const auto mesh = native(shapes::umbrella(5));
    const level_type level(mesh);
    const numbering_of<kith::sqrt3> even(level, kith::sqrt3::columns(0)), odd(level, kith::sqrt3::columns(1));
    EXPECT_EQ(even.vertices.total(), 6U + 5U); // with the centres of the faces
    EXPECT_EQ(odd.vertices.total(), 6U + 10U); // with two points on each boundary edge instead
}

TEST(numbering, refuses_more_elements_than_its_index_can_number)
{
    const auto mesh = native(shapes::torus(100, 100));
    const level_type level(mesh);
    const auto number = [&]<class Index>(Index) {
        const auto columns = kith::catmull_clark::columns();
        kith::numbering<std::remove_const_t<decltype(columns)>, Index>(level, columns);
    };
    EXPECT_EQ(error_text<kith::mesh_error>([&] { number(std::uint16_t()); }),
              "the next level has 80000 edges, more than a 16-bit index can number; refine fewer times or use "
              "basic_mesh<Point, std::uint64_t>");
    EXPECT_NO_THROW(number(std::uint32_t()));
}
