// SPDX-License-Identifier: BSD-3-Clause
#include <kith/numbering/step/scheme.hpp>

#include "support/error_text.hpp"
#include "support/every_level.hpp"

#include <gtest/gtest.h>

namespace {

using namespace kith;

struct nameless {
    static constexpr auto columns() { return kith::columns(new_vertices(per_vertex), new_faces(triangles(per_face))); }
};
struct triangles_by_name : nameless {
    static constexpr auto traits() { return scheme_traits{.name = "by-name", .faces = face_shape::triangles}; }
};
struct closed : nameless {
    static constexpr auto traits() { return scheme_traits{.closed_only = true}; }
};
struct for_few_faces : nameless {
    std::size_t most = 0;
    static constexpr auto traits()
    {
        return scheme_traits{.require = [](const for_few_faces& s, const auto& level, int) {
            if (level.face_count() > s.most)
                throw mesh_error("more faces than " + std::to_string(s.most));
        }};
    }
};
struct each_corner_cut {
    static constexpr auto columns()
    {
        return kith::columns(new_vertices(per_end),
                             new_edges(per_edge, per_corner),
                             new_faces(per_face.of_degree([](const auto& f) { return 2 * f.degree(); }),
                                       per_vertex.of_degree([](const auto& v) { return v.face_count(); })));
    }
};
struct each_corner_cut_of_closed : each_corner_cut {
    static constexpr auto traits() { return scheme_traits{.closed_only = true}; }
};
struct centroids {
    static constexpr auto columns()
    {
        return kith::columns(
            new_vertices(per_vertex, per_face), new_edges(per_edge, per_corner), new_faces(triangles(per_side)));
    }
};
struct forgets_edges {
    static constexpr auto columns()
    {
        return kith::columns(new_vertices(per_vertex, per_face), new_edges(per_edge), new_faces(triangles(per_side)));
    }
};
struct by_generation {
    static constexpr auto columns(int generation)
    {
        const auto even = [even = generation % 2 == 0](const auto&) { return even; };
        return kith::columns(new_vertices(per_vertex.on_boundary(even)), new_faces(triangles(per_face)));
    }
};

} // namespace

TEST(scheme, is_what_has_columns)
{
    EXPECT_TRUE(kith::scheme<nameless>);
    EXPECT_TRUE(kith::scheme<by_generation>);
    EXPECT_FALSE(kith::scheme<int>);
}

TEST(scheme, may_have_a_name)
{
    EXPECT_EQ(scheme_name<triangles_by_name>(), "by-name");
    EXPECT_EQ(scheme_name<nameless>(), "scheme");
}

TEST(scheme, may_count_its_next_level)
{
    EXPECT_TRUE(countable_scheme<centroids>);
    EXPECT_FALSE(countable_scheme<nameless>);        // tuples without a column may make vertices
    EXPECT_FALSE(countable_scheme<by_generation>);   // the counts do not tell how many boundary vertices are even
    EXPECT_FALSE(countable_scheme<each_corner_cut>); // the counts do not tell the corners at the boundary
    EXPECT_TRUE(countable_scheme<each_corner_cut_of_closed>);
}

TEST(scheme, counts_of_the_next_level_follow_from_the_columns)
{
    const counts house{.vertices = 7, .edges = 11, .faces = 5, .boundary_edges = 2};
    EXPECT_EQ(next_counts(centroids(), house, 0),
              (counts{.vertices = 12, .edges = 31, .faces = 20, .boundary_edges = 2, .triangles = 20}));
    EXPECT_EQ(next_counts(forgets_edges(), house, 0),
              (counts{.vertices = 12, .edges = 11, .faces = 20, .triangles = 20}));
    const counts cube{.vertices = 8, .edges = 12, .faces = 6};
    EXPECT_EQ(next_counts(each_corner_cut_of_closed(), cube, 0), (counts{.vertices = 24, .edges = 36, .faces = 14}));
}

TEST(scheme, refuses_the_faces_it_does_not_take)
{
    const auto mesh = native(shapes::house());
    const level_type level(mesh);
    EXPECT_EQ(error_text<mesh_error>([&] { require_input(triangles_by_name(), level); }),
              "by-name: face 5 has 4 vertices; triangulate the mesh first");
    EXPECT_NO_THROW(require_input(nameless(), level));
}

TEST(scheme, refuses_what_its_options_do_not_take)
{
    const auto mesh = native(shapes::cube());
    const level_type level(mesh);
    for_few_faces scheme;
    scheme.most = 5;
    EXPECT_EQ(error_text<mesh_error>([&] { require_input(scheme, level); }), "more faces than 5");
    scheme.most = 6;
    EXPECT_NO_THROW(require_input(scheme, level));
}

TEST(scheme, refuses_the_boundary_it_does_not_take)
{
    const auto open = native(shapes::grid());
    EXPECT_EQ(
        error_text<mesh_error>([&] { require_input(closed(), level_type(open)); }),
        "scheme: edge 0 between vertices 0 and 1 is a boundary edge; close the mesh first, or take a scheme with a "
        "boundary rule");
    const auto house = native(shapes::house());
    EXPECT_NO_THROW(require_input(closed(), level_type(house)));
}

TEST(scheme, columns_may_depend_on_the_generation)
{
    const auto mesh = native(shapes::polygon(3));
    const level_type level(mesh);
    const by_generation s;
    using ids = numbering<decltype(columns_of(s, 0)), std::uint32_t>;
    EXPECT_EQ(ids(level, columns_of(s, 4)).vertices.total(), 3U);
    EXPECT_EQ(ids(level, columns_of(s, 5)).vertices.total(), 0U);
}
