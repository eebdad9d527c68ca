// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/affine.hpp>
#include <kith/core/base/storage.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace kith {

/// A record of the operations that a scheme performs on its operands, in order. Each operation is a node, and each
/// value refers to the node from which it was stored. A tape contains no numbers but the weights. What was recorded on
/// one part of a mesh can therefore be replayed on all parts that look alike, to the same bits.
template <std::floating_point Scalar>
struct tape {
    enum class operation : unsigned char { load, add, scale };
    struct node {
        operation kind;
        std::uint32_t a; ///< the value that is loaded, or the node that is added to or scaled
        std::uint32_t b; ///< the node that is added
        Scalar weight;
    };
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    std::vector<node> nodes;
    std::vector<std::uint32_t> values; ///< the node of each value; none for inputs

    std::uint32_t push(const node& n)
    {
        nodes.push_back(n);
        return std::uint32_t(nodes.size() - 1);
    }
    /// Begins anew in the same memory, with `inputs` values that exist before the first operation.
    void restart(std::size_t inputs)
    {
        nodes.clear();
        values.assign(inputs, none);
    }
};

namespace detail {

/// The tape on which this thread records.
template <std::floating_point Scalar>
constinit inline thread_local tape<Scalar>* recording_on = nullptr;

} // namespace detail

/// A guard during whose lifetime this thread records on a tape.
template <std::floating_point Scalar>
class recording {
public:
    explicit recording(tape<Scalar>& to) : before_(detail::recording_on<Scalar>) { detail::recording_on<Scalar> = &to; }
    recording(const recording&) = delete;
    recording& operator=(const recording&) = delete;
    ~recording() { detail::recording_on<Scalar> = before_; }

private:
    tape<Scalar>* before_;
};

/// A player that computes the values of a tape from numbers or arrays of numbers, one operation after the other. The
/// results have the bits of the recorded code.
template <class Point>
class tape_player {
    using scalar = typename affine<Point>::scalar;
    using sum = typename affine<Point>::sum;

public:
    /// Plays a tape with `before` as its inputs. They must outlive the calls of value(). Cost: O(nodes).
    void play(const tape<scalar>& played, std::span<const Point> before)
    {
        using operation = typename tape<scalar>::operation;
        played_ = &played;
        before_ = before;
        ensure_size(sums_, played.nodes.size());
        sum* to = sums_.data();
        for (const auto& n : played.nodes) {
            if (n.kind == operation::load)
                *to = affine<Point>::load(value(n.a));
            else
                *to = sums_[n.a];
            if (n.kind == operation::add)
                affine<Point>::add(*to, sums_[n.b]);
            else if (n.kind == operation::scale)
                affine<Point>::scale(*to, n.weight);
            ++to;
        }
    }
    /// Returns a value of the tape that was played last, by its number.
    [[nodiscard]] Point value(std::uint32_t number) const
    {
        const std::uint32_t node = played_->values[number];
        return node == tape<scalar>::none ? before_[number] : Point(affine<Point>::store(sums_[node]));
    }

private:
    const tape<scalar>* played_ = nullptr;
    std::span<const Point> before_;
    storage<sum> sums_; // by node
};

/// The number of a value on the tape. Its copy constructor is not trivial, so that loops over such values run on one
/// thread: a tape belongs to a thread.
template <std::floating_point Scalar>
struct recorded {
    std::uint32_t value = tape<Scalar>::none;

    recorded() = default;
    explicit recorded(std::uint32_t value) : value(value) {}
    recorded(const recorded& other) noexcept : value(other.value) {}
    recorded& operator=(const recorded& other) noexcept
    {
        value = other.value;
        return *this;
    }
    ~recorded() = default;
};

template <std::floating_point Scalar>
struct affine<recorded<Scalar>> {
    struct node_number {
        std::uint32_t value = tape<Scalar>::none;
    };
    using scalar = Scalar;
    using sum = node_number;
    using operation = typename tape<Scalar>::operation;

    static sum load(const recorded<Scalar>& r) { return {on().push({operation::load, r.value, 0, 0})}; }
    static recorded<Scalar> store(const sum& total)
    {
        on().values.push_back(total.value);
        return recorded<Scalar>(std::uint32_t(on().values.size() - 1));
    }
    static void add(sum& total, const sum& more)
    {
        total.value = on().push({operation::add, total.value, more.value, 0});
    }
    static void scale(sum& total, Scalar weight)
    {
        total.value = on().push({operation::scale, total.value, 0, weight});
    }

private:
    static tape<Scalar>& on() { return *detail::recording_on<Scalar>; }
};

} // namespace kith
