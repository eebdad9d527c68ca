// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/numbering/step/scheme.hpp>
#include <kith/schemes/kernel/limit_rules.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <vector>

namespace kith {

/// Requirements of a scheme whose limits can be searched for. Beside its masks it needs a reach: that of tiles, in its
/// traits(), or that of its limit_rules.
template <class S>
concept searchable_scheme = scheme<S> and requires(const S& s) {
    { limit_rules<S>::reach(s, 1) } -> std::convertible_to<int>;
};

namespace detail {

/// The rings of faces that are kept around the searched elements, at each of the virtual steps.
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
    /// Returns true if a fixed number of rings suffices for any number of steps.
    [[nodiscard]] bool is_bounded() const { return is_bounded_; }
    [[nodiscard]] int at(int step) const
    {
        return rings_[std::min(rings_.size() - 1, is_bounded_ ? rings_.size() : std::size_t(steps_ - step))];
    }

private:
    std::vector<int> rings_; // by step, from the last step back
    int steps_;
    bool is_bounded_ = false;
};

/// The number of steps in which masks are looked for if refined rings are no thinner than coarse ones. Each step then
/// costs a ring.
inline constexpr int few_steps = 8;

/// The number of virtual steps after which two levels of the same neighbourhood differ by rounding only.
inline constexpr int many_steps = 1000;

} // namespace detail

} // namespace kith
