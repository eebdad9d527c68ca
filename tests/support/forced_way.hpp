// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/engine/strategy/strategy.hpp>

#include <array>

/// A guard that forces all refinements to use one way while it is alive.
class forced_way_here {
public:
    explicit forced_way_here(kith::refinement_way way) { kith::force_way(way); }
    forced_way_here(const forced_way_here&) = delete;
    forced_way_here& operator=(const forced_way_here&) = delete;
    ~forced_way_here() { kith::force_way({}); }
};

inline constexpr std::array all_ways{
    kith::refinement_way::by_levels, kith::refinement_way::in_surface_order, kith::refinement_way::in_patches};
