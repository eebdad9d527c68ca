// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Every header of kith includes this one first. The include below ends the compilation: after an #error the compiler
// would go on and print thousands of errors about C++20 keywords.
#if __cplusplus < 202002L
#error "kith needs C++20: compile with -std=c++20 or newer; in CMake link kith's targets, or set CMAKE_CXX_STANDARD 20"
#include <kith_needs_-std=c++20>
#endif

// Functions that are neither templates nor time-critical, such as those that compose error messages, are compiled once
// if a program links kith::compiled_schemes. Their headers define them with KITH_IN_LIBRARY, inside #ifdef
// KITH_HAS_BODIES.
#ifdef KITH_COMPILED_SCHEMES
#define KITH_IN_LIBRARY
#else
#define KITH_IN_LIBRARY inline
#define KITH_HAS_BODIES
#endif
