// SPDX-License-Identifier: BSD-3-Clause
#include "support/archetypes.hpp"

#include "support/every_level.hpp"
#include "support/same_mesh.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/core/level/values.hpp>
#include <kith/doo_sabin.hpp>
#include <kith/hierarchy/selection.hpp>
#include <kith/loop.hpp>
#include <kith/numbering/step/step.hpp>
#include <kith/selected.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <map>
#include <span>
#include <vector>

namespace {

using own_level = kith::level_elements<archetypes::level>;

// Each archetype is a model of its concept.

static_assert(kith::weight_number<archetypes::weight>);
static_assert(kith::value_space<archetypes::space>);
static_assert(not kith::values_over<archetypes::space, own_level>);
static_assert(kith::values_of_step<archetypes::values, own_level>);
static_assert(kith::walkable_level<archetypes::level>);
static_assert(not kith::level<archetypes::level>);
static_assert(kith::level<own_level>);
static_assert(kith::level_sink<archetypes::sink>);
static_assert(kith::scheme<archetypes::scheme>);
static_assert(kith::selecting_scheme<archetypes::selecting_scheme, own_level>);
static_assert(not kith::selecting_scheme<archetypes::scheme, own_level>);

// So are the types of the library.

static_assert(kith::level<level_type>);
static_assert(kith::level<kith::level_elements<kith::native_level<shapes::point, std::uint64_t, 4>>>);
static_assert(kith::values_of_step<kith::point_values<level_type>, level_type>);
static_assert(kith::values_of_step<kith::attribute_values<kith::hash_value>, level_type>);
static_assert(kith::scheme<kith::catmull_clark>);
static_assert(kith::selecting_scheme<kith::selected<kith::catmull_clark>, level_type>);
static_assert(kith::selectable_scheme<kith::loop> and not kith::selectable_scheme<kith::doo_sabin>);
static_assert(not kith::level_sink<kith::connectivity<std::uint32_t>>);

// No archetype is a model any more if one member is removed.

#define WITHOUT(name, base, member)                                                                                    \
    struct name : base {                                                                                               \
        void member() const = delete;                                                                                  \
    };
WITHOUT(without_across, archetypes::level, across)
WITHOUT(without_first, archetypes::level, first)
WITHOUT(without_halfedge, archetypes::level, halfedge)
WITHOUT(without_corner_at, archetypes::level, corner_at)
WITHOUT(without_point, archetypes::level, point)
WITHOUT(without_is_closed, archetypes::level, is_closed)
WITHOUT(without_parallel, archetypes::level, parallel)
WITHOUT(without_scale, archetypes::space, scale)
WITHOUT(without_coarse, archetypes::values, coarse)
WITHOUT(without_fine, archetypes::values, fine)
WITHOUT(without_listed, archetypes::values, listed)
WITHOUT(without_points, archetypes::sink, points)
WITHOUT(without_set_start, archetypes::sink, set_start)
WITHOUT(without_finish, archetypes::sink, finish)
WITHOUT(without_columns, archetypes::scheme, columns)
#undef WITHOUT
struct with_text_points : archetypes::level {
    using point_type = const char*;
};
struct with_handles_that_differ : archetypes::level {
    struct edge_handle {};
};
struct with_text_weights : archetypes::space {
    using scalar = const char*;
};
struct scheme_that_stays : archetypes::scheme {
    scheme_that_stays(const scheme_that_stays&) = delete;
};

static_assert(not kith::walkable_level<without_across>);
static_assert(not kith::walkable_level<without_first>);
static_assert(not kith::walkable_level<without_halfedge>);
static_assert(not kith::walkable_level<without_corner_at>);
static_assert(not kith::walkable_level<without_point>);
static_assert(not kith::walkable_level<without_is_closed>);
static_assert(not kith::walkable_level<without_parallel>);
static_assert(not kith::walkable_level<with_text_points>);
static_assert(not kith::walkable_level<with_handles_that_differ>);
static_assert(not kith::value_space<without_scale>);
static_assert(not kith::value_space<with_text_weights>);
static_assert(kith::value_space<without_coarse> and not kith::values_over<without_coarse, own_level>);
static_assert(not kith::values_of_step<without_fine, own_level>);
static_assert(not kith::values_of_step<without_listed, own_level>);
static_assert(not kith::level_sink<without_points>);
static_assert(not kith::level_sink<without_set_start>);
static_assert(not kith::level_sink<without_finish>);
static_assert(not kith::scheme<without_columns>);
static_assert(not kith::scheme<scheme_that_stays>);

/// Returns the numbers of elements.
std::vector<std::size_t> numbers(const auto& range)
{
    std::vector<std::size_t> result;
    for (const auto& x : range)
        result.push_back(x.index());
    return result;
}

/// Calls test(own level, native level) for every shape.
void for_each_pair(const auto& test)
{
    for (const auto& [name, shape] : shapes::all_shapes()) {
        SCOPED_TRACE(name);
        const auto mesh = native(shape);
        test(own_level(mesh), level_type(mesh));
    }
}

/// Returns the mesh that one step makes.
template <class Level, class Scheme>
mesh3d refined(const Level& level, const Scheme& scheme)
{
    kith::numbering_of<Scheme, std::uint32_t> ids;
    return kith::refine_level<kith::connect::everything>(level, scheme, 0, ids);
}

/// Runs one step of a scheme over values, without connectivity.
template <class Level, class Scheme, class Values>
void run(const Level& level, const Scheme& scheme, Values& values)
{
    const kith::numbering_of<Scheme, std::uint32_t> ids(level, scheme.columns());
    kith::run_scheme<kith::connect::nothing, true>(level, scheme, 0, ids, scheme.columns(), values);
}

} // namespace

TEST(archetypes, elements_of_any_level_walk_alike)
{
    for_each_pair([](const own_level& own, const level_type& native) {
        for (const auto v : native.vertices()) {
            const auto w = own.vertices()[v.index()];
            EXPECT_EQ(numbers(w.neighbors()), numbers(v.neighbors()));
            EXPECT_EQ(numbers(w.edges()), numbers(v.edges()));
            EXPECT_EQ(numbers(w.opposites()), numbers(v.opposites()));
            EXPECT_EQ(w.valence(), v.valence());
            EXPECT_EQ(w.point(), v.point());
            if (v.is_boundary()) {
                ASSERT_TRUE(w.is_boundary());
                EXPECT_EQ(w.last_rim().index(), v.last_rim().index());
            }
        }
        for (const auto f : native.faces())
            EXPECT_EQ(numbers(own.faces()[f.index()].vertices()), numbers(f.vertices()));
        for (const auto e : native.edges()) {
            const auto d = own.edges()[e.index()];
            EXPECT_EQ(d.lcorner().index(), e.lcorner().index());
            ASSERT_EQ(d.is_boundary(), e.is_boundary());
            if (not e.is_boundary()) {
                EXPECT_EQ(d.rface().index(), e.rface().index());
            }
        }
    });
}

TEST(archetypes, tuples_of_any_level_have_the_same_numbers)
{
    for_each_pair([](const own_level& own, const level_type& native) {
        for (const auto c : native.corners()) {
            const auto d = own.corners()[c.index()];
            EXPECT_EQ(index_tuple(d.v(), d.f()).value, c.index());
            EXPECT_EQ(index_tuple(d.v(), d.f(), d.prev_edge()).value, index_tuple(c.v(), c.f(), c.prev_edge()).value);
            EXPECT_EQ(list_tuple(own, kith::tuple_kind::vfe, 2 * c.index()),
                      list_tuple(native, kith::tuple_kind::vfe, 2 * c.index()));
        }
    });
}

TEST(archetypes, a_step_from_any_level_makes_the_same_mesh)
{
    for_each_pair([](const own_level& own, const level_type& native) {
        const auto same = [&](const auto& scheme) {
            const mesh3d ours = refined(own, scheme), theirs = refined(native, scheme);
            EXPECT_EQ(std::vector(ours.points().begin(), ours.points().end()),
                      std::vector(theirs.points().begin(), theirs.points().end()));
            EXPECT_EQ(faces_of(ours), faces_of(theirs));
        };
        same(kith::catmull_clark());
        same(archetypes::scheme(0.25));
    });
}

TEST(archetypes, masks_over_any_value_space_have_the_same_operands)
{
    for_each_pair([](const own_level& own, const level_type& native) {
        const archetypes::scheme scheme(0.25);
        std::vector<kith::hash_value> names(native.vertex_count());
        for (std::size_t v = 0; v < names.size(); ++v)
            names[v] = archetypes::name_of(v);
        kith::attribute_values<kith::hash_value> theirs{std::span<const kith::hash_value>(names)};
        run(native, scheme, theirs);
        const auto all = theirs.take();
        archetypes::values ours;
        run(own, scheme, ours);
        EXPECT_EQ(made(ours), std::vector(all.begin(), all.end()));
    });
}

TEST(archetypes, any_sink_is_told_the_level_that_a_native_mesh_would_be)
{
    for_each_pair([](const own_level& own, const level_type& native) {
        const kith::catmull_clark scheme;
        const mesh3d expected = refined(native, scheme);
        const auto& t = expected.topology();
        const kith::numbering_of<kith::catmull_clark, std::uint32_t> ids(own, scheme.columns());
        archetypes::sink told(ids.vertices.total());
        kith::run_scheme_into(told, own, scheme, 6, ids);

        EXPECT_EQ(points_of(told), std::vector(expected.points().begin(), expected.points().end()));
        EXPECT_EQ(generation_of(told), 7);
        ASSERT_EQ(faces_of(told).size(), t.faces);
        for (const auto& [face, lines] : faces_of(told)) {
            ASSERT_EQ(lines.size(), t.first_corner(face + 1) - t.first_corner(face));
            for (std::size_t k = 0; k < lines.size(); ++k) {
                EXPECT_EQ(lines[k].first, t.corner_vertex[t.first_corner(face) + k]);
                EXPECT_EQ(lines[k].second, t.corner_halfedge[t.first_corner(face) + k]);
            }
        }
        ASSERT_EQ(starts_of(told).size(), t.vertices);
        for (const auto& [vertex, leaving] : starts_of(told)) {
            const auto c = t.halfedge_corner[leaving];
            ASSERT_NE(c, t.none);
            EXPECT_EQ(t.corner_vertex[c], vertex);
            if (expected.topology().corners() == 2 * t.edges()) { // at the boundary, fans start elsewhere
                EXPECT_EQ(c, t.vertex_corner[vertex]);
            }
        }
    });
}
