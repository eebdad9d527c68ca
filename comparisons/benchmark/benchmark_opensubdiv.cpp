// SPDX-License-Identifier: BSD-3-Clause
#include "contests.hpp"
#include "peers/opensubdiv_peer.hpp"

#include <kith/evaluator.hpp>
#include <kith/limits/limit_evaluator.hpp>
#include <kith/presets.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>

namespace kith::comparison {

namespace {

/// The topology of all levels and the points of the last one.
template <class Real>
struct refined {
    opensubdiv_peer::mesh topology;
    opensubdiv_points<Real> points;
};

template <class Real>
std::shared_ptr<const basic_mesh<std::array<Real, 3>>> with_reals(const basic_mesh<>& mesh)
{
    storage<std::array<Real, 3>> points(mesh.vertex_count());
    std::ranges::transform(mesh.points(), points.begin(), [](const auto& p) {
        return std::array<Real, 3>{Real(p[0]), Real(p[1]), Real(p[2])};
    });
    return std::make_shared<const basic_mesh<std::array<Real, 3>>>(std::move(points), mesh.topology());
}

template <class Real, class Scheme>
contest make_contest(const course& course, const Scheme& scheme, bool full)
{
    const std::string what = std::string(full ? "full" : "minimal") + (std::same_as<Real, float> ? ", float" : "");
    const auto theirs = [=]() -> work {
        auto output = std::make_shared<refined<Real>>(opensubdiv_peer::make(*course.control, scheme));
        return [=, control_points = opensubdiv_peer::points_of<Real>(*course.control)] {
            opensubdiv_peer::refine(output->topology, course.levels, full);
            output->points = opensubdiv_peer::interpolate<Real>(output->topology, control_points);
            return output;
        };
    };
    return {std::string(scheme_name<Scheme>()),
            course.name,
            course.levels,
            course.faces,
            {{opensubdiv_peer::version() + ", " + what, theirs, {}},
             native_contestant(std::string(full ? "kith, native" : "kith, native, faces only") +
                                   (std::same_as<Real, float> ? ", float" : ""),
                               with_reals<Real>(*course.control),
                               scheme,
                               course.levels,
                               full ? connect::everything : connect::faces)}};
}

/// Makes a contest that evaluates the points of the last level for moved control points. One contestant refines again,
/// for comparison.
template <class Scheme>
contest make_evaluation_contest(const course& course, const Scheme& scheme)
{
    const auto theirs = [=]() -> work {
        const auto topology = opensubdiv_peer::make(*course.control, scheme);
        opensubdiv_peer::refine(topology, course.levels, false);
        return [table = std::shared_ptr(opensubdiv_peer::stencils<double>(topology)),
                control_points = opensubdiv_peer::points_of<double>(*course.control)] {
            return std::shared_ptr(opensubdiv_peer::evaluated<double>(*table, control_points));
        };
    };
    const auto ours = [=]() -> work {
        return [surface = std::make_shared<evaluator<std::array<double, 3>, std::uint32_t, Scheme>>(
                    *course.control, scheme, course.levels),
                control = course.control] {
            return std::make_shared<storage<std::array<double, 3>>>(surface->evaluate(control->points()));
        };
    };
    return {
        std::string(scheme_name<Scheme>()),
        course.name + ", moved points",
        course.levels,
        course.faces,
        {{opensubdiv_peer::version() + ", stencil table", theirs, {}},
         {"kith, evaluator", ours, {}},
         native_contestant("kith, refined again, faces only", course.control, scheme, course.levels, connect::faces)}};
}

/// Makes a contest that evaluates the limit surface at the vertices of the last level: positions, and tangents or
/// normals. The last level is made before the clock starts.
template <class Scheme>
contest make_limit_contest(const course& course, const Scheme& scheme)
{
    const auto theirs = [=]() -> work {
        auto last = std::make_shared<refined<double>>(opensubdiv_peer::make(*course.control, scheme));
        opensubdiv_peer::refine(last->topology, course.levels, true);
        last->points = opensubdiv_peer::interpolate<double>(last->topology,
                                                            opensubdiv_peer::points_of<double>(*course.control));
        return [=] {
            return std::make_shared<decltype(opensubdiv_peer::limits(last->topology, last->points))>(
                opensubdiv_peer::limits(last->topology, last->points));
        };
    };
    const auto ours = [=]() -> work {
        return [=, last = std::make_shared<basic_mesh<>>(refine(*course.control, scheme, course.levels))] {
            return std::make_shared<limit_surface<std::array<double, 3>>>(limit_surface_of(*last, scheme));
        };
    };
    return {std::string(scheme_name<Scheme>()),
            course.name + ", limit surface",
            course.levels,
            course.faces,
            {{opensubdiv_peer::version() + ", positions and tangents", theirs, {}},
             {"kith, positions and normals", ours, {}}}};
}

/// Makes a contest that evaluates the limit surface at the vertices of the last level for moved control points.
template <class Scheme>
contest make_limit_evaluation_contest(const course& course, const Scheme& scheme)
{
    const auto theirs = [=]() -> work {
        const auto last = std::make_shared<refined<double>>(opensubdiv_peer::make(*course.control, scheme));
        opensubdiv_peer::refine(last->topology, course.levels, true);
        return [last,
                table = std::shared_ptr(opensubdiv_peer::stencils<double>(last->topology)),
                control_points = opensubdiv_peer::points_of<double>(*course.control)] {
            last->points = opensubdiv_peer::evaluated<double>(*table, control_points);
            return std::make_shared<decltype(opensubdiv_peer::limits(last->topology, last->points))>(
                opensubdiv_peer::limits(last->topology, last->points));
        };
    };
    const auto ours = [=]() -> work {
        return [surface = std::make_shared<limit_evaluator<std::array<double, 3>, std::uint32_t, Scheme>>(
                    *course.control, scheme, course.levels),
                control = course.control] {
            return std::make_shared<limit_surface<std::array<double, 3>>>(surface->evaluate(control->points()));
        };
    };
    return {std::string(scheme_name<Scheme>()),
            course.name + ", moved points, limit surface",
            course.levels,
            course.faces,
            {{opensubdiv_peer::version() + ", stencil table, positions and tangents", theirs, {}},
             {"kith, limit_evaluator, positions and normals", ours, {}}}};
}

template <class Scheme>
void add_opensubdiv_contests(std::vector<contest>& list, const course_settings& settings)
{
    const auto scheme = like<Scheme>(library::opensubdiv);
    for (const auto& course : courses(scheme, settings)) {
        list.push_back(make_contest<double>(course, scheme, false));
        list.push_back(make_contest<float>(course, scheme, false));
        list.push_back(make_contest<double>(course, scheme, true));
        list.push_back(make_evaluation_contest(course, scheme));
        list.push_back(make_limit_contest(course, scheme));
        list.push_back(make_limit_evaluation_contest(course, scheme));
    }
}

} // namespace

std::string opensubdiv_version()
{
    return opensubdiv_peer::version();
}

std::vector<contest> opensubdiv_contests(const course_settings& settings)
{
    std::vector<contest> result;
    add_opensubdiv_contests<catmull_clark>(result, settings);
    add_opensubdiv_contests<loop>(result, settings);
    return result;
}

} // namespace kith::comparison
