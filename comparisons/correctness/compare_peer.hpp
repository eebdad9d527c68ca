// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "compare_files.hpp"

#include <kith/compiled_schemes.hpp>
#include <kith/hierarchy.hpp>
#include <kith/presets.hpp>
#include <kith/refine.hpp>

#include <exception>
#include <string>

namespace kith::comparison {

/// Compares one scheme on one mesh: the peer's own refinement against kith's. kith refines the native mesh, the peer's
/// mesh through the native one (`refine`), and the peer's mesh level by level (`hierarchy`).
template <class Peer, class Scheme>
void compare_scheme(const control_mesh& control, int levels, verdicts& verdicts)
{
    const auto name = scheme_name<Scheme>();
    if (needs_triangles<Scheme> and not control.is_triangles())
        return verdicts.skip(control.name, name, "not only triangles");
    const auto foreign = Peer::make(control.mesh);
    if (not foreign)
        return verdicts.different(control.name, name, Peer::version() + " refuses a mesh that kith takes");
    const auto scheme = like<Scheme>(Peer::conventions);
    try {
        hierarchy ours(*foreign, scheme);
        ours.refine(levels);
        auto theirs = *foreign;
        Peer::refine(theirs, scheme, levels);
        verdicts.compare(control,
                         name,
                         Peer::soup(theirs),
                         {{"native", soup_of(refine(control.mesh, scheme, levels))},
                          {"refine", Peer::soup(refine(*foreign, scheme, levels))},
                          {"hierarchy", Peer::soup(ours.finest())}});
    } catch (const mesh_error& error) {
        verdicts.skip(control.name, name, std::string("kith refuses it: ") + error.what());
    } catch (const std::exception& error) {
        verdicts.different(control.name, name, error.what());
    }
}

} // namespace kith::comparison
