// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contest.hpp"
#include "courses.hpp"

#include <kith/presets.hpp>
#include <kith/refine.hpp>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace kith::comparison {

// The functions of each peer, one source file per peer. The version is known even if there are no contests. "Doors" are
// the calls by which users of a mesh type refine it, with all data that is carried.
std::string cgal_version();
std::vector<contest> cgal_contests(const course_settings& settings);
std::vector<contest> cgal_doors(const course_settings& settings);
std::string openmesh_version();
std::vector<contest> openmesh_contests(const course_settings& settings);
std::vector<contest> openmesh_doors(const course_settings& settings);
std::string kith_version();
std::vector<contest> kith_contests(const course_settings& settings);
std::vector<contest> kith_doors(const course_settings& settings);
std::string opensubdiv_version();
std::vector<contest> opensubdiv_contests(const course_settings& settings);

/// Makes a contestant whose work is one call without preparation.
template <class Call>
contestant caller(std::string name, const Call& call)
{
    return {
        std::move(name), [=]() -> work { return [=] { return std::shared_ptr<const void>(new auto(call())); }; }, {}};
}

/// Makes the contestant that refines a native mesh to a native mesh with kith.
template <class Point, class Scheme>
contestant native_contestant(std::string name, std::shared_ptr<const basic_mesh<Point>> control, const Scheme& scheme,
                             int levels, connect last_level)
{
    return {std::move(name),
            [=]() -> work {
                return
                    [=] { return std::make_shared<basic_mesh<Point>>(refine(*control, scheme, levels, {last_level})); };
            },
            {}};
}

/// Adds contests between the peer's own refinement, kith on meshes of the peer, and kith on the native mesh. The mesh
/// types of peers that refine in place are always complete, so the contestant "kith, native" is the one to compare with
/// them.
template <class Peer, class Scheme>
void add_contests(std::vector<contest>& list, const course_settings& settings)
{
    using mesh = typename Peer::mesh;
    const auto scheme = like<Scheme>(Peer::conventions);
    for (const auto& [name, control, levels, faces] : courses(scheme, settings)) {
        const auto make = [control = control] { return std::make_shared<mesh>(Peer::make(*control).value()); };
        const auto theirs = [=, levels = levels]() -> work {
            return [=, input = make()] {
                Peer::refine(*input, scheme, levels);
                return input;
            };
        };
        const auto ours = [=, levels = levels]() -> work {
            return [=, input = make()] { // made in place: a mesh of OpenMesh cannot be moved, only copied
                return std::shared_ptr<mesh>(new mesh(refine(*input, scheme, levels)));
            };
        };
        list.push_back({std::string(scheme_name<Scheme>()),
                        name,
                        levels,
                        faces,
                        {{Peer::version(), theirs, {}},
                         {"kith, on its meshes", ours, {}},
                         native_contestant("kith, native", control, scheme, levels, connect::everything),
                         native_contestant("kith, native, faces only", control, scheme, levels, connect::faces)}});
    }
}

} // namespace kith::comparison
