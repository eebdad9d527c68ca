// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/program_options.hpp>

#include <exception>
#include <iostream>

namespace kith::comparison {

/// Runs `program` and returns the exit code for `main`: 0 on success, 2 for wrong options, 1 for other exceptions.
/// Prints the message of an exception.
template <class Program>
int exit_code_of(const Program& program)
{
    try {
        program();
        return 0;
    } catch (const boost::program_options::error& error) {
        std::cerr << error.what() << '\n';
        return 2;
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
}

} // namespace kith::comparison
