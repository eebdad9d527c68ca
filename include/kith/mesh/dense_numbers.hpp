// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh_traits.hpp"

#include <kith/base/error.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace kith {

/// The elements of one kind of a mesh, numbered in its order without gaps: meshes may hold removed ones.
template <class M, class Handle>
class dense_numbers {
    using traits = mesh_traits<M>;

public:
    using index_type = std::uint32_t;
    static constexpr index_type none = std::numeric_limits<index_type>::max();

    /// `bound` is above all indices of the range. Errors: mesh_error for more elements than can be numbered. Cost: O(bound).
    template <class Range>
    dense_numbers(const M& mesh, Range range, std::size_t bound)
    {
        if (bound >= none / 2)
            throw mesh_error("the mesh has more elements than a 32-bit index can number");
        bool has_gaps = false;
        for (const Handle x : range)
            has_gaps |= std::size_t(traits::index(mesh, x)) != size_++;
        has_gaps |= size_ != bound;
        if constexpr (can_be_made)
            if (not has_gaps)
                return;
        handles_.reserve(size_);
        for (const Handle x : range)
            handles_.push_back(x);
        if (not has_gaps)
            return;
        numbers_.assign(bound, none);
        for (std::size_t i = 0; i < handles_.size(); ++i)
            numbers_[traits::index(mesh, handles_[i])] = index_type(i);
    }

    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] Handle operator[](std::size_t i) const
    {
        if constexpr (can_be_made)
            if (handles_.empty())
                return traits::template at<Handle>(i);
        return handles_[i];
    }
    /// Whether any handle, an invalid one or that of another mesh too, may be that of an element here.
    [[nodiscard]] bool has(const M& mesh, Handle x) const
    {
        const auto index = std::size_t(traits::index(mesh, x));
        return numbers_.empty() ? index < size_ : index < numbers_.size() and numbers_[index] != none;
    }
    /// `none` for elements that have been removed.
    [[nodiscard]] std::size_t number(const M& mesh, Handle x) const
    {
        const auto index = std::size_t(traits::index(mesh, x));
        return numbers_.empty() ? index : numbers_[index];
    }

private:
    static constexpr bool can_be_made = requires(std::size_t i) { traits::template at<Handle>(i); };

    std::size_t size_ = 0;
    std::vector<Handle> handles_;     // empty where the mesh makes them and there are no gaps
    std::vector<index_type> numbers_; // empty where there are no gaps
};

} // namespace kith
