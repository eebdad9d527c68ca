// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "communicator.hpp"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

namespace kith::mpi {

/// A session of MPI from the beginning of main to its end. An exception that leaves it ends all ranks, since waiting
/// for the others would hang.
class session {
public:
    /// Starts MPI. Ends all ranks if MPI does not allow threads besides the one that calls it. Collective. Errors:
    /// mpi::error.
    session(int& count, char**& arguments)
    {
        int provided = 0;
        detail::check(MPI_Init_thread(&count, &arguments, MPI_THREAD_FUNNELED, &provided), "MPI_Init_thread");
        if (provided < MPI_THREAD_FUNNELED)
            abort("kith: this MPI does not allow threads beside the one that calls it");
        std::set_terminate([] {
            std::fputs(("kith: ended by an uncaught error" + reason() + "\n").c_str(), stderr);
            MPI_Abort(MPI_COMM_WORLD, failure_code);
        });
    }
    session(const session&) = delete;
    session& operator=(const session&) = delete;
    /// Ends MPI. Collective; during stack unwinding it ends all ranks instead.
    ~session()
    {
        if (std::uncaught_exceptions() > 0)
            MPI_Abort(MPI_COMM_WORLD, failure_code);
        MPI_Finalize();
    }

    /// Prints the message and ends all ranks at once. Local.
    [[noreturn]] static void abort(const std::string& message)
    {
        std::fputs((message + "\n").c_str(), stderr);
        std::fflush(stderr);
        MPI_Abort(MPI_COMM_WORLD, failure_code);
        std::abort();
    }
    static constexpr int failure_code = 70;

private:
    /// Returns ": " and the text of the exception that ends the program, or an empty string if there is no text.
    static std::string reason() noexcept
    {
        try {
            if (const auto error = std::current_exception())
                std::rethrow_exception(error);
        } catch (const std::exception& error) {
            return std::string(": ") + error.what();
        } catch (...) {
            return "";
        }
        return "";
    }
};

} // namespace kith::mpi
