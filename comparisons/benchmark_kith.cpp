// SPDX-License-Identifier: BSD-3-Clause
#include "contests.hpp"

#include <kith/crease/make_creases.hpp>

#include <algorithm>
#include <array>
#include <thread>

namespace kith::comparison {

namespace {

/// Every scheme, the last level with all of its connectivity and without its edges.
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

/// What a result of Catmull-Clark is made of, written to fresh memory: no refinement can be faster than this.
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

/// One edge in a hundred of a control mesh with some thousand edges is infinitely sharp.
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

} // namespace

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
