// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/hierarchy.hpp>
#include <kith/tiles/number/global_lineage.hpp>

#include <cstddef>
#include <random>
#include <string>

/// Comparisons of the ancestors and descendants that a hierarchy gives as elements and a lineage as numbers.
namespace family {

template <class Levels, class F>
auto with_handle(const Levels& levels, int level, const kith::numbered_element& x, const F& f)
{
    const auto& here = levels.elements(level);
    switch (x.kind) {
    case kith::element_kind::vertex: return f(here.vertex_at(x.number));
    case kith::element_kind::edge: return f(here.edge_at(x.number));
    default: return f(here.face_at(x.number));
    }
}

template <class Levels>
std::size_t size(const Levels& levels, int level, kith::element_kind kind)
{
    const auto& here = levels.elements(level);
    return kind == kith::element_kind::vertex ? here.vertex_count()
           : kind == kith::element_kind::edge ? here.edge_count()
                                              : here.face_count();
}

/// Returns the first difference for one element, or "". Compares its ancestor on a coarser level and all descendants of
/// that ancestor.
template <class Levels, class Lineage>
std::string difference(const Levels& levels, const Lineage& lineage, int level, const kith::numbered_element& x,
                       int coarser)
{
    const auto expected = with_handle(levels, level, x, [&](auto handle) {
        const auto up = levels.ancestor(level, handle, coarser);
        const auto& above = levels.elements(coarser);
        return kith::numbered_element{up.kind,
                                      up.v   ? above.index(*up.v)
                                      : up.e ? above.index(*up.e)
                                             : above.index(*up.f)};
    });
    const std::string who = "element " + std::to_string(x.number) + " of kind " + std::to_string(int(x.kind)) +
                            " of level " + std::to_string(level) + " and level " + std::to_string(coarser);
    if (lineage.ancestor(level, x, coarser) != expected)
        return "ancestors differ of " + who;
    const auto down = lineage.descendants(coarser, expected, level);
    const auto known = with_handle(
        levels, coarser, expected, [&](auto handle) { return levels.descendants(coarser, handle, level).numbers(); });
    return down == known ? "" : "descendants differ, above " + who;
}

/// Returns the first difference for all elements of a level and all coarser levels, or "".
template <class Levels, class Lineage>
std::string difference(const Levels& levels, const Lineage& lineage, int level)
{
    for (const auto kind : {kith::element_kind::vertex, kith::element_kind::edge, kith::element_kind::face})
        for (std::size_t x = 0; x < size(levels, level, kind); ++x)
            for (int coarser = 0; coarser <= level; ++coarser)
                if (auto text = difference(levels, lineage, level, {kind, x}, coarser); not text.empty())
                    return text;
    return {};
}

/// Returns the first difference for `count` elements of a level and coarser levels chosen at random, or "".
template <class Levels, class Lineage>
std::string difference_of_some(const Levels& levels, const Lineage& lineage, int level, std::uint32_t seed, int count)
{
    std::mt19937 random(seed);
    for (int i = 0; i < count; ++i) {
        const auto kind = kith::element_kind(random() % 3);
        const auto x = random() % size(levels, level, kind);
        if (auto text = difference(levels, lineage, level, {kind, x}, int(random() % unsigned(level + 1)));
            not text.empty())
            return text;
    }
    return {};
}

} // namespace family
