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

/// The numbering of the elements of one kind of a mesh, in its order and without gaps, since meshes may hold removed
/// elements.
template <mesh M, class Handle>
class dense_numbers {
    using traits = mesh_traits<M>;

public:
    using index_type = std::uint32_t;
    static constexpr index_type none = std::numeric_limits<index_type>::max();

    /// Numbers the elements of a range; `bound` is larger than all their indices. Errors: mesh_error for more elements
    /// than can be numbered. Cost: O(bound).
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
    /// Returns true if a handle may belong to an element here. Any handle may be given: an invalid one, or one of
    /// another mesh.
    [[nodiscard]] bool has(const M& mesh, Handle x) const
    {
        const auto index = std::size_t(traits::index(mesh, x));
        return numbers_.empty() ? index < size_ : index < numbers_.size() and numbers_[index] != none;
    }
    /// Returns the number of an element. For a handle that belongs to no element here, such as a removed one, the
    /// result is at least `size()`.
    [[nodiscard]] std::size_t number(const M& mesh, Handle x) const
    {
        const auto index = std::size_t(traits::index(mesh, x));
        if (numbers_.empty())
            return index;
        return index < numbers_.size() ? numbers_[index] : none;
    }

private:
    static constexpr bool can_be_made = requires(std::size_t i) { traits::template at<Handle>(i); };

    /// Keeps the handles and, for indices below the bound, their numbers. The range is not const, as ranges such as
    /// views::filter cannot be iterated if const.
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
    // The handles, or their indices if handles can be made from these. Empty if there are no gaps and handles can be
    // made.
    std::vector<std::conditional_t<can_be_made, index_type, Handle>> kept_;
    std::vector<index_type> numbers_; // empty if there are no gaps
};

} // namespace kith
