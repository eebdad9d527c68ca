// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/mask/hash_value.hpp>
#include <kith/hierarchy.hpp>

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

/// Returns the sorted hashes of all vertices of the last level. A hash stands for the operations that compute the
/// vertex from the vertices of the control mesh.
template <class M, class Scheme>
std::vector<kith::hash_value> hashes(const M& control, const Scheme& scheme, int levels)
{
    kith::hierarchy all(control, scheme);
    all.refine(levels);
    std::vector<kith::hash_value> names(all.elements(0).vertex_count());
    for (std::size_t v = 0; v < names.size(); ++v)
        names[v].bits = kith::mix_bits(v + 1);
    const auto carried = all.carry(0, levels, std::span<const kith::hash_value>(names));
    std::vector<kith::hash_value> result(carried.begin(), carried.end());
    std::ranges::sort(result);
    return result;
}
