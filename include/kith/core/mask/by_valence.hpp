// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ring_waves.hpp"

#include <kith/core/base/platform.hpp>

#include <array>
#include <atomic>
#include <cstddef>
#include <functional>
#include <mutex>
#include <utility>
#include <vector>

namespace kith {

/// The weights of a rule by valence. They are computed once per step for all valences up to `longest_row`, and on
/// demand for the rare larger ones.
template <weight_number Scalar>
class weights_by_valence {
public:
    explicit weights_by_valence(std::function<double(std::size_t)> weight) : weight_(std::move(weight))
    {
        for (std::size_t n = 1; n < table_.size(); ++n)
            table_[n] = Scalar(weight_(n));
    }

    /// Returns the weight for valence n. Precondition: n > 0.
    [[nodiscard]] Scalar operator()(std::size_t n) const
    {
        if (n < table_.size()) [[likely]]
            return table_[n];
        return rare(n);
    }

private:
    // The function is pure, so that a loop need not read again after a call what it has read before.
    [[nodiscard, gnu::cold, gnu::noinline, gnu::pure]] Scalar rare(std::size_t n) const { return Scalar(weight_(n)); }

    std::function<double(std::size_t)> weight_;
    std::array<Scalar, longest_row + 1> table_{};
};

/// Returns the weights by valence in the scalar type of a refinement:
/// `by_valence(r, [](std::size_t n) { return ...; })`.
template <has_scalar Refinement>
[[nodiscard]] auto by_valence(const Refinement&, std::function<double(std::size_t)> weight)
{
    return weights_by_valence<typename Refinement::scalar>(std::move(weight));
}

/// The rows of weights by valence, for masks whose weights differ around a ring. Each row is computed when it is needed
/// for the first time.
template <weight_number Scalar>
class rows_by_valence {
public:
    using row_function = std::function<std::vector<double>(std::size_t)>;

    explicit rows_by_valence(row_function row) : row_(std::move(row)) {}

    /// Returns the row for valence n, as long as the row function makes it. Several threads may call it at once.
    /// Precondition: 0 < n <= longest_row.
    [[nodiscard]] const Scalar* operator()(std::size_t n) const
    {
        if (not is_made_[n].load(std::memory_order_acquire)) [[unlikely]]
            make(n);
        return rows_[n].data();
    }

private:
    [[gnu::cold, gnu::noinline]] void make(std::size_t n) const
    {
        const std::lock_guard lock(mutex_);
        if (is_made_[n].load(std::memory_order_relaxed))
            return;
        for (const double weight : row_(n))
            rows_[n].push_back(Scalar(weight));
        is_made_[n].store(true, std::memory_order_release);
    }

    row_function row_;
    mutable detail::mutex mutex_;
    mutable std::array<std::vector<Scalar>, longest_row + 1> rows_;
    mutable std::array<std::atomic<bool>, longest_row + 1> is_made_{};
};

} // namespace kith
