// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "communicator.hpp"

#include <kith/core/base/error.hpp>

#include <array>
#include <cstdint>
#include <exception>
#include <new>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

namespace kith::mpi {

/// Runs `phase` and returns its error message, or an empty string. Lack of memory is reported as `lack_of_memory`, or
/// in two words if there is no memory for this text. Local if `phase` is. Errors: mpi::error, since other ranks then
/// cannot be reached.
template <class Phase>
std::string problem_of(const Phase& phase, const char* lack_of_memory = "there is not enough memory")
{
    try {
        try {
            phase();
        } catch (const std::bad_alloc&) {
            return lack_of_memory;
        } catch (const error&) {
            throw;
        } catch (const std::exception& failure) {
            const std::string text = failure.what();
            return text.empty() ? "an exception without a text" : text;
        } catch (...) {
            return "an exception not derived from std::exception";
        }
    } catch (const std::bad_alloc&) {
        return "no memory"; // fits into a string without memory of its own
    }
    return {};
}

/// Runs one phase on every rank and lets all ranks agree on its outcome; returns the result of `phase`. Collective.
/// Errors: phase_error on all ranks if `phase` throws on one.
template <class Phase>
auto collective_phase(communicator& comm, const Phase& phase)
{
    if constexpr (std::is_void_v<std::invoke_result_t<const Phase&>>) {
        comm.agree(problem_of(phase));
    } else {
        std::optional<std::invoke_result_t<const Phase&>> result;
        comm.agree(problem_of([&] { result.emplace(phase()); }));
        return std::move(*result);
    }
}

/// Throws phase_error on all ranks unless a number is the same on all ranks. `what` names it in the message, after
/// `path` if there is one. Collective.
inline void require_same_on_ranks(communicator& comm, std::uint64_t number, const char* what,
                                  const std::string& path = {})
{
    const std::uint64_t on_root = comm.sum(std::array{comm.is_root() ? number : std::uint64_t(0)})[0];
    collective_phase(comm, [&] {
        if (number != on_root)
            throw mesh_error((path.empty() ? path : path + ": ") + what + " on rank " + std::to_string(comm.rank()) +
                             " differs from rank 0; give all ranks the same");
    });
}

} // namespace kith::mpi
