// SPDX-License-Identifier: BSD-3-Clause
#include <kith/hierarchy.hpp>

#include "support/error_text.hpp"
#include "support/every_scheme.hpp"
#include "support/same_mesh.hpp"
#include "support/under_sanitizers.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

using kith::hierarchy;
using kith::tuple_kind;
using namespace kith::targets;

namespace {

using handles = kith::mesh_traits<mesh3d>;

/// A house with two levels of Catmull-Clark. V, E, F = 11, 20, 11 on level 0 and 42, 80, 40 on level 1.
struct refined_house {
    mesh3d control = native(shapes::shaken(shapes::house()));
    hierarchy<mesh3d, kith::catmull_clark> levels{control};

    refined_house() { levels.refine(2); }
};

/// Catmull-Clark that throws when it makes level 3.
struct fails_at_level_3 : kith::catmull_clark {
    template <class R>
    void operator()(const R& r) const
    {
        if (r.generation == 2)
            throw std::runtime_error("level 3");
        kith::catmull_clark::operator()(r);
    }
};

} // namespace

TEST(hierarchy, level_0_is_the_control_mesh)
{
    const refined_house h;
    EXPECT_EQ(h.levels.depth(), 2);
    EXPECT_TRUE(same_bits(h.levels[0], h.control));
}

TEST(hierarchy, its_levels_are_those_of_refine)
{
    for_each_of_all_schemes_and_shape([](const auto& scheme, const mesh3d& mesh) {
        hierarchy levels(mesh, scheme);
        levels.refine();
        levels.refine();
        EXPECT_TRUE(same_bits(levels[1], kith::refine(mesh, scheme, 1)));
        EXPECT_TRUE(same_bits(levels.finest(), kith::refine(mesh, scheme, 2)));
    });
}

TEST(hierarchy, starts_from_a_mesh_of_faces_only)
{
    const auto faces = kith::refine(native(shapes::cube()), kith::catmull_clark(), 1, {kith::connect::faces});
    hierarchy levels(faces, kith::catmull_clark());
    levels.refine();
    EXPECT_EQ(levels[0].edge_count(), 48U);
    EXPECT_EQ(levels[1].generation(), 2);
}

TEST(hierarchy, goes_down_by_tuples)
{
    const refined_house h;
    const handles::vertex v{3};
    const handles::face f{7};
    EXPECT_EQ(h.levels.assoc(0, v, V).value, 3U);
    EXPECT_EQ(h.levels.assoc(0, handles::edge{4}, V).value, 11U + 4);
    EXPECT_EQ(h.levels.assoc(0, f, V).value, 11U + 20 + 7);
    const auto corner = h.levels.assoc(0, f, handles::vertex{h.levels[0].face(7)[0]}, F);
    EXPECT_EQ(corner.value, h.levels.elements(0).faces()[7].first_corner().index());
}

TEST(hierarchy, finds_the_edges_of_the_next_level)
{
    const refined_house h;
    const auto& coarse = h.levels.elements(0);
    const auto& fine = h.levels.elements(1);
    for (const auto e : coarse.edges()) {
        const auto half = fine.edges()[h.levels.assoc(0, e.org().handle(), e.handle(), E).value];
        const auto start = h.levels.assoc(0, e.org().handle(), V), middle = h.levels.assoc(0, e.handle(), V);
        EXPECT_TRUE((half.org().handle() == start and half.dst().handle() == middle) or
                    (half.dst().handle() == start and half.org().handle() == middle));
    }
}

TEST(hierarchy, finds_pairs_of_neighbours_by_their_edge)
{
    const refined_house h;
    const auto e = h.levels.elements(0).edges()[6];
    EXPECT_EQ(h.levels.assoc(0, e.dst().handle(), e.org().handle(), V), h.levels.assoc(0, e.handle(), V));
    EXPECT_EQ(h.levels.assoc(0, e.lface().handle(), e.rface().handle(), V), h.levels.assoc(0, e.handle(), V));
}

TEST(hierarchy, goes_up_by_origins)
{
    const refined_house h;
    const auto of_edge = h.levels.origin(1, handles::vertex{11 + 4});
    EXPECT_EQ(of_edge.kind, tuple_kind::e);
    EXPECT_EQ(of_edge.e, handles::edge{4});
    EXPECT_FALSE(of_edge.v or of_edge.f);
    const auto of_face = h.levels.origin(1, handles::face{0}); // the quad at the first corner of face 0
    EXPECT_EQ(of_face.kind, tuple_kind::vf);
    EXPECT_EQ(of_face.f, handles::face{0});
    EXPECT_EQ(of_face.v, handles::vertex{0});
}

TEST(hierarchy, up_and_down_again_is_the_same_element)
{
    const refined_house h;
    for (int level = 1; level <= 2; ++level) {
        const auto& fine = h.levels.elements(level);
        for (const auto e : fine.edges()) {
            const auto birth = h.levels.origin(level, e.handle());
            const auto again = birth.kind == tuple_kind::ve ? h.levels.assoc(level - 1, *birth.v, *birth.e, E)
                                                            : h.levels.assoc(level - 1, *birth.e, *birth.f, E);
            EXPECT_EQ(again, e.handle());
        }
        for (const auto f : fine.faces()) {
            const auto birth = h.levels.origin(level, f.handle());
            EXPECT_EQ(h.levels.assoc(level - 1, *birth.v, *birth.f, F), f.handle());
        }
    }
}

TEST(hierarchy, refuses_tuples_under_which_nothing_was_made)
{
    const refined_house h;
    const auto ask = [&](int level, const auto&... x) {
        return error_text<kith::association_error>([&] { static_cast<void>(h.levels.assoc(level, x..., V)); });
    };
    const std::string nothing = ": the scheme made no element from this tuple";
    EXPECT_EQ(ask(0, handles::vertex{0}, handles::vertex{9}), "level 0" + nothing); // not neighbours
    EXPECT_EQ(ask(0, handles::vertex{0}, handles::face{0}), "level 0" + nothing);   // no such column
    EXPECT_EQ(ask(2, handles::vertex{0}), "level 2 is the last, so its elements have no children yet; refine() first");
}

TEST(hierarchy, refuses_levels_that_are_not_there)
{
    const refined_house h;
    const auto fault = [](const auto& f) { return error_text<kith::mesh_error>(f); };
    const auto no_level = [](int level) {
        return "level " + std::to_string(level) +
               " does not exist, there are 0 to 2; ask for one of them, or refine() first";
    };
    const auto points = h.levels[1].points();
    for (const int level : {-1, 3, 1000}) {
        EXPECT_EQ(fault([&] { static_cast<void>(h.levels[level]); }), no_level(level));
        EXPECT_EQ(fault([&] { static_cast<void>(h.levels.scheme(level)); }), no_level(level));
        EXPECT_EQ(fault([&] { static_cast<void>(h.levels.elements(level)); }), no_level(level));
        EXPECT_EQ(fault([&] { static_cast<void>(h.levels.assoc(level, handles::face{0}, V)); }), no_level(level));
        EXPECT_EQ(fault([&] { static_cast<void>(h.levels.origin(level, handles::face{0})); }), no_level(level));
        EXPECT_EQ(fault([&] { static_cast<void>(h.levels.carry(1, level, points)); }), no_level(level));
        EXPECT_EQ(fault([&] { static_cast<void>(h.levels.carry(level, 2, points)); }), no_level(level));
        EXPECT_EQ(fault([&] { static_cast<void>(h.levels.matrix(0, level)); }), no_level(level));
        EXPECT_EQ(fault([&] { static_cast<void>(h.levels.matrix(level, 1)); }), no_level(level));
    }
    EXPECT_EQ(fault([&] { static_cast<void>(h.levels.carry(1, 0, points)); }),
              "values cannot be carried from level 1 to level 0; carry them to the same level or a finer one");
    EXPECT_EQ(fault([&] { static_cast<void>(h.levels.matrix(2, 1)); }).find("values cannot be carried"), 0U);
    for (const auto& why : {fault([&] { static_cast<void>(h.levels.origin(0, handles::vertex{0})); }),
                            fault([&] { static_cast<void>(h.levels.origin(0, handles::edge{0})); }),
                            fault([&] { static_cast<void>(h.levels.origin(0, handles::face{0})); })})
        EXPECT_EQ(
            why,
            "level 0 is the control mesh, whose elements come from no others; ask for the origin of those of level "
            "1 or more");
}

TEST(hierarchy, refuses_handles_of_no_element_of_a_level)
{
    const refined_house h; // 11 vertices, 20 edges and 11 faces; 42, 80 and 40
    const auto fault = [](const auto& f) { return error_text<kith::mesh_error>(f); };
    const auto none = [](const std::string& level, const std::string& kind, const std::string& number) {
        return "level " + level + " has no " + kind + " " + number +
               ", it was removed or is of another mesh; take handles from level " + level;
    };
    EXPECT_EQ(fault([&] { static_cast<void>(h.levels.assoc(0, handles::vertex{11}, V)); }), none("0", "vertex", "11"));
    EXPECT_EQ(fault([&] { static_cast<void>(h.levels.assoc(0, handles::edge{20}, V)); }), none("0", "edge", "20"));
    EXPECT_EQ(fault([&] { static_cast<void>(h.levels.assoc(1, handles::vertex{0}, handles::face{40}, F)); }),
              none("1", "face", "40"));
    EXPECT_EQ(fault([&] { static_cast<void>(h.levels.origin(1, handles::vertex{})); }),
              "level 1 has no vertex with this handle, which is invalid; take handles from level 1");
    EXPECT_EQ(fault([&] { static_cast<void>(h.levels.origin(1, handles::edge{80})); }), none("1", "edge", "80"));
    EXPECT_EQ(fault([&] { static_cast<void>(h.levels.origin(2, handles::face{4000})); }), none("2", "face", "4000"));
}

TEST(hierarchy, carries_values_as_the_points_are_carried)
{
    for_each_scheme_and_shape([](const auto& scheme, const mesh3d& mesh) {
        hierarchy levels(mesh, scheme);
        levels.refine(2);
        const auto carried = levels.carry(0, 2, mesh.points());
        EXPECT_TRUE(std::ranges::equal(
            std::span(carried.data(), carried.size()), levels[2].points(), same_points<shapes::point>));
    });
}

TEST(hierarchy, carries_from_any_level_to_any_finer_one)
{
    const refined_house h;
    const auto carried = h.levels.carry(1, 2, h.levels[1].points());
    EXPECT_TRUE(std::ranges::equal(std::span(carried.data(), carried.size()), h.levels[2].points()));
    EXPECT_EQ(h.levels.carry(1, 1, h.levels[1].points()).size(), 42U);
}

TEST(hierarchy, carries_any_array_of_values)
{
    refined_house h;
    std::vector<double> values(11);
    std::array<double, 11> same;
    for (std::size_t v = 0; v < values.size(); ++v)
        same[v] = values[v] = double(v * v);
    const auto right = h.levels.carry(0, 2, std::span<const double>(values));
    EXPECT_TRUE(std::ranges::equal(h.levels.carry(0, 2, values), right));
    EXPECT_TRUE(std::ranges::equal(h.levels.carry(0, 2, same), right));
    EXPECT_TRUE(std::ranges::equal(h.levels.carry(0, 2, std::span(values)), right));
    EXPECT_TRUE(std::ranges::equal(h.levels.carry(1, 2, h.levels.carry(0, 1, values)), right));
}

TEST(hierarchy, refuses_the_wrong_number_of_values)
{
    const refined_house h;
    const std::vector<double> few(10);
    EXPECT_EQ(error_text<kith::mesh_error>([&] { static_cast<void>(h.levels.carry(0, 1, std::span(few))); }),
              "level 0 has 11 vertices, 10 values were given; give one per vertex");
}

TEST(hierarchy, refuses_a_field_of_another_level_even_where_it_would_carry_it_nowhere)
{
    const refined_house h;
    const auto few = kith::on_vertices(std::vector<double>(10), kith::by_mask());
    for (const int to : {0, 1})
        EXPECT_EQ(error_text<kith::mesh_error>([&] { static_cast<void>(h.levels.carry(0, to, few)); }),
                  "a field has 10 values, the level has 11 vertices; give it one for each");
}

TEST(hierarchy, refuses_more_levels_than_there_are_numbers_for)
{
    hierarchy levels(native(shapes::cube()), kith::catmull_clark());
    levels.refine(1);
    EXPECT_THROW(levels.refine(std::numeric_limits<int>::max()), kith::mesh_error);
    EXPECT_EQ(levels.depth(), 1);
}

TEST(hierarchy, is_what_it_was_when_a_step_fails)
{
    hierarchy levels(native(shapes::cube()), fails_at_level_3());
    levels.refine(2);
    levels.undo();
    EXPECT_THROW(levels.refine(3), std::runtime_error);
    EXPECT_EQ(levels.depth(), 1);
    EXPECT_EQ(levels.undone(), 1);
    EXPECT_TRUE(same_bits(levels[1], kith::refine(native(shapes::cube()), kith::catmull_clark(), 1)));
    levels.redo();
    EXPECT_TRUE(same_bits(levels[2], kith::refine(native(shapes::cube()), kith::catmull_clark(), 2)));
}

TEST(hierarchy, refuses_what_refine_refuses)
{
    hierarchy levels(native(shapes::cube()), kith::catmull_clark(), {.memory_limit = 100'000});
    EXPECT_THROW(levels.refine(-1), kith::mesh_error);
    EXPECT_THROW(levels.refine(8), kith::mesh_error);
    EXPECT_EQ(levels.depth(), 0);
    EXPECT_THROW(hierarchy(native(shapes::cube()), kith::loop()), kith::mesh_error);
    EXPECT_THROW(hierarchy(mesh3d(), kith::catmull_clark()), kith::mesh_error);
}

namespace {

/// Returns a digit for each level: 1 if it is in memory, 0 if not, such as "1001".
template <class Levels>
std::string held(const Levels& levels)
{
    std::string result;
    for (int level = 0; level <= levels.depth(); ++level)
        result += levels.holds(level) ? '1' : '0';
    return result;
}

} // namespace

TEST(hierarchy, keeps_the_last_levels_and_restores_others)
{
    for_each_of_all_schemes_and_shape([](const auto& scheme, const mesh3d& mesh) {
        if (under_sanitizers and mesh.face_count() > 8)
            return;
        hierarchy levels(mesh, scheme);
        levels.keep_last(1);
        levels.refine(3);
        EXPECT_EQ(held(levels), "1001");
        EXPECT_TRUE(same_bits(levels.finest(), kith::refine(mesh, scheme, 3)));
        levels.restore(2);
        EXPECT_EQ(held(levels), "1011");
        EXPECT_TRUE(same_bits(levels[2], kith::refine(mesh, scheme, 2)));
        levels.refine();
        EXPECT_EQ(held(levels), "10001");
        levels.restore(1);
        EXPECT_EQ(held(levels), "11001");
        EXPECT_TRUE(same_bits(levels[1], kith::refine(mesh, scheme, 1)));
        EXPECT_TRUE(same_bits(levels[4], kith::refine(mesh, scheme, 4)));
    });
}

TEST(hierarchy, drops_levels_that_are_there_when_it_is_told)
{
    refined_house h;
    h.levels.refine();
    h.levels.keep_last(2);
    EXPECT_EQ(held(h.levels), "1011");
    EXPECT_EQ(error_text<kith::mesh_error>([&] { h.levels.keep_last(0); }),
              "0 levels cannot be kept; keep at least the last one");
}

TEST(hierarchy, restored_levels_know_their_relations)
{
    refined_house all, some;
    all.levels.refine();
    some.levels.keep_last(1);
    some.levels.refine();
    some.levels.restore(2);
    some.levels.restore(1);
    for (const auto f : all.levels.elements(3).faces()) {
        EXPECT_EQ(some.levels.ancestor(3, f.handle(), 0).f, all.levels.ancestor(3, f.handle(), 0).f);
        EXPECT_EQ(some.levels.origin(3, f.handle()).v, all.levels.origin(3, f.handle()).v);
    }
    for (const auto e : all.levels.elements(1).edges())
        EXPECT_EQ(some.levels.assoc(1, e.handle(), V), all.levels.assoc(1, e.handle(), V));
}

TEST(hierarchy, keeps_the_state_of_dropped_levels)
{
    kith::catmull_clark creased;
    creased.sharpness.sharpen_edge(4, 2.5);
    const auto mesh = native(shapes::house());
    hierarchy all(mesh, creased), some(mesh, creased);
    some.keep_last(1);
    for (auto* levels : {&all, &some})
        levels->refine(4);
    some.restore(3);
    EXPECT_TRUE(same_bits(some[3], all[3]));
    for (int level = 0; level <= 4; ++level)
        for (const auto e : all.elements(level).edges())
            EXPECT_EQ(some.scheme(level).sharpness.of_edge(e.index()), all.scheme(level).sharpness.of_edge(e.index()));
}

TEST(hierarchy, says_which_level_was_dropped)
{
    refined_house h;
    h.levels.keep_last(1);
    const std::string expected = "level 1 was dropped, as only the last 1 are kept; restore(1) makes it again";
    EXPECT_EQ(error_text<kith::mesh_error>([&] { static_cast<void>(h.levels[1]); }), expected);
    EXPECT_EQ(error_text<kith::mesh_error>([&] { static_cast<void>(h.levels.matrix(0, 2)); }), expected);
    EXPECT_EQ(error_text<kith::mesh_error>([&] { static_cast<void>(h.levels.ancestor(2, handles::face{0}, 0)); }),
              expected);
    const std::vector<std::array<double, 3>> zero(h.control.vertex_count());
    EXPECT_EQ(error_text<kith::mesh_error>([&] { h.levels.move_points(0, zero); }), expected);
    EXPECT_TRUE(same_bits(h.levels[0], h.control)) << "nothing was moved";
    EXPECT_EQ(error_text<kith::mesh_error>([&] { h.levels.restore(3); }),
              "level 3 does not exist, there are 0 to 2; ask for one of them, or refine() first");
}

TEST(hierarchy, does_not_drop_what_no_rule_makes_again)
{
    refined_house h;
    std::vector<std::array<double, 3>> points(h.levels[1].points().begin(), h.levels[1].points().end());
    points[7][2] += 3;
    h.levels.move_points(1, points);
    h.levels.keep_last(1);
    EXPECT_EQ(held(h.levels), "111");
    h.levels.refine();
    EXPECT_EQ(held(h.levels), "1101");
    EXPECT_EQ(h.levels[1].point(7)[2], points[7][2]);
    h.levels.restore(2);
    EXPECT_TRUE(same_bits(h.levels[3], kith::refine(h.levels[2], kith::catmull_clark(), 1)));
    EXPECT_TRUE(same_bits(h.levels[2], kith::refine(h.levels[1], kith::catmull_clark(), 1)));

    h.levels.move_points(0, std::vector<std::array<double, 3>>(h.control.points().begin(), h.control.points().end()));
    h.levels.refine(); // level 1 follows level 0 again
    EXPECT_EQ(held(h.levels), "10001");
}

TEST(hierarchy, needs_less_memory_where_it_keeps_fewer_levels)
{
    const auto mesh = native(shapes::cube());
    const auto planned = kith::plan(count(mesh.topology()), kith::catmull_clark(), 4);
    const auto need = kith::peak_bytes_keeping_last(planned, 1);
    EXPECT_EQ(need, planned[0].bytes + planned[3].bytes + planned[4].bytes);
    EXPECT_EQ(kith::peak_bytes_keeping_last(planned, 2), need + planned[2].bytes);
    EXPECT_EQ(kith::peak_bytes_keeping_last(planned, 9), kith::peak_bytes(planned, true));
    // If refinement begins at level 2, this level stays until the end, so that the hierarchy can return to it.
    EXPECT_EQ(kith::peak_bytes_keeping_last(planned, 1, 2), need + planned[2].bytes);
    EXPECT_EQ(kith::peak_bytes_keeping_last(planned, 1, 3), need);
    hierarchy levels(mesh, kith::catmull_clark(), {.memory_limit = need});
    EXPECT_THROW(levels.refine(4), kith::mesh_error);
    levels.keep_last(1);
    levels.refine(4);
    EXPECT_EQ(levels.finest().face_count(), 6U * 256);
}

TEST(hierarchy, tells_how_much_is_done)
{
    hierarchy levels(native(shapes::cube()), kith::catmull_clark());
    std::vector<double> told;
    EXPECT_TRUE(levels.refine(3, [&](double done) {
        told.push_back(done);
        return true;
    }));
    EXPECT_EQ(told, (std::vector{24. / (24 + 96 + 384), (24. + 96) / (24 + 96 + 384), 1.}));
    EXPECT_TRUE(levels.refine(0, [](double) { return false; })) << "there is nothing to ask";
}

TEST(hierarchy, is_what_it_was_when_it_is_stopped)
{
    for (const int kept : {1, 2, 9}) {
        refined_house h;
        h.levels.keep_last(kept);
        h.levels.restore(1);
        const auto level_1 = h.levels[1], level_2 = h.levels[2];
        EXPECT_FALSE(h.levels.refine(3, [](double done) { return done < .2; }));
        EXPECT_EQ(held(h.levels), "111");
        EXPECT_TRUE(same_bits(h.levels[1], level_1));
        EXPECT_TRUE(same_bits(h.levels[2], level_2));
        EXPECT_TRUE(h.levels.refine(1, [](double) { return true; }));
        EXPECT_TRUE(same_bits(h.levels[3], kith::refine(h.control, kith::catmull_clark(), 3)));
    }
}

namespace {

/// A scheme of triangles around the middle of each face, which has no column. The middle of a quad is kept under two
/// opposite vertices, and the other two refer to it. The middle of any other face is kept under the face.
struct fans_about_diagonals {
    static constexpr auto traits() { return kith::scheme_traits{.name = "fans-about-diagonals"}; }
    static constexpr auto columns()
    {
        return kith::columns(kith::new_vertices(kith::per_vertex), kith::new_faces(triangles(kith::per_corner)));
    }
    template <class R>
    void operator()(const R& r) const
    {
        const auto& [coarse, assoc, generation] = r;
        for_each(coarse.vertices(), [&](auto v) { assoc(v, V) = v; });
        for (auto f : coarse.faces()) {
            const auto c = f.first_corner();
            if (f.degree() == 4) {
                assoc(c.v(), c.next().next().v(), V) = average(f.vertices());
                assoc(c.next().v(), c.prev().v(), V).refers_to(assoc(c.v(), c.next().next().v(), V));
            } else {
                assoc(f, V) = average(f.vertices());
            }
            for (const auto at : f.corners())
                assoc(at, F) = f.degree() == 4 ? polygon(assoc(at.v(), V),
                                                         assoc(at.next().v(), V),
                                                         assoc(c.v(), c.next().next().v(), V))
                                               : polygon(assoc(at.v(), V), assoc(at.next().v(), V), assoc(f, V));
        }
    }
};

/// Expects that the middles of the faces of levels 0 and 1 are found on the next level and have the right origins.
/// Precondition: level 0 is a mesh of quads.
template <class M>
void expect_middles(const hierarchy<M, fans_about_diagonals>& levels)
{
    for (int level = 0; level < 2; ++level) {
        const auto& coarse = levels.elements(level);
        const std::size_t first_middle = coarse.vertex_count();
        for (const auto f : coarse.faces()) {
            const auto c = f.first_corner();
            const auto v = c.v().handle(), opposite = c.next().next().v().handle();
            const auto middle = level == 0 ? levels.assoc(level, opposite, v, V) : levels.assoc(level, f.handle(), V);
            EXPECT_EQ(levels.elements(level + 1).index(middle), first_middle + f.index());
            const auto born = levels.origin(level + 1, middle);
            EXPECT_FALSE(born.kind.has_value());
            EXPECT_FALSE(born.e or born.other_f);
            if (level == 0) {
                EXPECT_EQ(levels.assoc(level, c.next().v().handle(), c.prev().v().handle(), V), middle);
                EXPECT_TRUE((born.v == v and born.other_v == opposite) or (born.v == opposite and born.other_v == v));
                EXPECT_FALSE(born.f);
            } else {
                EXPECT_EQ(born.f, f.handle());
                EXPECT_FALSE(born.v or born.other_v);
            }
        }
    }
}

} // namespace

TEST(hierarchy, answers_for_vertices_of_the_dictionary)
{
    hierarchy levels(native(shapes::cube()), fans_about_diagonals());
    levels.refine(2);
    expect_middles(levels);
    EXPECT_EQ(levels[1].point(levels.assoc(0, handles::vertex{6}, handles::vertex{1}, V).value),
              (shapes::point{1, 0, 0}));
    EXPECT_EQ(error_text<kith::association_error>(
                  [&] { static_cast<void>(levels.assoc(0, handles::vertex{0}, handles::vertex{6}, V)); }),
              "level 0: the scheme made no element from this tuple");
    EXPECT_THROW(static_cast<void>(levels.assoc(0, handles::face{0}, V)), kith::association_error);
    const auto moved = std::move(levels);
    expect_middles(moved);
}

TEST(hierarchy, answers_for_vertices_of_the_dictionary_after_levels_were_dropped_and_restored)
{
    hierarchy levels(native(shapes::cube()), fans_about_diagonals());
    levels.keep_last(1);
    levels.refine(3);
    levels.restore(1);
    levels.restore(2);
    expect_middles(levels);
    EXPECT_FALSE(levels.refine(1, [](double) { return false; }));
    expect_middles(levels);
}

TEST(hierarchy, carries_values_to_vertices_of_the_dictionary)
{
    hierarchy levels(native(shapes::cube()), fans_about_diagonals());
    levels.refine(1);
    const auto values = levels.carry(0, 1, kith::on_vertices(std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8}));
    for (const auto f : levels.elements(0).faces()) {
        const auto c = f.first_corner();
        const auto a = c.v().index(), b = c.next().next().v().index();
        EXPECT_EQ(values[8 + f.index()], (double(a + 1) + double(b + 1)) / 2);
    }
}

TEST(hierarchy, gives_vertices_of_the_dictionary_the_value_that_new_ones_are_born_with)
{
    hierarchy levels(native(shapes::cube()), fans_about_diagonals());
    levels.refine(1);
    const std::vector<int> marks{1, 2, 3, 4, 5, 6, 7, 8};
    const auto values = levels.carry(0, 1, kith::on_vertices(marks, kith::from_vertex<std::identity, int>{{}, 77}));
    const auto without = levels.carry(0, 1, kith::on_vertices(marks, kith::from_vertex{}));
    for (std::size_t v = 0; v < 14; ++v) {
        EXPECT_EQ(values[v], v < 8 ? marks[v] : 77);
        EXPECT_EQ(without[v], v < 8 ? marks[v] : 0);
    }
    const std::vector<std::string> names(8, "old");
    const auto words = levels.carry(
        0, 1, kith::on_vertices(names, kith::from_vertex<std::identity, const char*>{{}, "new"}));
    for (std::size_t v = 0; v < 14; ++v)
        EXPECT_EQ(words[v], v < 8 ? "old" : "new");
}

TEST(hierarchy, carries_values_to_corners_at_vertices_of_the_dictionary)
{
    hierarchy levels(native(shapes::house()), fans_about_diagonals()); // quads and others, with a seam at each edge
    levels.refine(1);
    const auto& coarse = levels.elements(0);
    kith::storage<double> at_corners(coarse.corner_count());
    for (std::size_t c = 0; c < at_corners.size(); ++c)
        at_corners[c] = double(c * c);
    const auto values = levels.carry(0, 1, kith::on_corners(at_corners));
    for (const auto f : coarse.faces()) {
        double sum = 0;
        for (const auto c : f.corners())
            if (f.degree() != 4 or c == f.first_corner() or c == f.first_corner().next().next())
                sum += at_corners[c.index()];
        const double middle = sum / (f.degree() == 4 ? 2. : double(f.degree()));
        for (const auto c : f.corners()) {
            const auto new_face = levels.elements(1).faces()[c.index()];
            const auto first = new_face.first_corner();
            EXPECT_EQ(values[first.index()], at_corners[c.index()]);
            EXPECT_EQ(values[first.next().index()], at_corners[c.next().index()]);
            EXPECT_NEAR(values[first.prev().index()], middle, 1e-12 * middle);
        }
    }
}
