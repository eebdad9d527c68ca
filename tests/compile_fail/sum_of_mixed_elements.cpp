// SPDX-License-Identifier: BSD-3-Clause
#include "compile_scheme.hpp"

int main()
{
    compile_scheme([](const auto& coarse, const auto& assoc) {
        for_each(coarse.edges(), [&](auto e) { assoc(e, V) = sum(e.org(), e.lface()); });
    });
}
