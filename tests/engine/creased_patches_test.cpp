// SPDX-License-Identifier: BSD-3-Clause
#include <kith/engine/refine_in_patches.hpp>

#include <kith/catmull_clark.hpp>
#include <kith/loop.hpp>
#include <kith/refine.hpp>

#include "support/all_shapes.hpp"
#include "support/error_text.hpp"
#include "support/native_shape.hpp"
#include "support/patch_templates.hpp"
#include "support/refined_by_levels.hpp"
#include "support/same_mesh.hpp"
#include "support/thread_count.hpp"
#include "support/under_sanitizers.hpp"
#include "support/written_level.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

using kith::connect;
using kith::crease_method;
using kith::infinitely_sharp;

template <class Scheme>
using patches_of = kith::patch_refinement<std::array<double, 3>, std::uint32_t, Scheme>;

template <class Scheme>
void expect_same_bits(const mesh3d& mesh, const Scheme& scheme, int levels, const std::string& what)
{
    SCOPED_TRACE(what);
    const patches_of<Scheme> patches(mesh, scheme, levels, connect::everything, all_templates);
    ASSERT_TRUE(patches.is_worth_looking());
    const auto expected = refined_by_levels(mesh, scheme, levels, connect::everything);
    EXPECT_TRUE(same_bits(made_by_patches(mesh, scheme, levels, connect::everything, all_templates), expected));
    EXPECT_TRUE(same_bits(made_by_patches(mesh, scheme, levels, connect::faces, all_templates),
                          refined_by_levels(mesh, scheme, levels, connect::faces)));
    EXPECT_TRUE(same_bits(written_by_patches(mesh, scheme, levels, all_templates), expected));
}

/// Returns creases in which every `each`-th edge, from edge 1 on, and vertex 5 are sharp.
kith::creases sharpened(const mesh3d& mesh, int each, double sharpness, crease_method method)
{
    kith::creases result(method);
    for (std::size_t e = 1; e < mesh.edge_count(); e += std::size_t(each))
        result.sharpen_edge(e, sharpness);
    result.sharpen_vertex(5, sharpness);
    return result;
}

template <class Scheme>
void expect_same_bits_with_creases(const mesh3d& mesh, Scheme scheme, int levels, const std::string& what)
{
    for (const crease_method method : {crease_method::uniform, crease_method::chaikin})
        for (const double sharpness : {.6, 1.7, infinitely_sharp})
            for (const int each : {7, 100000}) {
                if (under_sanitizers and (sharpness != 1.7 or each != 7))
                    continue;
                scheme.sharpness = sharpened(mesh, each, sharpness, method);
                expect_same_bits(mesh,
                                 scheme,
                                 levels,
                                 what + (method == crease_method::chaikin ? ", Chaikin, " : ", uniform, ") +
                                     std::to_string(sharpness) + ", each " + std::to_string(each));
            }
}

TEST(creased_patches, makes_the_bits_of_catmull_clark)
{
    const auto smoothed = kith::boundary_corner::smoothed;
    const auto torus = native(shapes::shaken(shapes::torus(9, 12)));
    expect_same_bits_with_creases(torus, kith::catmull_clark{}, 4, "torus");
    const auto shuffled = native(shapes::shaken(shapes::shuffled(shapes::torus(7, 9), 3)));
    expect_same_bits_with_creases(shuffled, kith::catmull_clark{}, 3, "shuffled torus");
    const auto polygons = native(shapes::shaken(shapes::both(shapes::house(), shapes::pentacube())));
    expect_same_bits_with_creases(polygons, kith::catmull_clark{}, 3, "polygons");
    const auto grid = native(shapes::shaken(shapes::shuffled(shapes::grid(7, 8), 5)));
    expect_same_bits_with_creases(grid, kith::catmull_clark{}, 3, "grid");
    expect_same_bits_with_creases(grid, kith::catmull_clark{.corners = smoothed, .sharpness = {}}, 3, "smoothed grid");
}

TEST(creased_patches, makes_the_bits_of_loop)
{
    const auto torus = native(shapes::shaken(shapes::triangulated(shapes::torus(9, 12))));
    expect_same_bits_with_creases(torus, kith::loop{}, 3, "torus");
    const auto grid = native(shapes::shaken(shapes::shuffled(shapes::triangulated(shapes::grid(7, 8)), 5)));
    expect_same_bits_with_creases(grid, kith::loop{.weights = kith::loop_weights::warren, .sharpness = {}}, 3, "grid");
}

TEST(creased_patches, hand_back_the_level_that_they_have_looked_at_where_they_are_no_gain)
{
    const auto mesh = native(shapes::shaken(shapes::torus(20, 30)));
    kith::catmull_clark scheme;
    scheme.sharpness = sharpened(mesh, 7, 2.5, crease_method::uniform);
    auto never = all_templates;
    never.to_be_cheaper = -1;
    ASSERT_TRUE(patches_of<kith::catmull_clark>(mesh, scheme, 4, connect::faces, never).is_worth_looking());
    auto of_level = scheme;
    kith::native_last_level<std::array<double, 3>, std::uint32_t> made(connect::faces);
    kith::refinement_run run(mesh, of_level, 4, never);
    EXPECT_FALSE(run.make_in_patches(made));
    EXPECT_EQ(run.mesh().generation(), 1);
    EXPECT_TRUE(same_bits(refined_by_levels(run.mesh(), of_level, 3), refined_by_levels(mesh, scheme, 4)));
    of_level = scheme;
    written_level<std::array<double, 3>, std::uint32_t> written;
    kith::written_last_level<std::array<double, 3>, std::uint32_t> last(written);
    kith::refinement_run run_of_writer(mesh, of_level, 4, never);
    EXPECT_FALSE(run_of_writer.make_in_patches(last));
    EXPECT_EQ(run_of_writer.mesh().generation(), 1);
}

TEST(creased_patches, makes_them_on_any_number_of_threads)
{
    const auto mesh = native(shapes::shaken(shapes::torus(20, 30)));
    kith::catmull_clark scheme;
    scheme.sharpness = sharpened(mesh, 7, 2.5, crease_method::uniform);
    for (const connect last : {connect::faces, connect::everything}) {
        const auto expected = refined_by_levels(mesh, scheme, 4, last);
        for (const int threads : under_sanitizers ? std::vector{3} : std::vector{1, 2, 3, 4, 7}) {
            const thread_count count(threads);
            EXPECT_TRUE(same_bits(made_by_patches(mesh, scheme, 4, last, some_templates), expected)) << threads;
        }
    }
}

TEST(creased_patches, are_what_refine_makes_of_a_mesh_with_few_creases)
{
    const auto mesh = native(shapes::shaken(shapes::torus(12, 24)));
    kith::catmull_clark scheme;
    scheme.sharpness.sharpen_edge(40, infinitely_sharp);
    scheme.sharpness.sharpen_vertex(80, 2.5);
    ASSERT_TRUE(patches_of<kith::catmull_clark>(mesh, scheme, 6, connect::faces).is_worth_looking());
    for (const connect last :
         under_sanitizers ? std::vector{connect::everything} : std::vector{connect::faces, connect::everything})
        EXPECT_TRUE(same_bits(refine(mesh, scheme, 6, {.last_level = last}), refined_by_levels(mesh, scheme, 6, last)));
}

TEST(creased_patches, refuses_creases_of_another_mesh)
{
    const auto error_of = [](const mesh3d& mesh, int levels) {
        kith::catmull_clark scheme;
        scheme.sharpness.sharpen_edge(mesh.edge_count(), 2.);
        return error_text<kith::mesh_error>([&] { refine(mesh, scheme, levels); });
    };
    EXPECT_EQ(error_of(native(shapes::torus(12, 24)), 6),
              "creases: edge 576 does not exist, there are 576; make the creases for this mesh and level");
    EXPECT_EQ(error_of(native(shapes::torus(60, 80)), 3), // its faces own patches
              "creases: edge 9600 does not exist, there are 9600; make the creases for this mesh and level");
}

/// A state: a number at some faces, which their children inherit halved. It pulls the face point towards the first
/// corner.
class pulls {
public:
    kith::sparse_values<double> of_faces;

    friend bool operator==(const pulls&, const pulls&) = default;
    template <kith::level Level, kith::level_numbering Numbering>
    [[nodiscard]] pulls after(const Level& coarse, const Numbering& ids) const
    {
        pulls result;
        for (const auto& [face, pull] : of_faces.list())
            for (const auto c : coarse.faces()[face].corners())
                result.of_faces.append(ids.faces.template id<kith::tuple_kind::vf>(c.index()), pull / 2);
        result.of_faces.sort();
        return result;
    }
    template <std::unsigned_integral Index>
    [[nodiscard]] pulls of_part(const kith::part_numbers<Index>& part) const
    {
        return {of_faces.of_part(part.faces)};
    }
};
/// The state pulls with for_each_place, which lists the faces that have a number.
struct placed_pulls : pulls {
    friend bool operator==(const placed_pulls&, const placed_pulls&) = default;
    template <kith::level Level, kith::level_numbering Numbering>
    [[nodiscard]] placed_pulls after(const Level& coarse, const Numbering& ids) const
    {
        return {pulls::after(coarse, ids)};
    }
    template <std::unsigned_integral Index>
    [[nodiscard]] placed_pulls of_part(const kith::part_numbers<Index>& part) const
    {
        return {pulls::of_part(part)};
    }
    template <class F>
    void for_each_place(const F& f) const
    {
        for (const auto& [face, pull] : of_faces.list())
            f(kith::tuple_kind::f, face, pull);
    }
};

template <class State>
struct pulled {
    double weight = .25;
    State state{};

    friend bool operator==(const pulled&, const pulled&) = default;
    static constexpr auto traits()
    {
        return kith::scheme_traits{.name = "pulled",
                                   .trusted = true,
                                   .reach = [](int rings) { return rings / 2 + 1; },
                                   .state = &pulled::state,
                                   .ignores_numbers = [](const pulled& s) { return s.state.of_faces.empty(); }};
    }
    static constexpr auto columns() { return kith::quad_split::columns(); }

    template <kith::step_context R>
    void operator()(const R& r) const
    {
        using namespace kith::targets;
        const auto& [coarse, assoc, generation] = r;
        for_each(coarse.faces(), [&](auto f) {
            const double t = state.of_faces[f.index()];
            assoc(f, V) = t * f.first_corner().v() + (1 - t) * average(f.vertices());
        });
        kith::subdivide(kith::quad_split(),
                        r,
                        kith::at_edges([&](auto e) { return weight * e.org() + (1 - weight) * e.dst(); }),
                        kith::at_vertices([&](auto v) {
                            return average(v.faces().map([&](const auto& f) { return assoc(f, V); }));
                        }));
    }
};

TEST(creased_patches, takes_a_users_own_state_that_says_where_it_is)
{
    static_assert(kith::scheme_of_places<pulled<placed_pulls>> and not kith::scheme_of_places<pulled<pulls>>);
    const auto mesh = native(shapes::shaken(shapes::torus(9, 12)));
    pulled<placed_pulls> scheme;
    expect_same_bits(mesh, scheme, 4, "empty");
    scheme.state.of_faces.set(7, .5);
    expect_same_bits(mesh, scheme, 4, "at a face");
    scheme.weight = .4; // distinguishes templates, whatever the state is
    expect_same_bits(mesh, scheme, 4, "with another option");
    scheme.state.of_faces.set(8, .5);
    expect_same_bits(mesh, scheme, 4, "at two faces");
}

TEST(creased_patches, refuses_such_a_state_of_another_mesh)
{
    const auto mesh = native(shapes::torus(60, 80)); // its faces own patches
    pulled<placed_pulls> scheme;
    scheme.state.of_faces.set(mesh.face_count(), .5);
    EXPECT_EQ(
        error_text<kith::mesh_error>([&] { (void)refine(mesh, scheme, 3); }),
        "the state of the scheme: face 4800 does not exist, there are 4800; make the state for this mesh and level");
}

TEST(creased_patches, leaves_out_a_state_that_does_not_say_where_it_is)
{
    const auto mesh = native(shapes::shaken(shapes::torus(12, 24)));
    pulled<pulls> scheme;
    expect_same_bits(mesh, scheme, 3, "empty");
    scheme.state.of_faces.set(7, .5);
    EXPECT_FALSE(patches_of<pulled<pulls>>(mesh, scheme, 6, connect::faces, all_templates).is_worth_looking());
    EXPECT_TRUE(same_bits(refine(mesh, scheme, 5), refined_by_levels(mesh, scheme, 5, connect::everything)));
}

TEST(creased_patches, shares_templates_with_the_scheme_without_creases)
{
    using templates = kith::kept_templates<double, std::uint32_t>;
    const auto mesh = native(shapes::shaken(shapes::torus(9, 12)));
    kith::catmull_clark creased;
    creased.sharpness = sharpened(mesh, 17, 2, crease_method::uniform);
    const auto made = templates::of(without_state(creased), 0, 2, 3).keep(u"around", {});
    EXPECT_EQ(templates::of(kith::catmull_clark{}, 0, 2, 3).find(u"around"), made);
    EXPECT_EQ(templates::of(kith::catmull_clark{.corners = kith::boundary_corner::smoothed, .sharpness = {}}, 0, 2, 3)
                  .find(u"around"),
              nullptr);
}

} // namespace
