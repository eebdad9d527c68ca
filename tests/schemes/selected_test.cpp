// SPDX-License-Identifier: BSD-3-Clause
#include <kith/butterfly.hpp>
#include <kith/catmull_clark.hpp>
#include <kith/hierarchy.hpp>
#include <kith/linear.hpp>
#include <kith/loop.hpp>
#include <kith/selected.hpp>

#include "support/consistent.hpp"
#include "support/error_text.hpp"
#include "support/native_shape.hpp"
#include "support/same_mesh.hpp"
#include "support/some_selections.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

using kith::hierarchy;
using kith::selected;

namespace {

using handles = kith::mesh_traits<mesh3d>;
using point = std::array<double, 3>;

/// A scheme with every association checked.
template <class S>
struct checked : S {
    explicit checked(const S& scheme) : S(scheme) {}
    static constexpr auto traits()
    {
        auto result = kith::traits_of<S>;
        result.trusted = false;
        return result;
    }
};

/// Calls test(scheme, mesh) for schemes of triangles and of polygons, on closed and open meshes.
template <class Test>
void for_each_scheme(const Test& test)
{
    for (const auto& shape : {shapes::house(), shapes::open_house(), shapes::grid(), shapes::umbrella(7)}) {
        const auto triangles = native(shapes::shaken(figures::triangulated(shape)));
        test(kith::loop(), triangles);
        const auto polygons = native(shapes::shaken(shape));
        test(kith::catmull_clark(), polygons);
    }
}

/// The red faces and the cut edges of a level without green faces, found by repeated loops over all faces.
struct closed_by_force {
    std::vector<bool> is_red, is_cut;
    std::size_t greens = 0;

    closed_by_force(const kith::level_of<mesh3d>& level, const std::vector<unsigned char>& chosen)
        : is_red(chosen.begin(), chosen.end()), is_cut(level.edge_count())
    {
        for (bool again = true; std::exchange(again, false);)
            for (const auto f : level.faces()) {
                std::size_t whole = 0;
                for (const auto e : f.edges())
                    whole += not is_cut[e.index()];
                if (not is_red[f.index()] and (whole > 1 or whole == f.degree()))
                    continue;
                is_red[f.index()] = true;
                for (const auto e : f.edges())
                    if (not is_cut[e.index()])
                        again = is_cut[e.index()] = true;
            }
        for (const auto f : level.faces())
            for (const auto e : f.edges())
                if (not is_red[f.index()] and is_cut[e.index()]) {
                    ++greens;
                    break;
                }
    }
    [[nodiscard]] std::size_t cuts() const { return std::size_t(std::ranges::count(is_cut, true)); }
};

point minus(const point& a, const point& b)
{
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
double dot(const point& a, const point& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
double angle_at(const point& a, const point& b, const point& c)
{
    const point x = minus(b, a), y = minus(c, a);
    return std::acos(std::clamp(dot(x, y) / std::sqrt(dot(x, x) * dot(y, y)), -1., 1.));
}
double smallest_angle(const point& a, const point& b, const point& c)
{
    return std::min({angle_at(a, b, c), angle_at(b, c, a), angle_at(c, a, b)});
}
point middle(const point& a, const point& b)
{
    return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
}

/// Expects that no vertex lies on an edge except at its ends, in flat meshes and others whose edges do not cross.
void expect_no_vertex_on_edges(const mesh3d& mesh)
{
    for (std::size_t e = 0; e < mesh.edge_count(); ++e) {
        const auto edge = kith::level_of<mesh3d>(mesh).edges()[e];
        const point a = edge.org().point(), b = edge.dst().point(), along = minus(b, a);
        for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
            if (v == edge.org().index() or v == edge.dst().index())
                continue;
            const point from = minus(mesh.point(std::uint32_t(v)), a);
            const double t = dot(from, along) / dot(along, along);
            const point across = {from[0] - t * along[0], from[1] - t * along[1], from[2] - t * along[2]};
            ASSERT_FALSE(0 < t and t < 1 and dot(across, across) < 1e-20 * dot(along, along)) << v << " on " << e;
        }
    }
}

/// Returns a flat grid of unit squares.
shapes::shape flat_grid()
{
    auto result = shapes::grid();
    for (auto& p : result.points)
        p[2] = 0;
    return result;
}

} // namespace

TEST(selected, all_faces_are_full_refinement)
{
    for_each_scheme([](const auto& scheme, const mesh3d& mesh) {
        hierarchy chosen(mesh, selected(scheme)), unsaid(mesh, selected(scheme));
        hierarchy full(mesh, scheme);
        for (int level = 1; level <= 3; ++level) {
            chosen.refine_if([](handles::face) { return true; });
            unsaid.refine();
            full.refine();
            EXPECT_TRUE(same_bits(chosen[level], full[level]));
            EXPECT_TRUE(same_bits(unsaid[level], full[level]));
        }
        EXPECT_TRUE(same_bits(kith::refine(mesh, selected(scheme), 2), full[2]));
    });
}

TEST(selected, all_faces_of_an_interpolating_scheme_are_full_refinement)
{
    const auto mesh = native(shapes::shaken(figures::triangulated(shapes::open_house())));
    hierarchy levels(mesh, selected(kith::butterfly()));
    levels.refine_flagged(std::vector<unsigned char>(mesh.face_count(), 1));
    EXPECT_TRUE(same_bits(levels[1], kith::refine(mesh, kith::butterfly(), 1)));
    refine_some(levels, 2, 1, 4);
    expect_consistent(levels.finest().topology());
}

TEST(selected, no_faces_are_a_copy)
{
    for_each_scheme([](const auto& scheme, const mesh3d& mesh) {
        hierarchy levels(mesh, selected(scheme));
        levels.refine_if([](handles::face) { return false; });
        EXPECT_TRUE(same_arrays(levels[1].topology(), mesh.topology()));
        EXPECT_TRUE(std::ranges::equal(levels[1].points(), mesh.points(), same_points<point>));
        EXPECT_EQ(*levels.origin(1, handles::face{2}).f, (handles::face{2}));
        EXPECT_EQ(*levels.origin(1, handles::edge{3}).e, (handles::edge{3}));
        EXPECT_EQ(*levels.origin(1, handles::vertex{1}).v, (handles::vertex{1}));
    });
}

TEST(selected, counts_are_those_of_red_and_green_faces)
{
    for (unsigned seed = 0; seed < 20; ++seed)
        for_each_scheme([&](const auto& scheme, const mesh3d& control) {
            const mesh3d mesh = kith::refine(control, scheme, 1);
            hierarchy levels(mesh, selected(scheme));
            std::mt19937 random(seed);
            const auto flags = some_faces(mesh.face_count(), random, 1 + seed % 6);
            levels.refine_flagged(flags);
            const closed_by_force closed(levels.elements(0), flags);
            const auto red = std::size_t(std::ranges::count(closed.is_red, true));
            const bool triangles = kith::needs_triangles<std::remove_cvref_t<decltype(scheme)>>;
            EXPECT_EQ(levels[1].vertex_count(), mesh.vertex_count() + closed.cuts() + (triangles ? 0 : red));
            EXPECT_EQ(levels[1].face_count(), mesh.face_count() + 3 * red + (triangles ? closed.greens : 0));
        });
}

TEST(selected, one_triangle_makes_its_neighbors_green)
{
    const auto mesh = kith::refine(native(figures::triangulated(shapes::cube())), kith::loop(), 1);
    hierarchy levels(mesh, selected(kith::loop()));
    levels.refine_faces(std::array{handles::face{5}});
    EXPECT_EQ(levels[1].face_count(), mesh.face_count() + 3 + 3);
    EXPECT_EQ(levels[1].vertex_count(), mesh.vertex_count() + 3);
    EXPECT_EQ(levels.descendants(0, handles::face{5}, 1).faces().size(), 4U);
}

TEST(selected, one_quad_makes_its_neighbors_pentagons)
{
    const auto mesh = kith::refine(native(shapes::cube()), kith::catmull_clark(), 1);
    hierarchy levels(mesh, selected(kith::catmull_clark()));
    levels.refine_faces(std::array{handles::face{5}});
    std::array<int, 8> degrees{};
    for (const auto f : levels.elements(1).faces())
        ++degrees[f.degree()];
    EXPECT_EQ(degrees, (std::array<int, 8>{0, 0, 0, 0, 23, 4, 0, 0}));
}

TEST(selected, levels_are_conforming)
{
    for (unsigned seed = 0; seed < 8; ++seed)
        for_each_scheme([&](const auto& scheme, const mesh3d& mesh) {
            hierarchy levels(mesh, selected(scheme));
            hierarchy looked_at(mesh, checked(selected(scheme)));
            refine_some(levels, 4, seed, 2 + seed);
            refine_some(looked_at, 4, seed, 2 + seed);
            for (int level = 1; level <= 4; ++level) {
                EXPECT_TRUE(same_bits(levels[level], looked_at[level]));
                expect_consistent(levels[level].topology());
                EXPECT_TRUE(kith::validate(levels[level]));
                EXPECT_EQ(levels.elements(level).is_closed(), levels.elements(0).is_closed());
            }
        });
}

TEST(selected, no_vertex_lies_on_an_edge)
{
    for (unsigned seed = 0; seed < 6; ++seed) {
        hierarchy triangles(native(figures::triangulated(flat_grid())), selected(kith::linear_triangles()));
        refine_some(triangles, 4, seed, 3);
        expect_no_vertex_on_edges(triangles.finest());
        hierarchy quads(native(flat_grid()), selected(kith::linear()));
        refine_some(quads, 4, seed, 3);
        expect_no_vertex_on_edges(quads.finest());
        hierarchy polygons(native(shapes::open_house()), selected(kith::linear()));
        refine_some(polygons, 3, seed, 2);
        expect_no_vertex_on_edges(polygons.finest());
    }
}

// Red triangles are those of full refinement, similar to those of the control mesh. Green triangles are their halves.
TEST(selected, angles_are_those_of_control_triangles_and_their_halves)
{
    const auto control = native(shapes::shaken(figures::triangulated(shapes::house())));
    double least = 4;
    for (std::size_t f = 0; f < control.face_count(); ++f) {
        const auto corners = control.face(f);
        for (std::size_t k = 0; k < 3; ++k) {
            const point a = control.point(corners[k]), b = control.point(corners[(k + 1) % 3]),
                        c = control.point(corners[(k + 2) % 3]);
            least = std::min({least, smallest_angle(a, middle(a, b), c), smallest_angle(middle(a, b), b, c)});
        }
    }
    hierarchy levels(control, selected(kith::linear_triangles()));
    for (int level = 1; level <= 8; ++level) {
        refine_some(levels, 1, unsigned(level), 1);
        double here = 4;
        for (std::size_t f = 0; f < levels.finest().face_count(); ++f) {
            const auto corners = levels.finest().face(f);
            here = std::min(here,
                            smallest_angle(levels.finest().point(corners[0]),
                                           levels.finest().point(corners[1]),
                                           levels.finest().point(corners[2])));
        }
        EXPECT_GE(here, least - 1e-9) << level;
    }
}

// The refined strip becomes narrower from level to level, so that green faces lie along all of it.
TEST(selected, angles_of_smooth_schemes_do_not_shrink_with_depth)
{
    const auto look = [](const auto& scheme) {
        const auto control = kith::refine(native(figures::triangulated(shapes::cube())), kith::loop(), 2);
        hierarchy levels(control, selected(scheme));
        for (int level = 1; level <= 5; ++level) {
            levels.refine_if([&](handles::face f) {
                return std::ranges::all_of(levels.finest().face(f.value), [&](std::uint32_t v) {
                    const point& p = levels.finest().point(v);
                    return p[2] > 0.2 and std::abs(p[0] - 0.1) < 0.9 * std::pow(0.6, level);
                });
            });
            double least = 4;
            for (const auto f : levels.elements(level).faces()) {
                const auto c = f.first_corner();
                least = std::min(least, smallest_angle(c.v().point(), c.next().v().point(), c.prev().v().point()));
            }
            EXPECT_GT(least * 180 / std::numbers::pi, 10) << level;
        }
    };
    look(kith::loop());
    look(kith::butterfly());
}

TEST(selected, quads_of_a_grid_stay_squares_and_have_no_more_than_one_vertex_on_a_side)
{
    hierarchy levels(native(flat_grid()), selected(kith::linear()));
    for (int level = 1; level <= 7; ++level) {
        refine_some(levels, 1, unsigned(level), 2);
        for (const auto f : levels.elements(level).faces()) {
            std::vector<double> sides; // each of a square: whole or two halves
            int corners = 0;
            for (const auto c : f.corners()) {
                const double angle = angle_at(c.v().point(), c.prev().v().point(), c.next().v().point());
                const bool is_on_side = angle > 3;
                corners += not is_on_side;
                EXPECT_NEAR(angle, is_on_side ? std::numbers::pi : std::numbers::pi / 2, 1e-9);
                const point side = minus(c.next().v().point(), c.v().point());
                sides.push_back(std::sqrt(dot(side, side)));
            }
            EXPECT_EQ(corners, 4);
            EXPECT_LE(f.degree(), 6U);
            EXPECT_LE(std::ranges::max(sides), 2 * std::ranges::min(sides) + 1e-12);
        }
    }
}

// Each level selects faces one ring further inside. The test follows these faces in full refinement, too.
TEST(selected, inside_the_chosen_faces_points_are_those_of_full_refinement)
{
    const auto look = [](const auto& scheme, const mesh3d& mesh) {
        using namespace kith::targets;
        hierarchy levels(mesh, selected(scheme));
        hierarchy full(mesh, scheme);
        std::vector<bool> is_right(mesh.face_count(), true); // faces whose points are those of full refinement
        std::vector<handles::face> same_face;                // the same faces in full refinement
        for (std::uint32_t f = 0; f < mesh.face_count(); ++f)
            same_face.push_back({f});
        std::size_t compared = 0;
        for (int level = 0; level < 3; ++level) {
            const auto& here = levels.elements(level);
            std::vector<unsigned char> flags(here.face_count(), 0);
            for (const auto f : here.faces()) {
                bool is_inside = level > 0 or f.index() < here.face_count() / 3;
                for (const auto v : f.vertices())
                    for (const auto g : v.faces())
                        is_inside = is_inside and is_right[g.index()];
                flags[f.index()] = is_inside;
            }
            levels.refine_flagged(flags);
            full.refine();
            const auto &fine = levels.elements(level + 1), &all = full.elements(level + 1);
            std::vector<bool> is_right_next(fine.face_count(), false);
            std::vector<handles::face> same_next(fine.face_count());
            for (const auto f : here.faces()) {
                if (flags[f.index()] == 0)
                    continue;
                const auto there = full.elements(level).faces()[same_face[f.index()].value];
                const auto children = levels.descendants(level, here.face_at(f.index()), level + 1).faces();
                const auto theirs = full.descendants(level, same_face[f.index()], level + 1).faces();
                ASSERT_EQ(children.size(), theirs.size());
                for (std::size_t i = 0; i < children.size(); ++i) { // in the order of their corners
                    is_right_next[children[i].value] = true;
                    same_next[children[i].value] = theirs[i];
                    auto c = fine.faces()[children[i].value].first_corner(),
                         d = all.faces()[theirs[i].value].first_corner();
                    for (std::size_t k = 0; k < c.f().degree(); ++k, c = c.next(), d = d.next()) {
                        EXPECT_TRUE(same_points(c.v().point(), d.v().point())) << level << ' ' << there.index();
                        ++compared;
                    }
                }
            }
            is_right = std::move(is_right_next);
            same_face = std::move(same_next);
        }
        EXPECT_GT(compared, 1000U);
    };
    const auto grid = shapes::shaken(shapes::grid(12, 12));
    look(kith::loop(), native(figures::triangulated(grid)));
    look(kith::catmull_clark(), native(grid));
    look(kith::loop(), kith::refine(native(shapes::shaken(figures::triangulated(shapes::house()))), kith::loop(), 2));
    look(kith::catmull_clark(), kith::refine(native(shapes::shaken(shapes::house())), kith::catmull_clark(), 2));
}

TEST(selected, an_edge_with_one_green_end_is_halved_by_a_scheme_of_wide_masks)
{
    hierarchy levels(native(shapes::shaken(figures::triangulated(shapes::grid(6, 6)))), selected(kith::butterfly()));
    levels.refine_faces(std::array{handles::face{30}});
    levels.refine(); // all faces; each green pair is split like the face before it
    const auto& level = levels.elements(1);
    std::vector<int> parts(levels[0].face_count(), 0);
    const auto parent = [&](const auto& f) { return levels.ancestor(1, f.handle(), 0).f->value; };
    for (const auto f : level.faces())
        ++parts[parent(f)];
    std::vector<bool> is_green(level.vertex_count(), false);
    for (const auto f : level.faces())
        for (const auto v : f.vertices())
            is_green[v.index()] = is_green[v.index()] or parts[parent(f)] == 2;
    int first_alone = 0, second_alone = 0, other_masks = 0;
    for (const auto e : level.edges()) {
        if (not e.is_boundary() and parent(e.lface()) == parent(e.rface()) and parts[parent(e.lface())] == 2)
            continue; // between a green pair: the edge is removed
        const point made = levels[2].point(levels.assoc(1, e.handle(), kith::targets::V).value);
        const bool is_halved = made == middle(e.org().point(), e.dst().point());
        const bool first = is_green[e.org().index()], second = is_green[e.dst().index()];
        EXPECT_TRUE(is_halved or not(first or second)) << "edge " << e.index();
        first_alone += first and not second;
        second_alone += second and not first;
        other_masks += not first and not second and not is_halved;
    }
    EXPECT_GT(first_alone, 0);
    EXPECT_GT(second_alone, 0);
    EXPECT_GT(other_masks, 0);
}

TEST(selected, part_of_a_green_pair_splits_the_face_that_it_was)
{
    const auto mesh = native(shapes::shaken(figures::triangulated(shapes::grid())));
    hierarchy levels(mesh, selected(kith::linear_triangles()));
    hierarchy full(mesh, kith::linear_triangles());
    levels.refine_faces(std::array{handles::face{9}});
    full.refine();
    for (std::uint32_t parent = 0; parent < mesh.face_count(); ++parent)
        for (const auto part : levels.descendants(0, handles::face{parent}, 1).faces()) {
            if (levels.descendants(0, handles::face{parent}, 1).faces().size() != 2)
                continue; // not green
            levels.refine_faces(std::array{part});
            std::vector<point> found, expected;
            for (const auto f : levels.descendants(0, handles::face{parent}, 2).faces())
                for (const auto v : levels.elements(2).faces()[f.value].vertices())
                    found.push_back(v.point());
            for (const auto f : full.descendants(0, handles::face{parent}, 1).faces())
                for (const auto v : full.elements(1).faces()[f.value].vertices())
                    expected.push_back(v.point());
            std::ranges::sort(found);
            std::ranges::sort(expected);
            EXPECT_EQ(found, expected);
            levels.undo();
        }
}

TEST(selected, a_green_polygon_splits_into_the_quads_of_the_face_that_it_was)
{
    const auto mesh = native(flat_grid());
    hierarchy levels(mesh, selected(kith::linear()));
    hierarchy full(mesh, kith::linear());
    levels.refine_faces(std::array{handles::face{5}});
    full.refine();
    const auto green = levels.descendants(0, handles::face{6}, 1).faces();
    ASSERT_EQ(green.size(), 1U);
    EXPECT_EQ(levels.elements(1).faces()[green[0].value].degree(), 5U);
    levels.refine_faces(green);
    std::vector<point> found, expected;
    for (const auto f : levels.descendants(0, handles::face{6}, 2).faces())
        for (const auto v : levels.elements(2).faces()[f.value].vertices())
            found.push_back(v.point());
    for (const auto f : full.descendants(0, handles::face{6}, 1).faces())
        for (const auto v : full.elements(1).faces()[f.value].vertices())
            expected.push_back(v.point());
    std::ranges::sort(found);
    std::ranges::sort(expected);
    EXPECT_EQ(found, expected);
}
