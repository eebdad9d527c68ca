// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/error.hpp>
#include <kith/core/mesh/mesh_traits.hpp>
#include <kith/numbering/association/association.hpp>
#include <kith/numbering/association/numbering.hpp>
#include <kith/numbering/association/tuples.hpp>

#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>

namespace kith {

/// Returns the element of the next level that belongs to a tuple of elements, by the numbering of the step alone.
/// Returns nothing if the scheme made no element from the tuple. Cost: O(1), O(valence) for pairs without their edge;
/// O(log n) for vertices of the dictionary.
template <level Coarse, level_numbering Numbering, level Fine, target Target, element... X>
auto retrieve(const Coarse& coarse, const Numbering& ids, const Fine& fine, Target, const X&... x)
{
    const auto tuple = index_tuple(x...);
    constexpr tuple_kind kind = decltype(tuple)::kind;
    const auto find = [&](const auto& column_ids, const auto& at) -> std::optional<decltype(at(0))> {
        if constexpr (std::remove_cvref_t<decltype(column_ids)>::template has<kind>)
            if (tuple.value != tuple.not_incident)
                if (const auto id = column_ids.template id<kind>(tuple.value); id != column_ids.none)
                    return at(id);
        return {};
    };
    if constexpr (std::same_as<Target, targets::to_vertex>) {
        auto found = find(ids.vertices, [&](std::size_t id) { return fine.vertex_at(id); });
        if (not found)
            if (const auto listed = ids.dictionary.find(listed_tuple(coarse, tuple, x...)))
                found = fine.vertex_at(*listed);
        return found;
    } else if constexpr (std::same_as<Target, targets::to_edge>)
        return find(ids.edges, [&](std::size_t id) { return fine.edge_at(id); });
    else
        return find(ids.faces, [&](std::size_t id) { return fine.face_at(id); });
}

/// Returns the level if it has the element with this handle. Errors: mesh_error for all other handles.
template <mesh M, level Level, element_handle Handle>
const Level& require_element(const Level& here, const M& mesh, Handle x, int level)
{
    using traits = mesh_traits<M>;
    if (not here.has(x)) {
        constexpr const char* kind = std::same_as<Handle, typename traits::vertex> ? "vertex"
                                     : std::same_as<Handle, typename traits::edge> ? "edge"
                                                                                   : "face";
        const auto number = std::size_t(traits::index(mesh, x));
        const bool invalid = number >= std::numeric_limits<typename Level::index_type>::max() / 2;
        throw mesh_error("level " + std::to_string(level) + " has no " + kind +
                         (invalid ? " with this handle, which is invalid"
                                  : " " + std::to_string(number) + ", it was removed or is of another mesh") +
                         "; take handles from level " + std::to_string(level));
    }
    return here;
}

} // namespace kith
