// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "communicator.hpp"

#include <exception>
#include <new>
#include <string>

namespace kith::mpi {

/// Runs `phase` and gives what went wrong, to be told to the others, or nothing; lack of memory has no text of its own.
/// Errors: mpi::error, since then the others cannot be reached. Local if `phase` is.
template <class Phase>
std::string problem_of(const Phase& phase, const char* lack_of_memory = "there is not enough memory")
{
    try {
        phase();
    } catch (const std::bad_alloc&) {
        return lack_of_memory;
    } catch (const error&) {
        throw;
    } catch (const std::exception& failure) {
        const std::string text = failure.what();
        return text.empty() ? "an exception without a text" : text;
    }
    return {};
}

/// Runs one phase on every rank and lets all of them agree on how it went. Collective. Errors: phase_error.
template <class Phase>
void in_agreement(communicator& comm, const Phase& phase)
{
    comm.agree(problem_of(phase));
}

} // namespace kith::mpi
