// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh_traits.hpp"

#include <kith/core/base/error.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

namespace kith {

/// The elements of one kind of a mesh, numbered in its order without gaps: meshes may hold removed ones.
template <mesh M, class Handle>
class dense_numbers {
    using traits = mesh_traits<M>;

public:
    using index_type = std::uint32_t;
    static constexpr index_type none = std::numeric_limits<index_type>::max();

    /// `bound` is above all indices of the range. Errors: mesh_error for more elements than can be numbered. Cost:
    /// O(bound).
    template <class Range>
    dense_numbers(const M& mesh, Range range, std::size_t bound)
    {
        if (bound >= none / 2)
            throw mesh_error("the mesh has more elements than a 32-bit index can number");
        bool has_gaps = false;
        for (const Handle x : range)
            has_gaps |= std::size_t(traits::index(mesh, x)) != size_++;
        has_gaps |= size_ != bound;
        if (has_gaps or not can_be_made)
            keep(mesh, range, has_gaps ? bound : 0);
    }

    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] Handle operator[](std::size_t i) const
    {
        if constexpr (can_be_made)
            return traits::template at<Handle>(kept_.empty() ? i : kept_[i]);
        else
            return kept_[i];
    }
    /// Whether any handle, an invalid one or that of another mesh too, may be that of an element here.
    [[nodiscard]] bool has(const M& mesh, Handle x) const
    {
        const auto index = std::size_t(traits::index(mesh, x));
        return numbers_.empty() ? index < size_ : index < numbers_.size() and numbers_[index] != none;
    }
    /// At least `size()` for handles that are not those of an element here, as those of removed ones.
    [[nodiscard]] std::size_t number(const M& mesh, Handle x) const
    {
        const auto index = std::size_t(traits::index(mesh, x));
        if (numbers_.empty())
            return index;
        return index < numbers_.size() ? numbers_[index] : none;
    }

private:
    static constexpr bool can_be_made = requires(std::size_t i) { traits::template at<Handle>(i); };

    /// Keeps the handles and, below the bound, their numbers. Ranges such as views::filter are no constant ones.
    template <class Range>
    [[gnu::noinline]] void keep(const M& mesh, Range& range, std::size_t bound)
    {
        kept_.resize(size_);
        numbers_.resize(bound, index_type(none));
        std::size_t number = 0;
        for (const Handle x : range) {
            const auto index = index_type(traits::index(mesh, x));
            if (bound != 0)
                numbers_[index] = index_type(number);
            if constexpr (can_be_made)
                kept_[number] = index;
            else
                kept_[number] = x;
            ++number;
        }
    }

    std::size_t size_ = 0;
    // The handles or, where the mesh makes them, their indices; none of these where there are no gaps, either.
    std::vector<std::conditional_t<can_be_made, index_type, Handle>> kept_;
    std::vector<index_type> numbers_; // empty where there are no gaps
};

} // namespace kith
