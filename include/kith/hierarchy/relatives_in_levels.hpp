// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "level_store.hpp"
#include "parent_of.hpp"
#include "relatives.hpp"
#include "retrieve.hpp"

#include <kith/core/base/error.hpp>

#include <string>
#include <utility>

// Functions from elements of a stored level to elements of other levels; the hierarchy says what each means, costs and
// refuses.

namespace kith {

/// Throws mesh_error if one of two levels is not in memory, or if `from` is finer than `to`.
template <mesh M, scheme Scheme>
void require_order(const level_store<M, Scheme>& levels, int from, int to)
{
    static_cast<void>(levels.at(from));
    static_cast<void>(levels.at(to));
    if (from > to)
        throw mesh_error("values cannot be carried from level " + std::to_string(from) + " to level " +
                         std::to_string(to) + "; carry them to the same level or a finer one");
}
/// Throws mesh_error if one of two levels is not in memory, or if `coarser` is finer than `finer`.
template <mesh M, scheme Scheme>
void require_finer(const level_store<M, Scheme>& levels, int finer, int coarser)
{
    static_cast<void>(levels.at(finer));
    static_cast<void>(levels.at(coarser));
    detail::require_finer(finer, coarser);
}

/// Returns the element that the scheme made of a tuple of elements of a level, for hierarchy::assoc. Errors:
/// association_error if it made none, and on the last level; mesh_error if a level is not in memory. Cost: that of
/// `retrieve`.
template <mesh M, scheme Scheme, target Target, element... X>
auto child_of(const level_store<M, Scheme>& levels, int level, Target to, const X&... x)
{
    if (level == levels.depth())
        throw association_error("level " + std::to_string(level) +
                                " is the last, so its elements have no children yet; refine() first");
    const auto found = retrieve(levels.elements(level), levels.at(level).ids, levels.elements(level + 1), to, x...);
    if (not found)
        throw association_error("level " + std::to_string(level) + ": the scheme made no element from this tuple");
    return *found;
}

/// Returns the elements that made an element of a level, for hierarchy::origin. Errors: mesh_error for level 0, and if
/// a level is not in memory. Cost: that of `birth_of`.
template <mesh M, scheme Scheme, element Element>
birth<M> birth_in(const level_store<M, Scheme>& levels, int level, const Element& x)
{
    detail::require_origins(level);
    return birth_of<M>(levels.elements(level - 1), levels.at(level - 1).ids, levels.elements(level), x);
}

/// Returns the element of a coarser level from which an element of a level descends, for hierarchy::ancestor. Errors:
/// those of require_finer, and mesh_error if a level between is not in memory. Cost: that of `parent_of` per level.
template <mesh M, scheme Scheme>
ancestor_element<M> ancestor_in(const level_store<M, Scheme>& levels, int level, numbered_element x, int coarser)
{
    require_finer(levels, level, coarser);
    for (; level > coarser; --level)
        x = parent_of(levels.elements(level - 1), levels.at(level - 1).ids, levels.elements(level), x);
    return {levels.elements(coarser), x};
}

/// Returns the elements of a finer level that descend from an element of a level, for hierarchy::descendants. Errors:
/// as ancestor_in. Cost: that of `children` per level.
template <mesh M, scheme Scheme>
auto descendants_in(const level_store<M, Scheme>& levels, int level, const numbered_element& x, int finer)
{
    require_finer(levels, finer, level);
    auto ranges = only(x);
    for (; level < finer; ++level)
        ranges = children(levels.elements(level), levels.at(level).ids, levels.elements(level + 1), ranges);
    return descendant_elements<level_of<M>>{levels.elements(finer), std::move(ranges)};
}

} // namespace kith
