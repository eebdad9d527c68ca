// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lane_program.hpp"
#include "tape.hpp"

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace kith {

/// A maker of programs from tapes. It makes one after the other in the same memory.
template <std::floating_point Scalar>
class lane_program_maker {
public:
    /// Returns the program that computes some values of a tape, the outputs. Cost: O(nodes that the outputs need), and
    /// one look at every 64 values of the tape.
    [[nodiscard]] lane_program<Scalar> make(const tape<Scalar>& from, std::span<const std::uint32_t> outputs)
    {
        tape_ = &from;
        places_ = 0;
        for (auto* list : {&inputs_, &places_read_, &made_})
            list->clear();
        values_.clear();
        terms_.clear();
        mark_needed(outputs);
        place_.resize(from.values.size());
        place_of_node_.resize(from.nodes.size());
        needed_values_.for_members([&](std::uint32_t v) {
            if (from.values[v] == tape<Scalar>::none) {
                inputs_.push_back(v);
                place_[v] = places_++;
            } else if (const node& root = from.nodes[from.values[v]]; root.kind == operation::load) {
                place_[v] = place_[root.a];
            } else {
                place_[v] = make_node(from.values[v]);
            }
        });
        return with_slots(outputs);
    }

private:
    using program = lane_program<Scalar>;
    using slot = typename program::slot;
    using node = typename tape<Scalar>::node;
    using operation = typename tape<Scalar>::operation;
    using place = std::uint32_t; ///< of a value before slots are assigned; several places may share a slot

    /// A set of numbers below a bound.
    class number_set {
    public:
        void restart(std::size_t bound) { words_.assign(bound / bits + 1, 0); }
        /// Inserts a number. Returns true if it was not in the set before.
        bool insert(std::uint32_t number)
        {
            const std::uint64_t bit = std::uint64_t(1) << number % bits;
            return (std::exchange(words_[number / bits], words_[number / bits] | bit) & bit) == 0;
        }
        /// Calls f(number) for each number in the set, in increasing order.
        template <class F>
        void for_members(const F& f) const
        {
            for (std::size_t w = 0; w < words_.size(); ++w)
                for (std::uint64_t left = words_[w]; left != 0; left &= left - 1)
                    f(std::uint32_t(bits * w) + std::uint32_t(std::countr_zero(left)));
        }

    private:
        static constexpr std::size_t bits = 64;
        std::vector<std::uint64_t> words_;
    };

    void mark_needed(std::span<const std::uint32_t> outputs)
    {
        needed_values_.restart(tape_->values.size());
        needed_nodes_.restart(tape_->nodes.size());
        waiting_.clear();
        const auto need_node = [&](std::uint32_t n) {
            if (needed_nodes_.insert(n))
                waiting_.push_back(n);
        };
        const auto need = [&](std::uint32_t value) {
            if (const std::uint32_t root = tape_->values[value];
                needed_values_.insert(value) and root != tape<Scalar>::none)
                need_node(root);
        };
        for (const std::uint32_t v : outputs)
            need(v);
        while (not waiting_.empty()) {
            const node& of = tape_->nodes[waiting_.back()];
            waiting_.pop_back();
            if (of.kind == operation::load) {
                need(of.a);
                continue;
            }
            need_node(of.a);
            if (of.kind == operation::add)
                need_node(of.b);
        }
    }

    /// Calls f(summand) for each summand of a node, from the left. A node that is no sum is its own only summand.
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

    /// Returns the place of an operand. Precondition: unless it is a load, the operand has been made.
    [[nodiscard]] place operand(std::uint32_t n) const
    {
        const node& o = tape_->nodes[n];
        return o.kind == operation::load ? place_[o.a] : place_of_node_[n];
    }
    void make_operand(std::uint32_t n)
    {
        if (tape_->nodes[n].kind != operation::load)
            place_of_node_[n] = make_node(n);
    }

    /// Appends the operations that make a node, after those of its operands that are no loads. Returns the place of the
    /// node.
    place make_node(std::uint32_t n)
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

    /// Returns the program, after assigning slots to places. Places that are not alive at the same time share a slot,
    /// so that the slots fit the nearest cache.
    [[nodiscard]] program with_slots(std::span<const std::uint32_t> outputs)
    {
        constexpr std::uint32_t never = 0, always = std::numeric_limits<std::uint32_t>::max();
        last_read_.assign(places_, never); // by which value of the program, counted from 1
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
                last_read_[p] = std::uint32_t(i + 1);
        });
        for (const std::uint32_t v : outputs)
            last_read_[place_[v]] = always;

        program made;
        made.inputs_.assign(inputs_.begin(), inputs_.end());
        made.operands_.reserve(places_read_.size());
        slot_of_.resize(places_);
        for (; made.slots_ < inputs_.size(); ++made.slots_)
            slot_of_[made.slots_] = std::uint32_t(made.slots_);
        free_.clear();
        for_operands([&](std::size_t i, std::span<const place> read) {
            for (const place p : read) {
                made.operands_.push_back(slot(slot_of_[p]));
                if (last_read_[p] == i + 1) {
                    free_.push_back(slot_of_[p]);
                    last_read_[p] = always; // so that the slot is freed once
                }
            }
            if (free_.empty())
                free_.push_back(std::uint32_t(made.slots_++));
            slot_of_[made_[i]] = free_.back();
            free_.pop_back();
            values_[i].target = slot(slot_of_[made_[i]]);
        });
        made.outputs_.reserve(outputs.size());
        for (const std::uint32_t v : outputs)
            made.outputs_.push_back(slot(slot_of_[place_[v]]));
        made.values_.assign(values_.begin(), values_.end());
        made.terms_.assign(terms_.begin(), terms_.end());
        return made;
    }

    const tape<Scalar>* tape_ = nullptr;
    number_set needed_values_, needed_nodes_;
    std::vector<std::uint32_t> waiting_; // nodes whose operands are to be marked
    std::vector<typename program::value> values_;
    std::vector<typename program::term> terms_;
    std::vector<std::uint32_t> inputs_;
    std::vector<place> place_, place_of_node_;              // of values, of nodes
    std::vector<place> places_read_, made_;                 // of each operand, of each value of the program
    std::vector<std::uint32_t> last_read_, slot_of_, free_; // by place; slots
    place places_ = 0;
};

} // namespace kith
