// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "carried_properties.hpp"

#include <cstdint>
#include <vector>

namespace kith::in_place {

/// The properties of a mesh without named properties: there are none.
class no_properties {
public:
    template <class M, class... Argument>
    explicit no_properties(const M&, const std::vector<std::uint32_t>&, const Argument&...)
    {
        static_assert(sizeof...(Argument) == 0, "this graph has no properties with names; leave out by_rule and types");
    }
    [[nodiscard]] no_properties& values() { return *this; }
    template <finished_step Step>
    void advance(const Step&, bool) const
    {
    }
    template <scheme Scheme>
    [[nodiscard]] static bool may_go_in_patches()
    {
        return true;
    }
    template <class InPatches>
    [[nodiscard]] static bool can_go(const InPatches&)
    {
        return true;
    }
    template <class InPatches>
    void go(const InPatches&) const
    {
    }
    template <class M, class Vertices>
    void write(M&, const Vertices&) const
    {
    }
    [[nodiscard]] static property_report report(bool) { return {}; }
};

template <class M, class... Argument>
struct properties_of {
    using type = no_properties;
};
template <mesh_with_properties M, class... Argument>
struct properties_of<M, Argument...> {
    using type = carried_properties<M, Argument...>;
};

} // namespace kith::in_place
