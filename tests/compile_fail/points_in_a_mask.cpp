// SPDX-License-Identifier: BSD-3-Clause
#include "compile_scheme.hpp"

#ifndef MASK
#define MASK average(e.org().point(), e.dst().point())
#endif

int main()
{
    compile_scheme(
        [](const auto& coarse, const auto& assoc) { for_each(coarse.edges(), [&](auto e) { assoc(e, V) = MASK; }); });
}
