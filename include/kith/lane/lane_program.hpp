// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lanes.hpp"
#include "tape.hpp"

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace kith {

/// What of a tape is needed for some of its values, as sums of weighted sums over slots: replayed, it walks no mesh and knows
/// no scheme. Operations are those of the tape in their order, so each lane has the bits of the scheme's own text.
template <std::floating_point Scalar>
class lane_program {
public:
    using slot = std::uint16_t;

    lane_program() = default;
    /// The outputs are values of the tape. Cost: O(tape).
    lane_program(const tape<Scalar>& from, std::span<const std::uint32_t> outputs) : tape_(&from)
    {
        mark_needed(outputs);
        place_.assign(from.values.size(), none);
        place_of_node_.assign(from.nodes.size(), none);
        for (std::uint32_t v = 0; v < from.values.size(); ++v) {
            if (not needed_[v])
                continue;
            if (from.values[v] == tape<Scalar>::none) {
                inputs_.push_back(v);
                place_[v] = places_++;
            } else if (const node& root = from.nodes[from.values[v]]; root.kind == operation::load) {
                place_[v] = place_[root.a];
            } else {
                place_[v] = make(from.values[v]);
            }
        }
        share_slots(outputs);
        tape_ = nullptr;
        place_ = {};
        place_of_node_ = {};
        needed_ = {};
    }

    /// The values of the tape that are read, one after the other in the first slots.
    [[nodiscard]] std::span<const std::uint32_t> inputs() const { return inputs_; }
    /// The slots of the outputs.
    [[nodiscard]] std::span<const slot> outputs() const { return outputs_; }
    [[nodiscard]] std::size_t slots() const { return slots_; }
    [[nodiscard]] std::size_t bytes() const
    {
        return values_.size() * sizeof(value) + terms_.size() * sizeof(term) +
               (operands_.size() + outputs_.size()) * sizeof(slot) + inputs_.size() * sizeof(inputs_[0]);
    }
    /// More slots were needed than there are numbers for: it must not run.
    [[nodiscard]] bool is_too_long() const { return slots_ > std::numeric_limits<slot>::max(); }

#ifdef KITH_HAS_LANES
    /// Makes all outputs; slot s is Size registers from slots[s * Size] on.
    template <std::size_t Size>
    [[gnu::always_inline]] void run(typename lanes<Scalar>::type* slots) const
    {
        using pack = typename lanes<Scalar>::type;
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
    using node = typename tape<Scalar>::node;
    using operation = typename tape<Scalar>::operation;
    using place = std::uint32_t; ///< a slot of its own for each value; several share one in the end
    static constexpr place none = std::numeric_limits<place>::max();

    /// The sum of some slots, times a weight; added to what came before one by one where it is not scaled.
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

    void mark_needed(std::span<const std::uint32_t> outputs)
    {
        needed_.assign(tape_->values.size(), false);
        for (const std::uint32_t v : outputs)
            needed_[v] = true;
        std::vector<std::uint32_t> stack;
        for (std::size_t v = needed_.size(); v-- > 0;) {
            if (not needed_[v] or tape_->values[v] == tape<Scalar>::none)
                continue;
            stack.push_back(tape_->values[v]);
            while (not stack.empty()) {
                const node& n = tape_->nodes[stack.back()];
                stack.pop_back();
                if (n.kind == operation::load) {
                    needed_[n.a] = true;
                    continue;
                }
                stack.push_back(n.a);
                if (n.kind == operation::add)
                    stack.push_back(n.b);
            }
        }
    }

    /// f(summand) for what is added up in a node, from the left; a node that is no sum is one summand.
    template <class F>
    void for_summands(std::uint32_t n, const F& f) const
    {
        const node& sum = tape_->nodes[n];
        if (sum.kind != operation::add)
            return f(n);
        for_summands(sum.a, f);
        f(sum.b);
    }
    [[nodiscard]] bool is_sum_of_values(std::uint32_t n) const
    {
        const node& sum = tape_->nodes[n];
        return sum.kind == operation::load or
               (sum.kind == operation::add and tape_->nodes[sum.b].kind == operation::load and is_sum_of_values(sum.a));
    }

    /// The place of an operand. Precondition: what is no value has been made.
    [[nodiscard]] place operand(std::uint32_t n) const
    {
        const node& o = tape_->nodes[n];
        return o.kind == operation::load ? place_[o.a] : place_of_node_[n];
    }
    void make_operand(std::uint32_t n)
    {
        if (tape_->nodes[n].kind != operation::load)
            place_of_node_[n] = make(n);
    }

    /// Appends what makes a node, and before it what that needs and is no value; its place.
    place make(std::uint32_t n)
    {
        const node& root = tape_->nodes[n];
        const bool is_scaled = root.kind == operation::scale and not is_sum_of_values(root.a);
        const std::uint32_t sum = is_scaled ? root.a : n;
        for_summands(sum, [&](std::uint32_t summand) {
            if (const node& s = tape_->nodes[summand]; s.kind == operation::scale)
                for_summands(s.a, [&](std::uint32_t o) { make_operand(o); });
            else
                make_operand(summand);
        });
        const std::size_t first = terms_.size();
        const auto append = [&](std::uint32_t o) {
            places_read_.push_back(operand(o));
            ++terms_.back().count;
        };
        for_summands(sum, [&](std::uint32_t summand) {
            if (const node& s = tape_->nodes[summand]; s.kind == operation::scale) {
                terms_.push_back({s.weight, 0, true});
                for_summands(s.a, append);
            } else {
                if (terms_.size() == first or terms_.back().is_scaled)
                    terms_.push_back({0, 0, false});
                append(summand);
            }
        });
        values_.push_back({is_scaled ? root.weight : 0, std::uint16_t(terms_.size() - first), 0, is_scaled});
        made_.push_back(places_);
        return places_++;
    }

    /// Gives places slots, one to several that do not live at the same time, so that they fit the nearest cache.
    void share_slots(std::span<const std::uint32_t> outputs)
    {
        constexpr std::size_t never = 0, always = std::numeric_limits<std::size_t>::max();
        std::vector<std::size_t> last_read(places_, never); // by which value, counted from 1
        const auto for_operands = [&](const auto& f) {
            std::size_t next = 0, t = 0;
            for (std::size_t i = 0; i < values_.size(); ++i) {
                const std::size_t begin = next;
                for (unsigned more = 0; more < values_[i].terms; ++more, ++t)
                    next += terms_[t].count;
                f(i, std::span(places_read_).subspan(begin, next - begin));
            }
        };
        for_operands([&](std::size_t i, std::span<const place> read) {
            for (const place p : read)
                last_read[p] = i + 1;
        });
        for (const std::uint32_t v : outputs)
            last_read[place_[v]] = always;
        std::vector<std::size_t> slot_of(places_, 0), free;
        for (; slots_ < inputs_.size(); ++slots_)
            slot_of[slots_] = slots_;
        for_operands([&](std::size_t i, std::span<const place> read) {
            for (const place p : read) {
                operands_.push_back(slot(slot_of[p]));
                if (last_read[p] == i + 1) {
                    free.push_back(slot_of[p]);
                    last_read[p] = always; // once
                }
            }
            if (free.empty())
                free.push_back(slots_++);
            slot_of[made_[i]] = free.back();
            free.pop_back();
            values_[i].target = slot(slot_of[made_[i]]);
        });
        for (const std::uint32_t v : outputs)
            outputs_.push_back(slot(slot_of[place_[v]]));
        made_ = {};
        places_read_ = {};
    }

    std::vector<value> values_;
    std::vector<term> terms_;
    std::vector<slot> operands_, outputs_;
    std::vector<std::uint32_t> inputs_;
    std::size_t slots_ = 0;

    // While it is made:
    const tape<Scalar>* tape_ = nullptr;
    std::vector<bool> needed_;
    std::vector<place> place_, place_of_node_, places_read_, made_;
    place places_ = 0;
};

} // namespace kith
