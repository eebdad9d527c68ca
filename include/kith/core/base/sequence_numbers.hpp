// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "in_library.hpp"
#include "platform.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace kith {

/// The numbering of sequences of integers: equal sequences get the same number, counted from zero. Several threads may
/// ask, each through its own reader. The order in which they ask decides only which sequence gets which number.
class sequence_numbers {
public:
    using number = std::uint32_t;
    struct numbered {
        number sequence;
        number first_item; ///< number of its first item; items are numbered sequence after sequence
    };

private:
    struct hash : std::hash<std::u32string_view> {
        using is_transparent = void;
    };
    using table = std::unordered_map<std::u32string, numbered, hash, std::equal_to<>>;

public:
    [[nodiscard]] std::size_t count() const { return of_sequence_.size(); }

    /// A cache of the sequences that one thread asked for, so that it rarely waits for other threads. A sequence asked
    /// for recently is found fastest.
    class reader {
    public:
        explicit reader(sequence_numbers& numbers) : numbers_(numbers), last_(places) {}

        /// Returns the number of a sequence and of its first item. Cost: O(length).
        [[nodiscard]] numbered operator()(std::u32string_view sequence)
        {
            std::uint64_t mixed = sequence.size();
            for (const char32_t item : sequence)
                mixed = (mixed ^ item) * 0x9e3779b97f4a7c15; // 2^64 over the golden ratio (Knuth 1998, 6.4)
            const table::value_type*& last = last_[mixed >> (64 - log2_places)];
            if (last == nullptr or last->first != sequence) {
                auto known = known_.find(sequence);
                if (known == known_.end())
                    known = known_.emplace(sequence, numbers_.number_of(sequence)).first;
                last = &*known;
            }
            return last->second;
        }

    private:
        static constexpr int log2_places = 10;
        static constexpr std::size_t places = std::size_t(1) << log2_places;

        sequence_numbers& numbers_;
        table known_;
        std::vector<const table::value_type*> last_; // by the hash of the sequence
    };

private:
    numbered number_of(std::u32string_view sequence)
    {
        const std::lock_guard lock(mutex_);
        const numbered next{number(of_sequence_.size()), items_};
        const auto [place, is_new] = of_sequence_.try_emplace(std::u32string(sequence), next);
        if (is_new)
            items_ += number(sequence.size());
        return place->second;
    }

    detail::mutex mutex_;
    table of_sequence_;
    number items_ = 0;
};

} // namespace kith
