// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

/// Returns the text of the error of type `Error` that f throws; "no error" if f throws nothing.
template <class Error, class F>
std::string error_text(const F& f)
{
    try {
        f();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}
