// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The schemes of the library: KITH_SCHEMES(line) is line(type, header, numbers, paper) for each scheme. `type` is in
/// namespace kith, and `header` is its file without .hpp. `numbers` are the coordinates for which the library has its
/// steps compiled: doubles alone, or floats, too. The compiled library, the program, the dialects, Python and the tests
/// take their lists from here. CMake reads these lines.
// clang-format off
#define KITH_SCHEMES(line)                                                                                             \
    line(catmull_clark, catmull_clark, floats, "Catmull & Clark 1978")                                                 \
    line(loop, loop, floats, "Loop 1987; boundary Hoppe et al. 1994")                                                  \
    line(quad_tri, quad_tri, floats, "Stam & Loop 2003")                                                               \
    line(doo_sabin, doo_sabin, floats, "Doo & Sabin 1978")                                                             \
    line(sqrt3, sqrt3, floats, "Kobbelt 2000")                                                                         \
    line(interpolatory_sqrt3, interpolatory_sqrt3, floats, "Labsik & Greiner 2000")                                    \
    line(butterfly, butterfly, floats, "Dyn, Gregory & Levin 1990; Zorin, Schroeder & Sweldens 1996")                  \
    line(kobbelt, kobbelt, floats, "Kobbelt 1996")                                                                     \
    line(nasri_hasbini, nasri_hasbini, doubles, "Nasri, Hasbini, Zheng & Sederberg; irregular: docs/schemes.md")       \
    line(four_eight, four_eight, floats, "Velho & Zorin 2001")                                                         \
    line(mid_edge, mid_edge, floats, "Peters & Reif 1997")                                                             \
    line(unified, unified, doubles, "Zorin & Schroeder 2001")                                                          \
    line(linear, linear, floats, "midpoints and centroids")                                                            \
    line(linear_triangles, linear, floats, "midpoints")
// clang-format on
