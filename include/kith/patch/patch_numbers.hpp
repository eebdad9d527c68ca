// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "child_numbers.hpp"

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace kith {

/// The numbers that a patch writes and those of the places where it does, which all follow from the numbers of few coarse
/// elements: a number is an offset plus a multiple, which is a factor times the number of a source.
template <std::unsigned_integral Index>
class patch_numbers {
public:
    using place = std::uint16_t; ///< in the list of multiples

    struct multiple {
        std::uint32_t source; ///< its place in the list of sources
        Index factor;
    };
    /// Numbers one by one.
    struct list {
        std::vector<Index> offset;
        std::vector<place> of;
    };
    /// Numbers that follow one another, or every second one.
    struct run {
        Index offset;
        place of;
        std::uint16_t step;
        std::uint32_t count;
    };

    /// Of sources with numbers below `sources`.
    explicit patch_numbers(std::size_t sources) : of_source_(sources) {}

    [[nodiscard]] const std::vector<multiple>& multiples() const { return multiples_; }
    /// Those that multiples are of.
    [[nodiscard]] const std::vector<std::uint32_t>& sources() const { return sources_; }
    /// There are more than places are for: it must not be used.
    [[nodiscard]] bool is_too_long() const { return multiples_.size() > std::numeric_limits<place>::max(); }

    [[nodiscard]] list all(std::span<const affine_number<Index>> numbers)
    {
        list result;
        for (const auto& n : numbers) {
            result.offset.push_back(n.offset);
            result.of.push_back(find(n));
        }
        return result;
    }
    [[nodiscard]] std::vector<run> runs(std::span<const affine_number<Index>> numbers)
    {
        std::vector<run> result;
        for (const auto& n : numbers) {
            const place of = find(n);
            if (result.empty() or not follows(result.back(), n.offset, of))
                result.push_back({n.offset, of, 1, 0});
            run& last = result.back();
            if (last.count == 1)
                last.step = std::uint16_t(n.offset - last.offset);
            ++last.count;
        }
        return result;
    }

private:
    static bool follows(const run& last, Index offset, place of)
    {
        const Index step = Index(offset - last.offset);
        return of == last.of and (last.count == 1 ? step == 1 or step == 2 : step == Index(last.step * last.count));
    }
    place find(const affine_number<Index>& n)
    {
        for (const auto& [factor, made] : of_source_[n.source])
            if (factor == n.factor)
                return made;
        auto& known = of_source_[n.source];
        const std::uint32_t source = known.empty() ? std::uint32_t(sources_.size())
                                                   : multiples_[known.front().second].source;
        if (known.empty())
            sources_.push_back(n.source);
        known.emplace_back(n.factor, place(multiples_.size()));
        multiples_.push_back({source, n.factor});
        return known.back().second;
    }

    std::vector<multiple> multiples_;
    std::vector<std::uint32_t> sources_;
    std::vector<std::vector<std::pair<Index, place>>> of_source_;
};

} // namespace kith
