// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/base/affine.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace kith {

/// What a scheme's text did to its operands, in order: each operation is a node, each value the node that it was stored
/// from. A tape knows no numbers but the weights, so that what was recorded on one part of a mesh can be replayed on
/// all parts that look alike, operation by operation, to the same bits.
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
    std::vector<std::uint32_t> values; ///< its node; none for those that were there before

    std::uint32_t push(const node& n)
    {
        nodes.push_back(n);
        return std::uint32_t(nodes.size() - 1);
    }
    /// Begins anew, in the same memory, with values that are there before.
    void restart(std::size_t inputs)
    {
        nodes.clear();
        values.assign(inputs, none);
    }
};

namespace detail {

/// Where this thread records.
template <std::floating_point Scalar>
constinit inline thread_local tape<Scalar>* recording_on = nullptr;

} // namespace detail

/// Records on a tape while it lives.
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

/// The number of a value on the tape. Its copy constructor is not trivial, because loops over such values run on one
/// thread, and a tape belongs to a thread.
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
