// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/in_library.hpp>

#include <array>
#include <chrono>
#include <cstddef>
#include <string_view>

namespace kith {

/// The phases of a refinement for which time is measured.
enum class phase : unsigned char { read, partition, cut, send, refine, write, wait };
inline constexpr std::array<std::string_view, 7> phase_names{
    "read", "partition", "cut", "send", "refine", "write", "wait"};

/// Wall-clock seconds by phase.
class phase_seconds {
public:
    [[nodiscard]] double& operator[](phase p) { return seconds_[std::size_t(p)]; }
    [[nodiscard]] double operator[](phase p) const { return seconds_[std::size_t(p)]; }
    [[nodiscard]] const std::array<double, phase_names.size()>& all() const { return seconds_; }
    [[nodiscard]] double sum() const
    {
        double result = 0;
        for (const double seconds : seconds_)
            result += seconds;
        return result;
    }
    phase_seconds& operator+=(const phase_seconds& more) { return add(more, 1); }
    /// Adds the seconds of phases that ran on `threads` threads at once, divided by `threads`.
    phase_seconds& add(const phase_seconds& more, std::size_t threads)
    {
        for (std::size_t p = 0; p < seconds_.size(); ++p)
            seconds_[p] += more.seconds_[p] / double(threads);
        return *this;
    }

private:
    std::array<double, phase_names.size()> seconds_{};
};

/// A clock that tells the seconds since its construction.
class stopwatch {
public:
    [[nodiscard]] double seconds() const
    {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    }

private:
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// A timer that adds the time of its life to the seconds of a phase.
class phase_timer {
public:
    explicit phase_timer(double& seconds) : seconds_(seconds) {}
    phase_timer(const phase_timer&) = delete;
    phase_timer& operator=(const phase_timer&) = delete;
    ~phase_timer() { seconds_ += since_.seconds(); }

private:
    double& seconds_;
    stopwatch since_;
};

/// Calls f, adds the time to `seconds` and returns the result of f.
template <class F>
decltype(auto) timed(double& seconds, const F& f)
{
    const phase_timer timer(seconds);
    return f();
}

} // namespace kith
