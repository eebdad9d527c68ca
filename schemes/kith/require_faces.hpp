// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/error.hpp>
#include <kith/scheme_traits.hpp>

#include <string>

namespace kith {

/// Throws mesh_error at inner vertices between two faces only. Schemes that make a face of every vertex would make one of
/// two corners there. No step makes such vertices where there are none, so looking at a mesh before the first is enough.
/// Cost: O(corners).
template <class Scheme, class Level>
void require_three_faces(const Level& coarse)
{
    for (const auto v : coarse.vertices())
        if (not v.is_boundary() and v.face_count() < 3)
            throw mesh_error(std::string(scheme_name<Scheme>()) + ": vertex " + std::to_string(v.index()) +
                             " lies between " + std::to_string(v.face_count()) +
                             " faces only, the scheme needs three; join its edges to one first");
}

} // namespace kith
