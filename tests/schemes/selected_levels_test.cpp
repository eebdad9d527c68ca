// SPDX-License-Identifier: BSD-3-Clause
#include <kith/catmull_clark.hpp>
#include <kith/fields/with_fields.hpp>
#include <kith/hierarchy.hpp>
#include <kith/linear.hpp>
#include <kith/loop.hpp>
#include <kith/selected.hpp>

#include "support/error_text.hpp"
#include "support/native_shape.hpp"
#include "support/same_mesh.hpp"
#include "support/some_selections.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <new>
#include <span>
#include <utility>
#include <vector>

// Tests of hierarchies, fields and creases on levels that are refined in selected faces.

using kith::hierarchy;
using kith::selected;

namespace {

using handles = kith::mesh_traits<mesh3d>;
using point = std::array<double, 3>;

mesh3d triangles()
{
    return native(shapes::shaken(figures::triangulated(shapes::open_house())));
}
mesh3d polygons()
{
    return native(shapes::shaken(shapes::open_house()));
}
hierarchy<mesh3d, selected<kith::loop>> some_levels(unsigned seed)
{
    hierarchy levels(triangles(), selected(kith::loop()));
    refine_some(levels, 4, seed, 5);
    return levels;
}

/// Expects that each element of a level is a descendant of its ancestor on a coarser level. The number of all
/// descendants must be the number of elements.
template <class Levels>
void expect_family(const Levels& levels, int coarser, int finer)
{
    std::size_t found = 0;
    const auto look = [&](const auto& x) {
        const auto up = levels.ancestor(finer, x, coarser);
        const auto down = up.v   ? levels.descendants(coarser, *up.v, finer)
                          : up.e ? levels.descendants(coarser, *up.e, finer)
                                 : levels.descendants(coarser, *up.f, finer);
        const auto& ranges = down.numbers();
        const std::size_t i = levels.elements(finer).index(x);
        const auto has = [&](const auto& list) {
            return std::ranges::any_of(list, [&](const auto& r) { return r.begin <= i and i < r.end; });
        };
        EXPECT_TRUE(has(ranges.vertices) or has(ranges.edges) or has(ranges.faces));
    };
    const auto& fine = levels.elements(finer);
    for (std::size_t i = 0; i < fine.vertex_count(); ++i)
        look(fine.vertex_at(i));
    for (std::size_t i = 0; i < fine.edge_count(); ++i)
        look(fine.edge_at(i));
    for (std::size_t i = 0; i < fine.face_count(); ++i)
        look(fine.face_at(i));
    const auto& coarse = levels.elements(coarser);
    const auto add = [&](const auto& x) {
        const auto down = levels.descendants(coarser, x, finer);
        found += down.vertices().size() + down.edges().size() + down.faces().size();
    };
    for (std::size_t i = 0; i < coarse.vertex_count(); ++i)
        add(coarse.vertex_at(i));
    for (std::size_t i = 0; i < coarse.edge_count(); ++i)
        add(coarse.edge_at(i));
    for (std::size_t i = 0; i < coarse.face_count(); ++i)
        add(coarse.face_at(i));
    EXPECT_EQ(found, fine.vertex_count() + fine.edge_count() + fine.face_count());
}

/// Returns the first two coordinates of all corners of a level.
template <class Level>
std::vector<std::array<double, 2>> coordinates_at_corners(const Level& level)
{
    std::vector<std::array<double, 2>> result;
    for (const auto c : level.corners())
        result.push_back({c.v().point()[0], c.v().point()[1]});
    return result;
}

/// A rule of fields that runs out of memory.
struct failing {
    static inline bool fails = false;

    template <class T, class Step>
    kith::storage<T> after(std::span<const T> values, const Step& step) const
    {
        if (fails)
            throw std::bad_alloc();
        return kith::from_parent<>().template after<T>(values, step);
    }
};

} // namespace

TEST(selected_levels, parents_answer)
{
    const auto levels = some_levels(3);
    for (int coarser = 0; coarser < 4; ++coarser)
        expect_family(levels, coarser, 4);
    hierarchy quads(polygons(), selected(kith::catmull_clark()));
    refine_some(quads, 3, 5, 4);
    expect_family(quads, 0, 3);
    expect_family(quads, 2, 3);
}

TEST(selected_levels, are_undone_and_redone)
{
    auto levels = some_levels(7);
    const auto before = some_levels(7);
    levels.undo(3);
    EXPECT_EQ(levels.depth(), 1);
    EXPECT_EQ(levels.undone(), 3);
    EXPECT_TRUE(same_bits(levels.finest(), before[1]));
    EXPECT_THROW(static_cast<void>(levels[2]), kith::mesh_error);
    levels.redo(2);
    EXPECT_TRUE(same_bits(levels.finest(), before[3]));
    levels.redo();
    for (int level = 0; level <= 4; ++level)
        EXPECT_TRUE(same_bits(levels[level], before[level]));
    EXPECT_EQ(error_text<kith::mesh_error>([&] { levels.redo(); }),
              "1 levels cannot be made again, there are 0; ask for 0 to 0");
    EXPECT_EQ(error_text<kith::mesh_error>([&] { levels.undo(5); }),
              "5 levels cannot be taken back, there are 4; ask for 0 to 4");
}

TEST(selected_levels, another_selection_gives_up_what_was_undone)
{
    auto levels = some_levels(7);
    levels.undo(4);
    levels.refine_if([](handles::face f) { return f.value == 0; });
    EXPECT_EQ(levels.undone(), 0);
    levels.undo();
    levels.refine(); // all faces, not those of the level that was undone
    EXPECT_TRUE(same_bits(levels.finest(), kith::refine(triangles(), kith::loop(), 1)));
    hierarchy straight(triangles(), selected(kith::loop()));
    straight.refine();
    EXPECT_TRUE(same_bits(levels.finest(), straight.finest()));
}

TEST(selected_levels, are_redone_after_another_step_has_failed)
{
    const auto mesh = polygons();
    const std::vector<int> numbers(mesh.face_count(), 7);
    hierarchy levels(mesh, kith::with_fields(selected(kith::catmull_clark()), kith::on_faces(numbers, failing())));
    std::vector<unsigned char> one(mesh.face_count(), 0);
    one[0] = 1;
    levels.refine_flagged(one);
    auto points = std::vector(levels[1].points().begin(), levels[1].points().end());
    points[0][2] += 1;
    levels.move_points(1, std::span<const point>(points)); // so that the level stays when it is undone
    const auto expected = levels.carry(0, 1, std::span<const double>(std::vector<double>(mesh.vertex_count(), 1)));
    levels.undo();
    failing::fails = true;
    EXPECT_THROW(levels.refine(), std::bad_alloc);
    failing::fails = false;
    ASSERT_EQ(levels.undone(), 1);
    levels.redo();
    const auto carried = levels.carry(0, 1, std::span<const double>(std::vector<double>(mesh.vertex_count(), 1)));
    EXPECT_EQ(carried.size(), levels[1].vertex_count());
    EXPECT_TRUE(std::ranges::equal(carried, expected));
}

TEST(selected_levels, are_dropped_and_restored)
{
    auto levels = some_levels(11);
    const auto all = some_levels(11);
    levels.keep_last(1);
    for (int level = 1; level < 4; ++level) {
        EXPECT_FALSE(levels.holds(level));
        levels.restore(level);
        EXPECT_TRUE(same_bits(levels[level], all[level]));
    }
    levels.keep_last(1);
    levels.undo(2);
    EXPECT_TRUE(same_bits(levels.finest(), all[2]));
}

TEST(selected_levels, points_that_are_moved_take_finer_levels_along)
{
    auto levels = some_levels(2);
    std::vector<point> points(levels[0].points().begin(), levels[0].points().end());
    for (auto& p : points)
        p[2] *= 2;
    levels.move_points(0, points);
    auto control = triangles();
    hierarchy straight(mesh3d(kith::storage<point>(points), kith::connectivity(control.topology()), 0),
                       selected(kith::loop()));
    refine_some(straight, 4, 2, 5);
    EXPECT_TRUE(same_bits(levels.finest(), straight.finest()));
}

TEST(selected_levels, the_matrix_makes_the_points)
{
    const auto levels = some_levels(4);
    const auto matrix = levels.matrix(0, 4);
    const auto made = levels.carry(0, 4, levels[0].points());
    ASSERT_EQ(matrix.rows(), levels.finest().vertex_count());
    for (std::size_t v = 0; v < made.size(); ++v)
        EXPECT_TRUE(same_points(made[v], levels.finest().point(std::uint32_t(v))));
}

TEST(selected_levels, bad_selections_are_refused_by_name)
{
    auto levels = some_levels(1);
    const auto before = levels.depth();
    EXPECT_EQ(error_text<kith::mesh_error>([&] { levels.refine_flagged(std::vector<unsigned char>(3, 1)); }),
              "a selection has 3 flags, the level has " + std::to_string(levels.finest().face_count()) +
                  " faces; give one flag per face");
    const auto text = error_text<kith::mesh_error>([&] { levels.refine_faces(std::array{handles::face{100000}}); });
    EXPECT_NE(text.find("level 4 has no face 100000"), std::string::npos) << text;
    EXPECT_EQ(levels.depth(), before);
    EXPECT_TRUE(same_bits(levels.finest(), some_levels(1).finest()));
}

TEST(selected_levels, faces_inherit_and_corners_are_linear)
{
    const auto look = [](const auto& scheme, const mesh3d& mesh) {
        std::vector<int> material;
        for (std::size_t f = 0; f < mesh.face_count(); ++f)
            material.push_back(int(f));
        hierarchy levels(mesh, selected(scheme));
        const auto uv = coordinates_at_corners(levels.elements(0));
        hierarchy carrying(mesh, kith::with_fields(selected(scheme), kith::on_faces(material), kith::on_corners(uv)));
        refine_some(levels, 4, 21, 4);
        refine_some(carrying, 4, 21, 4);
        EXPECT_TRUE(same_bits(levels.finest(), carrying.finest()));
        for (std::uint32_t f = 0; f < levels.finest().face_count(); ++f)
            EXPECT_EQ(carrying.scheme(4).template field<0>()[f], int(levels.ancestor(4, handles::face{f}, 0).f->value));
        const auto expected = coordinates_at_corners(levels.elements(4));
        for (std::size_t c = 0; c < expected.size(); ++c)
            for (int x = 0; x < 2; ++x)
                EXPECT_NEAR(carrying.scheme(4).template field<1>()[c][x], expected[c][x], 1e-12);
    };
    look(kith::linear_triangles(), triangles());
    look(kith::linear(), polygons());
}

// Values that differ from face to face show from which face of the control mesh each corner has its value.
TEST(selected_levels, corners_stay_on_their_side_of_seams)
{
    const auto look = [](const auto& scheme, const mesh3d& mesh) {
        hierarchy levels(mesh, selected(scheme));
        std::vector<double> island;
        for (const auto c : levels.elements(0).corners())
            island.push_back(double(c.f().index()));
        refine_some(levels, 4, 8, 4);
        const auto found = levels.carry(0, 4, kith::on_corners(island));
        for (const auto c : levels.elements(4).corners()) {
            const auto face = handles::face{std::uint32_t(c.f().index())};
            EXPECT_EQ(found[c.index()], double(levels.ancestor(4, face, 0).f->value));
        }
    };
    look(kith::loop(), triangles());
    look(kith::catmull_clark(), polygons());
}

TEST(selected_levels, tags_of_edges_and_creases_stay_on_them)
{
    const auto look = [](auto scheme, const mesh3d& mesh) {
        scheme.sharpness.sharpen_edge(2, kith::infinitely_sharp);
        std::vector<int> tag(mesh.edge_count(), 0);
        tag[2] = 7;
        hierarchy levels(mesh, selected(scheme));
        refine_some(levels, 4, 6, 5);
        const auto tags = levels.carry(0, 4, kith::on_edges(tag));
        const auto& sharp = levels.scheme(4).scheme().sharpness;
        std::size_t pieces = 0;
        for (const auto e : levels.elements(4).edges()) {
            EXPECT_EQ(tags[e.index()] == 7, sharp.of_edge(e.index()) == kith::infinitely_sharp);
            pieces += tags[e.index()] == 7;
        }
        EXPECT_GE(pieces, 2U);
        EXPECT_EQ(pieces, sharp.edges().size());
    };
    look(kith::loop(), triangles());
    look(kith::catmull_clark(), polygons());
}

TEST(selected_levels, what_is_kept_stays_as_sharp_as_it_was)
{
    kith::loop scheme;
    scheme.sharpness.sharpen_edge(2, 2.5);
    scheme.sharpness.sharpen_vertex(1, 1.5);
    hierarchy levels(triangles(), selected(scheme));
    levels.refine_if([](handles::face) { return false; });
    EXPECT_EQ(levels.scheme(1).scheme().sharpness.of_edge(2), 2.5);
    EXPECT_EQ(levels.scheme(1).scheme().sharpness.of_vertex(1), 1.5);
    levels.refine();
    EXPECT_EQ(levels.scheme(2).scheme().sharpness.of_vertex(1), 0.5);
    ASSERT_EQ(levels.scheme(2).scheme().sharpness.edges().size(), 2U);
    EXPECT_EQ(levels.scheme(2).scheme().sharpness.edges()[0].second, 1.5);
}

TEST(selected_levels, a_scheme_that_has_chosen_does_the_same_everywhere)
{
    const auto mesh = polygons();
    auto scheme = selected(kith::catmull_clark());
    std::vector<unsigned char> flags(mesh.face_count(), 0);
    flags[1] = 1;
    scheme.select(kith::level_of<mesh3d>(mesh), flags);
    hierarchy levels(mesh, scheme);
    levels.refine();
    hierarchy chosen_there(mesh, selected(kith::catmull_clark()));
    chosen_there.refine_flagged(flags);
    EXPECT_TRUE(same_bits(levels.finest(), chosen_there.finest()));
    EXPECT_TRUE(same_bits(kith::refine(mesh, scheme, 1), chosen_there.finest()));
    EXPECT_TRUE(same_bits(kith::refine(mesh, chosen_there.scheme(0), 1), chosen_there.finest()));
}
