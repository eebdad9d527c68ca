// SPDX-License-Identifier: BSD-3-Clause
#include "contests.hpp"

#include <kith/evaluator.hpp>
#include <kith/hierarchy.hpp>
#include <kith/limits/limit_surface.hpp>
#include <kith/make_creases.hpp>
#include <kith/refine_in_tiles.hpp>
#include <kith/refine_with_fields.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <thread>
#include <tuple>
#include <vector>

namespace kith::comparison {

namespace {

/// Adds a contest per control mesh for one scheme: the last level with all connectivity, and with face lists only.
template <class Scheme>
void add_scheme(std::vector<contest>& list, const Scheme& scheme, const course_settings& settings)
{
    for (auto [name, control, levels, faces] : courses(scheme, settings)) {
        list.push_back({std::string(scheme_name<Scheme>()),
                        name,
                        levels,
                        faces,
                        {native_contestant("kith, native", control, scheme, levels, connect::everything),
                         native_contestant("kith, native, faces only", control, scheme, levels, connect::faces)}});
    }
}

/// Writes the arrays of a Catmull-Clark result, points and corners, to fresh memory. No refinement can be faster than
/// this.
std::shared_ptr<const void> write_result(std::uint64_t faces)
{
    struct result {
        storage<std::array<double, 3>> points;
        storage<std::uint32_t> corners;
    };
    auto written = std::make_shared<result>(storage<std::array<double, 3>>(faces), storage<std::uint32_t>(4 * faces));
    std::ranges::fill(written->points, std::array{1., 2., 3.});
    std::ranges::fill(written->corners, 1U);
    return written;
}

void add_floor(std::vector<contest>& list, const course& course)
{
    const auto write = [faces = course.faces]() -> work { return [=] { return write_result(faces); }; };
    list.push_back({"catmull-clark",
                    course.name + ", against writing the result",
                    course.levels,
                    course.faces,
                    {{"writing to fresh memory", write, {}},
                     native_contestant(
                         "kith, native, faces only", course.control, catmull_clark{}, course.levels, connect::faces)}});
}

/// Adds a contest on a control mesh with some thousand edges, of which one in a hundred is infinitely sharp.
void add_creases(std::vector<contest>& list, const course& course)
{
    constexpr int before = 3;
    if (course.levels <= before)
        return;
    const auto control = std::make_shared<const basic_mesh<>>(refine(*course.control, catmull_clark{}, before));
    const catmull_clark creased{
        .sharpness = make_creases(*control, [](auto e) { return e.value % 100 == 0 ? infinitely_sharp : 0; })};
    const int levels = course.levels - before;
    list.push_back(
        {"catmull-clark",
         course.name + " after " + std::to_string(before) + " steps, creases",
         levels,
         course.faces,
         {native_contestant("kith, no creases", control, catmull_clark{}, levels, connect::everything),
          native_contestant("kith, 1 % of the edges are creases", control, creased, levels, connect::everything)}});
}

template <class Scheme>
void add_threads(std::vector<contest>& list, const Scheme& scheme, const course& course)
{
    const int threads = std::max(1, int(std::thread::hardware_concurrency()));
    contest one{std::string(scheme_name<Scheme>()), course.name + ", threads", course.levels, course.faces, {}};
    for (const connect last : {connect::everything, connect::faces})
        for (const int count : {1, threads}) {
            const std::string what = last == connect::faces ? ", faces only" : "";
            auto contestant = native_contestant(
                "kith" + what + ", " + std::to_string(count) + " threads", course.control, scheme, course.levels, last);
            contestant.threads = count;
            one.contestants.push_back(std::move(contestant));
        }
    list.push_back(std::move(one));
}

using levels_in_memory = hierarchy<basic_mesh<>, catmull_clark>;

/// Makes a contestant that refines all tiles one after the other. Its result is the total number of their faces.
contestant in_tiles(const course& course, std::size_t tiles)
{
    return caller("in " + std::to_string(tiles) + " tiles, faces only", [=] {
        tiled_refinement surface(
            *course.control, catmull_clark{}, course.levels, block_partition(*course.control, tiles));
        std::size_t faces = 0;
        for (std::size_t part = 0; part < tiles; ++part)
            faces += surface.refine(part).mesh.face_count();
        return faces;
    });
}

/// Compares hierarchies and fields with points and connectivity alone.
contest doors_with_values(const course& course)
{
    const auto control = course.control;
    const int levels = course.levels;
    const auto weights_of = [](const basic_mesh<>& mesh) {
        std::vector<double> result;
        for (const auto& p : mesh.points())
            result.push_back(p[0]);
        return result;
    };
    return {"catmull-clark",
            course.name + ", levels and values",
            levels,
            course.faces,
            {native_contestant("refine", control, catmull_clark{}, levels, connect::everything),
             caller("hierarchy, all levels",
                    [=] {
                        auto surface = std::make_unique<levels_in_memory>(*control, catmull_clark{});
                        surface->refine(levels);
                        return surface;
                    }),
             caller("hierarchy, a double carried from level 0",
                    [=] {
                        auto surface = std::make_unique<levels_in_memory>(*control, catmull_clark{});
                        surface->refine(levels);
                        auto weights = surface->carry(0, levels, weights_of(*control));
                        return std::pair(std::move(surface), std::move(weights));
                    }),
             caller("refine_with_fields, a double at vertices",
                    [=] {
                        auto weights = on_vertices(weights_of(*control), by_mask());
                        auto fine = refine_with_fields(*control, catmull_clark{}, levels, std::tie(weights));
                        return std::pair(std::move(fine), std::move(weights));
                    }),
             caller("refine_with_fields, a UV at corners, an int on faces", [=] {
                 std::vector<std::array<double, 2>> uvs(control->corner_count());
                 for (std::size_t c = 0; c < uvs.size(); ++c)
                     uvs[c] = {double(c % 5), double(c % 3)};
                 auto texture = on_corners(uvs);
                 auto labels = on_faces(std::vector<int>(control->face_count(), 3));
                 auto fine = refine_with_fields(*control, catmull_clark{}, levels, std::tie(texture, labels));
                 return std::tuple(std::move(fine), std::move(texture), std::move(labels));
             })}};
}

/// Compares tiles, evaluators and limits with face lists.
contest doors_of_faces(const course& course)
{
    const auto control = course.control;
    const int levels = course.levels;
    const auto evaluate = [=]() -> work {
        return [control,
                surface = std::make_shared<evaluator<std::array<double, 3>, std::uint32_t, catmull_clark>>(
                    *control, catmull_clark{}, levels)] {
            return std::make_shared<storage<std::array<double, 3>>>(surface->evaluate(control->points()));
        };
    };
    const auto to_the_limit = [=]() -> work {
        return [last = std::make_shared<basic_mesh<>>(refine(*control, catmull_clark{}, levels))] {
            return std::make_shared<limit_surface<std::array<double, 3>>>(limit_surface_of(*last, catmull_clark{}));
        };
    };
    return {"catmull-clark",
            course.name + ", faces only",
            levels,
            course.faces,
            {native_contestant("refine", control, catmull_clark{}, levels, connect::faces),
             in_tiles(course, 16),
             in_tiles(course, 64),
             {"evaluator, points again", evaluate, {}},
             {"limit_surface_of the last level", to_the_limit, {}}}};
}

} // namespace

std::vector<contest> kith_doors(const course_settings& settings)
{
    std::vector<contest> result;
    for (const auto& course : courses(catmull_clark{}, settings)) {
        result.push_back(doors_with_values(course));
        result.push_back(doors_of_faces(course));
    }
    return result;
}

std::string kith_version()
{
    return "kith " KITH_VERSION;
}

std::vector<contest> kith_contests(const course_settings& settings)
{
    std::vector<contest> result;
    for (const auto& course : courses(catmull_clark{}, settings)) {
        add_floor(result, course);
        add_creases(result, course);
        add_threads(result, catmull_clark{}, course);
    }
    for (const auto& course : courses(loop{}, settings))
        add_threads(result, loop{}, course);
    add_scheme(result, catmull_clark{}, settings);
    add_scheme(result, loop{}, settings);
    add_scheme(result, butterfly{}, settings);
    add_scheme(result, doo_sabin{}, settings);
    add_scheme(result, sqrt3{}, settings);
    add_scheme(result, kobbelt{}, settings);
    add_scheme(result, nasri_hasbini{}, settings);
    add_scheme(result, mid_edge{}, settings);
    add_scheme(result, four_eight{}, settings);
    return result;
}

} // namespace kith::comparison
