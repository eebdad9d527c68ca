// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/numbering/step/scheme.hpp>
#include <kith/schemes/kernel/limit_rules.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <vector>

namespace kith {

/// What a search for limits needs to know of a scheme beside its masks: the reach of tiles, in its traits(), or that of
/// its limit_rules.
template <class S>
concept searchable_scheme = scheme<S> and requires(const S& s) {
    { limit_rules<S>::reach(s, 1) } -> std::convertible_to<int>;
};

namespace detail {

/// The rings that have to be kept around what is looked for, at each of the virtual steps.
class limit_rings {
public:
    template <scheme Scheme>
    limit_rings(const Scheme& scheme, int steps) : rings_{limit_rules<Scheme>::rings(scheme)}, steps_(steps)
    {
        while (int(rings_.size()) <= steps and not is_bounded_) {
            const int before = limit_rules<Scheme>::reach(scheme, rings_.back());
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
