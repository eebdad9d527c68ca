// SPDX-License-Identifier: BSD-3-Clause
#include "compile_scheme.hpp"

int main()
{
    compile_scheme([](const auto& coarse, const auto& assoc) {
        for_each(coarse.edges(), [&](auto e) { assoc(e, E) = average(e.org(), e.dst()); });
    });
}
