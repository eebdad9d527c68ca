// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

/// The text of the error of this type that f throws; "no error" if it throws none.
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
