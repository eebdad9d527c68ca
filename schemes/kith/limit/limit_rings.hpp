// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/step/scheme.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <vector>

namespace kith {

/// What a search for limits needs to know of a scheme beside its masks: the reach of tiles, in its traits(), or
/// limit_reach(rings), the same of schemes that are not refined in tiles.
template <class S>
concept searchable_scheme = scheme<S> and (detail::says_reach<S, traits_type<S>> or requires(const S& s) {
                                { s.limit_reach(1) } -> std::convertible_to<int>;
                            });

namespace detail {

/// How many rings of faces around a vertex's own its limit masks ask about: `limit_rings()` of the scheme, else two.
template <class Scheme>
int mask_rings(const Scheme& scheme)
{
    if constexpr (requires { scheme.limit_rings(); })
        return scheme.limit_rings();
    else
        return 2;
}

template <class Scheme>
int rings_before(const Scheme& scheme, int rings)
{
    if constexpr (requires { scheme.limit_reach(rings); })
        return scheme.limit_reach(rings);
    else
        return ask(traits_of<Scheme>.reach, scheme, rings);
}

/// The rings that have to be kept around what is looked for, at each of the virtual steps.
class limit_rings {
public:
    template <class Scheme>
    limit_rings(const Scheme& scheme, int steps) : rings_{mask_rings(scheme)}, steps_(steps)
    {
        while (int(rings_.size()) <= steps and not is_bounded_) {
            const int before = rings_before(scheme, rings_.back());
            is_bounded_ = before <= rings_.back();
            if (not is_bounded_)
                rings_.push_back(before);
        }
    }
    /// So many rings do for any number of steps.
    [[nodiscard]] bool is_bounded() const { return is_bounded_; }
    [[nodiscard]] int at(int step) const
    {
        return rings_[std::min(rings_.size() - 1, is_bounded_ ? rings_.size() : std::size_t(steps_ - step))];
    }

private:
    std::vector<int> rings_; // from the last step back
    int steps_;
    bool is_bounded_ = false;
};

/// Steps to look for masks where refined rings are no thinner than coarse ones, so that each step costs a ring.
inline constexpr int few_steps = 8;

/// The virtual steps after which two levels of the same neighbourhood are told apart by rounding only.
inline constexpr int many_steps = 1000;

} // namespace detail

} // namespace kith
