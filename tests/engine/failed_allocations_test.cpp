// SPDX-License-Identifier: BSD-3-Clause
// Lets every allocation of the library fail, alone and with all later ones. Functions then throw std::bad_alloc and
// leave everything as it was.
#include "support/failing_allocations.hpp"

#include "support/native_shape.hpp"
#include "support/same_mesh.hpp"
#include "support/shapes.hpp"

#include <kith/convert.hpp>
#include <kith/evaluator.hpp>
#include <kith/hierarchy.hpp>
#include <kith/limits/limit_evaluator.hpp>
#include <kith/plan.hpp>
#include <kith/refine.hpp>
#include <kith/refine_with_fields.hpp>
#include <kith/schemes.hpp>
#include <kith/selected.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

namespace {

using point = std::array<double, 3>;
namespace fails = failing_allocations;

/// Catmull-Clark without equality: its templates are not kept for other calls, so that each call makes them.
struct forgetful : kith::catmull_clark {
    friend bool operator==(const forgetful&, const forgetful&) = delete;
};

/// Lets every allocation of run() fail. Expects is_done() if run() does not throw, and is_as_before() if it does.
template <class Prepare, class Run, class IsDone, class IsAsBefore>
void expect_all_or_nothing(const Prepare& prepare, const Run& run, const IsDone& is_done,
                           const IsAsBefore& is_as_before)
{
    long failed = 0;
    fails::try_all(prepare, run, [&](const fails::trial& trial) {
        SCOPED_TRACE(trial.text());
        ASSERT_EQ(trial.other, "");
        failed += trial.has_failed;
        if (trial.has_thrown)
            ASSERT_TRUE(is_as_before());
        else
            ASSERT_TRUE(is_done());
    });
    EXPECT_GT(failed, 3);
}

/// Lets every allocation of a function fail that changes nothing. Expects an equal value or an error each time.
template <class Function, class Same>
void expect_value_or_error(const Function& function, const Same& same)
{
    const auto right = function();
    std::optional<std::remove_const_t<decltype(right)>> made;
    expect_all_or_nothing([&] { made.reset(); },
                          [&] { made.emplace(function()); },
                          [&] { return same(*made, right); },
                          [&] { return not made.has_value(); });
}

constexpr auto same_meshes = [](const auto& a, const auto& b) { return bool(same_bits(a, b)); };
constexpr auto same_values = [](const auto& a, const auto& b) { return std::ranges::equal(a, b); };

const mesh3d house = native(shapes::shaken(shapes::open_house()));

/// The state of a hierarchy: the levels that it holds and can undo.
template <class Levels>
struct levels_as_they_are {
    int depth, undone;
    std::vector<bool> held;
    std::vector<mesh3d> meshes;
    std::vector<std::size_t> vertices_of_edge_0;

    explicit levels_as_they_are(const Levels& levels) : depth(levels.depth()), undone(levels.undone())
    {
        for (int level = 0; level <= depth; ++level) {
            held.push_back(levels.holds(level));
            if (held.back())
                meshes.push_back(levels[level]);
            if (level > 0 and held[std::size_t(level)] and held[std::size_t(level) - 1])
                vertices_of_edge_0.push_back(
                    levels.assoc(level - 1, typename kith::mesh_traits<mesh3d>::edge{0}, kith::targets::V).value);
        }
    }
    friend bool operator==(const levels_as_they_are& a, const levels_as_they_are& b)
    {
        return a.depth == b.depth and a.undone == b.undone and a.held == b.held and
               a.vertices_of_edge_0 == b.vertices_of_edge_0 and std::ranges::equal(a.meshes, b.meshes, same_meshes);
    }
};

/// Lets every allocation of change(levels) fail, with new levels from make() each time. After an error the levels are
/// as before and can still be changed.
template <class Make, class Change>
void expect_levels_or_error(const Make& make, const Change& change)
{
    using levels_type = typename std::invoke_result_t<Make>::element_type;
    auto levels = make();
    const levels_as_they_are before(*levels);
    change(*levels);
    const levels_as_they_are after(*levels);
    ASSERT_FALSE(before == after);
    expect_all_or_nothing([&] { levels = make(); },
                          [&] { change(*levels); },
                          [&] { return levels_as_they_are<levels_type>(*levels) == after; },
                          [&] {
                              if (not(levels_as_they_are<levels_type>(*levels) == before))
                                  return false;
                              change(*levels);
                              return levels_as_they_are<levels_type>(*levels) == after;
                          });
}

auto make_levels(int depth)
{
    auto levels = std::make_unique<kith::hierarchy<mesh3d, kith::catmull_clark>>(house);
    levels->refine(depth);
    return levels;
}
using selected_loop = kith::selected<kith::loop>;
auto make_selected()
{
    auto levels = std::make_unique<kith::hierarchy<mesh3d, selected_loop>>(
        native(shapes::shaken(shapes::tetrahedron())), selected_loop());
    levels->refine_faces(std::array{kith::mesh_traits<mesh3d>::face{0}});
    levels->refine();
    levels->undo();
    return levels;
}

} // namespace

TEST(failed_allocations, make_mesh)
{
    const auto shape = shapes::open_house();
    expect_value_or_error([&] { return kith::make_mesh(shape.points, shape.faces); }, same_meshes);
}

TEST(failed_allocations, refine)
{
    expect_value_or_error([] { return kith::refine(house, kith::catmull_clark{}, 2); }, same_meshes);
    expect_value_or_error([] { return kith::refine(house, kith::doo_sabin{}, 2); }, same_meshes);
    expect_value_or_error(
        [] {
            return kith::refine(house, kith::catmull_clark{}, 2, {.last_level = kith::connect::faces}).points().size();
        },
        std::equal_to());
}

TEST(failed_allocations, refine_in_patches)
{
    const auto same_points = [](const mesh3d& a, const mesh3d& b) {
        return std::ranges::equal(a.points(), b.points());
    };
    const auto coarse = kith::refine(house, kith::catmull_clark{}, 2);
    const auto right = kith::refine(coarse, kith::catmull_clark{}, 4);
    std::optional<mesh3d> made;
    fails::try_all([&] { made.reset(); },
                   [&] { made = kith::refine(coarse, forgetful(), 4); },
                   [&](const fails::trial& trial) {
                       SCOPED_TRACE(trial.text());
                       ASSERT_EQ(trial.other, "");
                       ASSERT_NE(trial.has_thrown, made.has_value());
                       ASSERT_TRUE(not made or same_points(*made, right));
                   },
                   7);
}

TEST(failed_allocations, a_hierarchy_is_made)
{
    expect_value_or_error([] { return kith::hierarchy(house, kith::catmull_clark{}).elements(0).face_count(); },
                          std::equal_to());
}

TEST(failed_allocations, hierarchy_refine)
{
    expect_levels_or_error([] { return make_levels(1); }, [](auto& levels) { levels.refine(2); });
    const auto with_undone = [] {
        auto levels = make_levels(2);
        levels->undo();
        return levels;
    };
    expect_levels_or_error(with_undone, [](auto& levels) { levels.refine(2); });
    const auto keeping_one = [] {
        auto levels = make_levels(1);
        levels->keep_last(1);
        levels->refine();
        return levels;
    };
    expect_levels_or_error(keeping_one, [](auto& levels) { levels.refine(2); });
}

TEST(failed_allocations, restore)
{
    const auto dropped = [] {
        auto levels = make_levels(4);
        levels->keep_last(1);
        return levels;
    };
    expect_levels_or_error(dropped, [](auto& levels) { levels.restore(3); });
}

TEST(failed_allocations, undo_and_redo)
{
    const auto dropped = [] {
        auto levels = make_levels(4);
        levels->keep_last(1);
        return levels;
    };
    expect_levels_or_error(dropped, [](auto& levels) { levels.undo(); });
    const auto undone = [] {
        auto levels = make_levels(3);
        levels->undo(3);
        return levels;
    };
    expect_levels_or_error(undone, [](auto& levels) { levels.redo(3); });
}

TEST(failed_allocations, refine_if)
{
    expect_levels_or_error(make_selected, [](auto& levels) { levels.refine_if([](auto f) { return f.value < 3; }); });
    expect_levels_or_error(make_selected, [](auto& levels) { levels.refine(2); });
    expect_levels_or_error(make_selected, [](auto& levels) { levels.redo(); });
}

TEST(failed_allocations, move_points)
{
    std::vector<point> points(house.points().begin(), house.points().end());
    points[3][1] += .5;
    expect_levels_or_error([] { return make_levels(2); }, [&](auto& levels) { levels.move_points(0, points); });
}

TEST(failed_allocations, carry_and_matrix)
{
    const auto levels = make_levels(2);
    std::vector<float> values(house.vertex_count());
    std::iota(values.begin(), values.end(), 1.f);
    expect_value_or_error([&] { return levels->carry(0, 2, values); }, same_values);
    std::vector<int> labels(house.face_count());
    std::iota(labels.begin(), labels.end(), 1);
    expect_value_or_error([&] { return levels->carry(0, 2, kith::on_faces(labels)); },
                          [](const auto& a, const auto& b) { return std::ranges::equal(a.values(), b.values()); });
    expect_value_or_error([&] { return levels->matrix(0, 2); },
                          [](const auto& a, const auto& b) { return a.weight == b.weight and a.column == b.column; });
    const kith::mesh_traits<mesh3d>::face face{1};
    expect_value_or_error([&] { return levels->descendants(0, face, 2).faces(); }, std::equal_to());
}

TEST(failed_allocations, refine_with_fields)
{
    std::vector<int> labels(house.face_count());
    std::iota(labels.begin(), labels.end(), 1);
    const auto before = kith::on_faces(labels);
    auto field = before, right = before;
    const auto fine = kith::refine_with_fields(house, kith::catmull_clark{}, 2, std::tie(right));
    std::optional<mesh3d> made;
    const auto is = [&](const auto& other) { return std::ranges::equal(field.values(), other.values()); };
    expect_all_or_nothing(
        [&] {
            made.reset();
            field = before;
        },
        [&] { made = kith::refine_with_fields(house, kith::catmull_clark{}, 2, std::tie(field)); },
        [&] { return same_meshes(*made, fine) and is(right); },
        [&] { return not made and is(before); });
}

TEST(failed_allocations, plan)
{
    const auto counts = count(house.topology());
    expect_value_or_error([&] { return kith::plan(counts, kith::catmull_clark{}, 12).back().bytes; }, std::equal_to());
}

TEST(failed_allocations, evaluators)
{
    const auto coarse = kith::refine(house, kith::catmull_clark{}, 1);
    std::vector<point> points(coarse.points().begin(), coarse.points().end());
    points[3][1] += .5;
    std::optional<kith::evaluator<point, std::uint32_t, kith::catmull_clark>> surface;
    const auto make = [&] { surface.emplace(coarse, kith::catmull_clark{}, 3); };
    const auto is_ready = [&] { return surface.has_value(); };
    expect_all_or_nothing([&] { surface.reset(); }, make, is_ready, [&] { return not surface; });
    make();
    expect_value_or_error([&] { return surface->evaluate(points); }, same_values);

    std::optional<kith::limit_evaluator<point, std::uint32_t, kith::catmull_clark>> limits;
    const auto make_limits = [&] { limits.emplace(coarse, kith::catmull_clark{}, 3); };
    expect_all_or_nothing(
        [&] { limits.reset(); }, make_limits, [&] { return limits.has_value(); }, [&] { return not limits; });
    make_limits();
    expect_value_or_error([&] { return limits->evaluate(points).positions; }, same_values);
}

TEST(failed_allocations, convert)
{
    using floats = kith::basic_mesh<std::array<float, 3>>;
    expect_value_or_error([] { return kith::convert<floats>(house).mesh; }, same_meshes);
}
