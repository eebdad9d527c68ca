// SPDX-License-Identifier: BSD-3-Clause
#include <kith/hierarchy.hpp>
#include <kith/linear.hpp>

#include "support/error_text.hpp"
#include "support/every_scheme.hpp"
#include "support/same_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

using kith::element_kind;
using kith::hierarchy;

namespace {

using handles = kith::mesh_traits<mesh3d>;

/// The linear split without declared edges, so that these are found by matching.
struct matched_linear {
    static constexpr auto traits() { return kith::scheme_traits{.name = "matched-linear"}; }
    static constexpr auto columns()
    {
        return kith::columns(kith::new_vertices(kith::per_vertex, kith::per_edge, kith::per_face),
                             kith::new_faces(quads(kith::per_corner)));
    }
    template <class R>
    void operator()(const R& r) const
    {
        using namespace kith::targets;
        const auto& [coarse, assoc, generation] = r;
        for_each(coarse.vertices(), [&](auto v) { assoc(v, V) = v; });
        for_each(coarse.edges(), [&](auto e) { assoc(e, V) = average(e.org(), e.dst()); });
        for_each(coarse.faces(), [&](auto f) { assoc(f, V) = average(f.vertices()); });
        for_each(coarse.corners(), [&](auto c) {
            assoc(c, F) = polygon(assoc(c.v(), V), assoc(c.next_edge(), V), assoc(c.f(), V), assoc(c.prev_edge(), V));
        });
    }
};

/// A scheme of triangles around the middle of each face, with edges that are matched. The middle has no column. It is
/// kept under the face if this is a triangle, otherwise under two vertices of the face that do not touch.
struct matched_fans {
    static constexpr auto traits() { return kith::scheme_traits{.name = "matched-fans"}; }
    static constexpr auto columns()
    {
        return kith::columns(kith::new_vertices(kith::per_vertex), kith::new_faces(triangles(kith::per_corner)));
    }
    template <class R>
    void operator()(const R& r) const
    {
        using namespace kith::targets;
        const auto& [coarse, assoc, generation] = r;
        for_each(coarse.vertices(), [&](auto v) { assoc(v, V) = v; });
        for (auto f : coarse.faces()) {
            const auto c = f.first_corner();
            if (f.degree() > 3)
                assoc(c.v(), c.next().next().v(), V) = average(f.vertices());
            else
                assoc(f, V) = average(f.vertices());
            for (const auto at : f.corners()) {
                const auto a = at.v(), b = at.next().v();
                assoc(at, F) = f.degree() > 3 ? polygon(assoc(a, V), assoc(b, V), assoc(c.v(), c.next().next().v(), V))
                                              : polygon(assoc(a, V), assoc(b, V), assoc(f, V));
            }
        }
    }
};

/// Expects that the descendants of all elements of a level are all elements of a finer level, each once. Each must have
/// its element as ancestor.
template <class Levels>
void expect_family_trees(const Levels& levels, int coarser, int finer)
{
    const auto& level = levels.elements(coarser);
    const auto& fine = levels.elements(finer);
    std::vector<int> vertices(fine.vertex_count()), edges(fine.edge_count()), faces(fine.face_count());
    const auto look = [&](const auto& x) {
        const auto found = levels.descendants(coarser, x, finer);
        const auto count = [&](const auto& all, std::vector<int>& met) {
            for (const auto& y : all) {
                ++met[fine.index(y)];
                const auto up = levels.ancestor(finer, y, coarser);
                const auto is_x = [&](const auto& z) {
                    if constexpr (std::equality_comparable_with<decltype(*z), decltype(x)>)
                        return z and * z == x;
                    else
                        return false;
                };
                ASSERT_EQ(int(up.v.has_value()) + int(up.e.has_value()) + int(up.f.has_value()), 1);
                ASSERT_TRUE(is_x(up.v) or is_x(up.e) or is_x(up.f));
            }
        };
        count(found.vertices(), vertices);
        count(found.edges(), edges);
        count(found.faces(), faces);
    };
    for (std::size_t i = 0; i < level.vertex_count(); ++i)
        look(level.vertex_at(i));
    for (std::size_t i = 0; i < level.edge_count(); ++i)
        look(level.edge_at(i));
    for (std::size_t i = 0; i < level.face_count(); ++i)
        look(level.face_at(i));
    EXPECT_EQ(vertices, std::vector<int>(vertices.size(), 1));
    EXPECT_EQ(edges, std::vector<int>(edges.size(), 1));
    EXPECT_EQ(faces, std::vector<int>(faces.size(), 1));
}

} // namespace

TEST(lineage, each_element_has_one_ancestor_and_is_one_of_its_descendants)
{
    for_each_of_all_schemes_and_shape([](const auto& scheme, const mesh3d& mesh) {
        hierarchy levels(mesh, scheme);
        levels.refine(2);
        expect_family_trees(levels, 0, 2);
        expect_family_trees(levels, 1, 1);
    });
}

TEST(lineage, up_from_level_5_and_down_again_comes_back)
{
    for_each_of_all_schemes_and_shape([]<class Scheme>(const Scheme& scheme, const mesh3d& mesh) {
        if (mesh.face_count() > 12)
            return;
        hierarchy levels(mesh, scheme);
        levels.refine(5);
        std::mt19937 random(5);
        const auto some = [&](const auto& all) { return all[random() % all.size()]; };
        const auto expect_back = [&](const auto& x, const auto& of_kind) {
            const int coarser = int(random() % 5);
            const auto up = levels.ancestor(5, x, coarser);
            const auto down = up.v   ? levels.descendants(coarser, *up.v, 5)
                              : up.e ? levels.descendants(coarser, *up.e, 5)
                                     : levels.descendants(coarser, *up.f, 5);
            EXPECT_EQ(std::ranges::count(of_kind(down), x), 1);
        };
        for (int i = 0; i < 20; ++i) {
            const auto& last = levels.elements(5);
            expect_back(some(last.vertices()).handle(), [](const auto& down) { return down.vertices(); });
            expect_back(some(last.edges()).handle(), [](const auto& down) { return down.edges(); });
            expect_back(some(last.faces()).handle(), [](const auto& down) { return down.faces(); });
        }
    });
}

TEST(lineage, of_the_linear_scheme_is_where_the_points_lie)
{
    // A triangle, a quad and a pentagon in the plane, none of which overlap: a face lies in its ancestor.
    const auto mesh = kith::make_mesh(
        std::vector<shapes::point>{
            {0, 0, 0}, {2, 0, 0}, {4, 0, 0}, {4, 2, 0}, {3, 3, 0}, {2, 2, 0}, {0, 2, 0}, {-1, 1, 0}},
        std::vector<std::vector<std::size_t>>{{0, 1, 5, 6}, {1, 2, 3, 4, 5}, {0, 6, 7}});
    hierarchy levels(mesh, kith::linear());
    levels.refine(3);
    const auto is_left_of = [&](const auto& p, std::size_t a, std::size_t b) {
        const auto &s = mesh.point(a), &t = mesh.point(b);
        return (t[0] - s[0]) * (p[1] - s[1]) - (t[1] - s[1]) * (p[0] - s[0]) > 0;
    };
    std::size_t faces = 0;
    for (std::size_t root = 0; root < 3; ++root)
        for (const auto f : levels.descendants(0, handles::face{std::uint32_t(root)}, 3).faces()) {
            shapes::point middle{};
            for (const auto v : levels[3].face(f.value))
                for (int x = 0; x < 3; ++x)
                    middle[x] += levels[3].point(v)[x] / 4;
            const auto corners = mesh.face(root);
            for (std::size_t c = 0; c < corners.size(); ++c)
                EXPECT_TRUE(is_left_of(middle, corners[c], corners[(c + 1) % corners.size()]))
                    << root << " " << f.value;
            ++faces;
        }
    EXPECT_EQ(faces, 12U * 16);
    // The edges along the two edges that the quad shares with others.
    const auto shared = edge_between(levels.elements(0), 1, 5);
    const auto along = levels.descendants(0, shared, 3).edges();
    EXPECT_EQ(along.size(), 8U);
    for (const auto e : along)
        EXPECT_EQ(levels.elements(3).edges()[e.value].org().point()[0], 2);
}

TEST(lineage, of_edges_that_were_matched_is_what_the_split_would_say)
{
    for (const auto& [name, shape] : shapes::shapes_without_valence_two()) {
        SCOPED_TRACE(name);
        const auto mesh = native(shape);
        hierarchy declared(mesh, kith::linear());
        hierarchy matched(mesh, matched_linear());
        declared.refine(1);
        matched.refine(2);
        ASSERT_EQ(faces_of(matched[1]), faces_of(declared[1]));
        const auto& fine = declared.elements(1);
        for (const auto e : fine.edges()) {
            const auto same = edge_between(matched.elements(1), e.org().index(), e.dst().index());
            const auto a = declared.ancestor(1, e.handle(), 0), b = matched.ancestor(1, same, 0);
            ASSERT_EQ(a.kind, b.kind);
            ASSERT_EQ(a.f, b.f);
            const auto ends = [](const auto& levels, const auto& x) {
                const auto of = levels.elements(0).edges()[x.value];
                return std::minmax(of.org().index(), of.dst().index());
            };
            if (a.e) {
                ASSERT_EQ(ends(declared, *a.e), ends(matched, *b.e));
            }
            const auto born = matched.origin(1, same);
            EXPECT_EQ(born.e, b.e);
            EXPECT_EQ(born.f, b.f);
        }
        expect_family_trees(matched, 0, 2);
    }
}

TEST(lineage, of_vertices_of_the_dictionary_leads_up_and_down_over_all_levels)
{
    const auto house = native(shapes::shaken(shapes::open_house())); // of triangles and quads
    hierarchy levels(house, matched_fans());
    levels.refine(3);
    for (const int finer : {1, 2, 3})
        for (int coarser = 0; coarser <= finer; ++coarser)
            expect_family_trees(levels, coarser, finer);
    for (std::size_t f = 0; f < house.face_count(); ++f) {
        const auto middle = handles::vertex{std::uint32_t(house.vertex_count() + f)};
        EXPECT_EQ(levels.ancestor(1, middle, 0).f, handles::face{std::uint32_t(f)});
        // On later levels all faces are triangles, so the middle has no vertex more, but an edge to each of the new
        // ones.
        const auto down = levels.descendants(0, handles::face{std::uint32_t(f)}, 3);
        const std::size_t n = house.face(f).size();
        EXPECT_EQ(down.vertices().size(), 1 + n + 3 * n);
        EXPECT_EQ(down.faces().size(), 9 * n);
    }
    levels.keep_last(1);
    levels.refine(1);
    levels.restore(1);
    levels.restore(2);
    levels.restore(3);
    expect_family_trees(levels, 0, 4);
}

TEST(lineage, of_tuples_that_do_not_touch_is_what_lies_between_or_the_first)
{
    const auto cube = native(shapes::cube());
    hierarchy levels(cube, kith::linear());
    const auto& level = levels.elements(0);
    using enum element_kind;
    const auto expect = [&](const kith::tuple_elements& tuple, element_kind kind, std::size_t number) {
        EXPECT_EQ(kith::parent_of_listed(level, tuple), (kith::numbered_element{kind, number}));
    };
    for (std::size_t f = 0; f < 6; ++f) {
        const auto corners = cube.face(f);
        expect({{'v', corners[0]}, {'v', corners[2]}}, face, f);
        expect({{'f', f}, {'v', corners[1]}}, face, f);
        expect({{'f', f}}, face, f);
        for (std::size_t g = f + 1; g < 6; ++g) { // faces across from each other have no vertex in common
            std::size_t shared = 8;
            for (const auto v : cube.face(f))
                if (std::ranges::count(cube.face(g), v) == 1)
                    shared = std::min<std::size_t>(shared, v);
            expect({{'f', f}, {'f', g}}, shared == 8 ? face : vertex, shared == 8 ? f : shared);
        }
    }
    for (std::size_t v = 0; v < 8; ++v)
        for (std::size_t w = v + 1; w < 8; ++w) {
            int differ = 0;
            for (int x = 0; x < 3; ++x)
                differ += cube.point(v)[x] != cube.point(w)[x] ? 1 : 0;
            if (differ == 3)
                expect({{'v', v}, {'v', w}}, vertex, v);
        }
    expect({{'e', 4}, {'v', 7}}, edge, 4);
    expect({{'e', 4}, {'f', 5}, {'v', 7}}, face, 5);
    expect({{'e', 4}}, edge, 4);
    expect({{'v', 6}}, vertex, 6);
}

TEST(lineage, refuses_what_has_no_ancestor_there)
{
    hierarchy levels(native(shapes::cube()), kith::catmull_clark());
    levels.refine(2);
    EXPECT_EQ(error_text<kith::mesh_error>([&] { static_cast<void>(levels.ancestor(1, handles::face{0}, 2)); }),
              "level 1 was given as the finer, level 2 as the coarser one; give them the other way round");
    EXPECT_THROW(static_cast<void>(levels.ancestor(3, handles::face{0}, 0)), kith::mesh_error);
    EXPECT_THROW(static_cast<void>(levels.ancestor(2, handles::face{96}, 0)), kith::mesh_error);
    EXPECT_THROW(static_cast<void>(levels.descendants(0, handles::face{6}, 1)), kith::mesh_error);
    EXPECT_THROW(static_cast<void>(levels.descendants(1, handles::face{0}, 0)), kith::mesh_error);
}

TEST(moved_points, give_the_bits_of_refining_the_moved_mesh)
{
    for_each_of_all_schemes_and_shape([](const auto& scheme, const mesh3d& mesh) {
        hierarchy levels(mesh, scheme);
        levels.refine(2);
        auto moved = mesh;
        for (auto& p : moved.points())
            p = {p[1] - .25 * p[0], 1.5 * p[2], p[0] + .125};
        levels.move_points(0, std::as_const(moved).points());
        EXPECT_TRUE(same_bits(levels[0], moved));
        EXPECT_TRUE(same_bits(levels[2], kith::refine(moved, scheme, 2)));
    });
}

TEST(moved_points, of_a_level_leave_the_coarser_ones)
{
    const auto mesh = native(shapes::cube());
    hierarchy levels(mesh, kith::catmull_clark());
    levels.refine(2);
    auto moved = levels[1];
    moved.points()[7][2] += .5;
    levels.move_points(1, std::as_const(moved).points());
    EXPECT_TRUE(same_bits(levels[0], mesh));
    EXPECT_TRUE(same_bits(levels[1], moved));
    EXPECT_TRUE(same_bits(levels[2], kith::refine(moved, kith::catmull_clark(), 1)));
    levels.refine();
    EXPECT_TRUE(same_bits(std::move(levels).finest(), kith::refine(moved, kith::catmull_clark(), 2)));
}

TEST(moved_points, are_refused_when_they_are_few_or_not_finite)
{
    const auto mesh = native(shapes::cube());
    hierarchy levels(mesh, kith::catmull_clark());
    levels.refine(1);
    std::vector<shapes::point> points(mesh.points().begin(), mesh.points().end());
    points[3][1] = std::numeric_limits<double>::infinity();
    EXPECT_EQ(error_text<kith::mesh_error>([&] { levels.move_points(0, points); }),
              "level 0: the new point of vertex 3 is not finite; give all vertices finite coordinates");
    points.pop_back();
    points[3][1] = 0;
    EXPECT_EQ(error_text<kith::mesh_error>([&] { levels.move_points(0, points); }),
              "level 0 has 8 vertices, 7 values were given; give one per vertex");
    EXPECT_TRUE(same_bits(levels[0], mesh));
}
