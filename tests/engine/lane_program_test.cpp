// SPDX-License-Identifier: BSD-3-Clause
#include <kith/engine/lane/lane_program_maker.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace {

using value = kith::recorded<double>;
using record = kith::affine<value>;
using tape_type = kith::tape<double>;

/// A sum that adds and scales numbers and records the same operations.
struct twin {
    record::sum recorded;
    double number;

    friend twin operator+(twin a, const twin& b)
    {
        record::add(a.recorded, b.recorded);
        a.number += b.number;
        return a;
    }
    friend twin operator*(double weight, twin a)
    {
        record::scale(a.recorded, weight);
        a.number *= weight;
        return a;
    }
};

/// Input values and computed values, both as numbers and on the tape.
class twins {
public:
    explicit twins(std::size_t inputs) : recording_(tape)
    {
        std::mt19937 random(7);
        for (std::size_t i = 0; i < inputs; ++i) {
            numbers.push_back(std::generate_canonical<double, 53>(random) - .5);
            tape.values.push_back(tape_type::none);
        }
    }
    [[nodiscard]] twin operator[](std::size_t i) const { return {record::load(value(std::uint32_t(i))), numbers[i]}; }
    std::uint32_t store(const twin& t)
    {
        numbers.push_back(t.number);
        return record::store(t.recorded).value;
    }

    tape_type tape;
    std::vector<double> numbers;

private:
    kith::recording<double> recording_;
};

template <std::size_t Bytes>
using pack = typename kith::lanes<double, Bytes>::type;

KITH_LANES_OF_16_BYTES void run_16(const kith::lane_program<double>& program, double* slots)
{
    program.run<1, 16>(reinterpret_cast<pack<16>*>(slots));
}
#if defined(__x86_64__)
KITH_LANES_OF_32_BYTES void run_32(const kith::lane_program<double>& program, double* slots)
{
    program.run<1, 32>(reinterpret_cast<pack<32>*>(slots));
}
KITH_LANES_OF_64_BYTES void run_64(const kith::lane_program<double>& program, double* slots)
{
    program.run<1, 64>(reinterpret_cast<pack<64>*>(slots));
}
#endif

/// Expects right outputs in each of `Width` lanes. Lane k has the inputs times 2 to the power of k, which does not
/// change rounding.
template <std::size_t Width, class Run>
void expect_outputs_in_lanes(const twins& t, const std::vector<std::uint32_t>& outputs, const Run& run_program)
{
    const auto program = kith::lane_program_maker<double>().make(t.tape, outputs);
    alignas(64) std::array<double, 64 * Width> slots{};
    ASSERT_LE(program.slots(), 64U);
    for (std::size_t i = 0; i < program.inputs().size(); ++i)
        for (std::size_t lane = 0; lane < Width; ++lane)
            slots[i * Width + lane] = std::ldexp(t.numbers[program.inputs()[i]], int(lane));
    run_program(program, slots.data());
    for (std::size_t i = 0; i < outputs.size(); ++i)
        for (std::size_t lane = 0; lane < Width; ++lane)
            EXPECT_EQ(slots[program.outputs()[i] * Width + lane], std::ldexp(t.numbers[outputs[i]], int(lane)))
                << "output " << i << ", lane " << lane << " of " << Width;
}

void expect_outputs(const twins& t, const std::vector<std::uint32_t>& outputs)
{
    expect_outputs_in_lanes<kith::lanes<double, 16>::count>(t, outputs, run_16);
#if defined(__x86_64__)
    if (kith::lane_bytes() >= 32)
        expect_outputs_in_lanes<kith::lanes<double, 32>::count>(t, outputs, run_32);
    if (kith::lane_bytes() >= 64)
        expect_outputs_in_lanes<kith::lanes<double, 64>::count>(t, outputs, run_64);
#endif
}

TEST(lane_program, makes_sums_of_weighted_sums)
{
    twins v(6);
    const auto a = v.store(1. / 3 * (v[0] + v[1] + v[2]));
    const auto b = v.store(.7 * v[3] + 1. / 7 * (v[1] + v[4] + v[a]));
    const auto c = v.store(v[0] + v[b] + .1 * v[2] + v[5] + v[1]);
    const auto d = v.store(1. / 9 * (.3 * (v[0] + v[1]) + v[c]));
    expect_outputs(v, {a, b, c, d});
}

TEST(lane_program, keeps_the_order_of_nested_sums)
{
    twins v(6);
    const auto a = v.store(v[0] + (v[1] + v[2]));
    const auto b = v.store(.9 * (v[0] + .3 * (v[1] + (v[2] + v[3]))) + .1 * (.2 * v[4]));
    const auto c = v.store(.3 * (.7 * (v[a] + .1 * v[b])));
    expect_outputs(v, {c, a, b});
}

TEST(lane_program, knows_copies_and_leaves_out_what_nobody_needs)
{
    twins v(6);
    const auto unused = v.store(.5 * (v[4] + v[5]));
    const auto copy = v.store(v[1]);
    const auto a = v.store(.3 * v[copy] + .7 * v[0]);
    v.store(v[unused] + v[a]);
    const auto program = kith::lane_program_maker<double>().make(v.tape, std::vector<std::uint32_t>{a, copy});
    EXPECT_EQ(std::vector<std::uint32_t>(program.inputs().begin(), program.inputs().end()),
              (std::vector<std::uint32_t>{0, 1}));
    EXPECT_EQ(program.slots(), 2U); // the first operand makes room for the result
    expect_outputs(v, {a, copy});
}

TEST(lane_program, does_not_depend_on_what_its_maker_has_made_before)
{
    kith::lane_program_maker<double> maker;
    twins v(4);
    const auto a = v.store(.25 * (v[0] + v[1] + v[2]) + .75 * v[3]);
    twins w(3);
    const auto b = w.store(.5 * (w[1] + w[2]));
    const std::vector<std::uint32_t> of_v{a}, of_w{b};
    const auto first = maker.make(v.tape, of_v);
    const auto second = maker.make(w.tape, of_w);
    const auto alone = kith::lane_program_maker<double>().make(w.tape, of_w);
    EXPECT_EQ(first.inputs().size(), 4U);
    EXPECT_EQ(std::vector<std::uint32_t>(second.inputs().begin(), second.inputs().end()),
              (std::vector<std::uint32_t>{1, 2}));
    EXPECT_EQ(second.slots(), alone.slots());
    EXPECT_EQ(second.bytes(), alone.bytes());
}

TEST(lane_program, shares_slots_of_values_that_nobody_reads_any_more)
{
    twins v(2);
    std::uint32_t a = 0, b = 1;
    for (int i = 0; i < 40; ++i) {
        const auto c = v.store(.6 * v[a] + .3 * v[b]);
        a = b;
        b = c;
    }
    EXPECT_LE(kith::lane_program_maker<double>().make(v.tape, std::vector<std::uint32_t>{b}).slots(), 3U);
    expect_outputs(v, {b});
}

} // namespace
