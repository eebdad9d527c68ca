// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lanes.hpp"

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace kith {

template <std::floating_point Scalar>
class lane_program_maker;

/// A program that computes some values of a tape, as sums of weighted sums over slots. To replay it, neither a mesh nor
/// a scheme is needed. Its operations are those of the tape in their order, so each lane has the bits that the scheme
/// itself computes.
template <std::floating_point Scalar>
class lane_program {
public:
    using slot = std::uint16_t;

    /// Returns the values of the tape that are read. They fill the first slots, one after the other.
    [[nodiscard]] std::span<const std::uint32_t> inputs() const { return inputs_; }
    /// Returns the slots of the outputs.
    [[nodiscard]] std::span<const slot> outputs() const { return outputs_; }
    [[nodiscard]] std::size_t slots() const { return slots_; }
    [[nodiscard]] std::size_t bytes() const
    {
        return values_.size() * sizeof(value) + terms_.size() * sizeof(term) +
               (operands_.size() + outputs_.size()) * sizeof(slot) + inputs_.size() * sizeof(inputs_[0]);
    }
    /// Returns true if more slots are needed than `slot` can number. Such a program must not run.
    [[nodiscard]] bool is_too_long() const { return slots_ > std::numeric_limits<slot>::max(); }

#ifdef KITH_HAS_LANES
    /// Computes all outputs. Slot s consists of `Size` registers of `Bytes` bytes, from slots[s * Size] on.
    template <std::size_t Size, std::size_t Bytes>
    [[gnu::always_inline]] void run(typename lanes<Scalar, Bytes>::type* slots) const
    {
        using pack = typename lanes<Scalar, Bytes>::type;
        const slot* next = operands_.data();
        const term* t = terms_.data();
        for (const value& v : values_) {
            pack total[Size];
            const auto load = [&](pack(&to)[Size]) __attribute__((always_inline)) {
                const pack* const from = slots + Size * std::size_t(*next++);
                for (std::size_t i = 0; i < Size; ++i)
                    to[i] = from[i];
            };
            const auto add = [&](pack(&to)[Size]) __attribute__((always_inline)) {
                const pack* const from = slots + Size * std::size_t(*next++);
                for (std::size_t i = 0; i < Size; ++i)
                    to[i] += from[i];
            };
            const auto scale = [](pack(&what)[Size], Scalar weight) __attribute__((always_inline)) {
                for (std::size_t i = 0; i < Size; ++i) {
                    what[i] *= weight;
                    keep_rounded(what[i]);
                }
            };
            load(total);
            for (unsigned i = 1; i < t->count; ++i)
                add(total);
            if (t->is_scaled)
                scale(total, t->weight);
            ++t;
            for (unsigned more = 1; more < v.terms; ++more, ++t) {
                if (not t->is_scaled) {
                    for (unsigned i = 0; i < t->count; ++i)
                        add(total);
                    continue;
                }
                pack sum[Size];
                load(sum);
                for (unsigned i = 1; i < t->count; ++i)
                    add(sum);
                scale(sum, t->weight);
                for (std::size_t i = 0; i < Size; ++i)
                    total[i] += sum[i];
            }
            if (v.is_scaled)
                scale(total, v.weight);
            pack* const to = slots + Size * std::size_t(v.target);
            for (std::size_t i = 0; i < Size; ++i)
                to[i] = total[i];
        }
    }
#endif

private:
    friend class lane_program_maker<Scalar>;

    /// A sum of `count` slots, multiplied by `weight` if `is_scaled`. The slots of an unscaled term are added one by
    /// one to the terms before it.
    struct term {
        Scalar weight;
        std::uint16_t count;
        bool is_scaled;
    };
    struct value {
        Scalar weight;
        std::uint16_t terms;
        slot target;
        bool is_scaled;
    };

    std::vector<value> values_;
    std::vector<term> terms_;
    std::vector<slot> operands_, outputs_;
    std::vector<std::uint32_t> inputs_;
    std::size_t slots_ = 0;
};

} // namespace kith
