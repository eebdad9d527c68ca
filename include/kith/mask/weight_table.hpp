// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <utility>

namespace kith {

/// Weights by valence, computed once per step for the valences that meshes have, on the spot for the rare others.
template <class Scalar>
class weight_table {
public:
    explicit weight_table(std::function<double(std::size_t)> weight) : weight_(std::move(weight))
    {
        for (std::size_t n = 1; n < table_.size(); ++n)
            table_[n] = Scalar(weight_(n));
    }

    /// Precondition: n > 0.
    [[nodiscard]] Scalar operator[](std::size_t n) const
    {
        if (n < table_.size()) [[likely]]
            return table_[n];
        return rare(n);
    }

private:
    // Pure: a loop need not read anew what it knows after a call.
    [[nodiscard, gnu::cold, gnu::noinline, gnu::pure]] Scalar rare(std::size_t n) const { return Scalar(weight_(n)); }

    std::function<double(std::size_t)> weight_;
    std::array<Scalar, 65> table_{};
};

} // namespace kith
