// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mpi_header.hpp"

#include <kith/tiles/part/phase_seconds.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <thread>

namespace kith::mpi {

/// The error of a call to MPI that failed, or of a message for which there is no memory.
struct error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

namespace detail {

inline void check(int code, const char* call)
{
    if (code == MPI_SUCCESS)
        return;
    char text[MPI_MAX_ERROR_STRING] = "";
    int length = 0;
    MPI_Error_string(code, text, &length);
    throw error(std::string(call) + ": " + std::string(text, std::size_t(length)));
}

/// Waits until `is_done()` returns true; each call lets MPI progress. It spins for a tenth of a millisecond, as most
/// answers come soon. Then it sleeps between two calls, for an eighth of the time that has passed, at most a
/// millisecond: MPI's own wait takes a whole processor. Adds the time to `seconds`.
template <class IsDone>
void wait_until(double& seconds, const IsDone& is_done)
{
    constexpr double spin = 1e-4, longest = 1e-3;
    const phase_timer timer(seconds);
    const stopwatch since;
    while (not is_done())
        if (const double waited = since.seconds(); waited > spin)
            std::this_thread::sleep_for(std::chrono::duration<double>(std::min(longest, waited / 8)));
}
inline void wait_for(MPI_Request request, double& seconds, const char* call)
{
    wait_until(seconds, [&] {
        int is_done = 0;
        check(MPI_Test(&request, &is_done, MPI_STATUS_IGNORE), call);
        return is_done != 0;
    });
}

} // namespace detail

/// Returns the name of the machine that this rank runs on. Local. Errors: mpi::error.
inline std::string host_name()
{
    std::array<char, MPI_MAX_PROCESSOR_NAME> name{};
    int length = 0;
    detail::check(MPI_Get_processor_name(name.data(), &length), "MPI_Get_processor_name");
    return {name.data(), std::size_t(length)};
}

} // namespace kith::mpi
