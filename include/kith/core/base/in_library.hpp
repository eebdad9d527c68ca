// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Every header of kith includes this one before it says anything. The include ends the compilation, since a compiler
// goes on after an #error and would add thousands of lines about the words of C++20.
#if __cplusplus < 202002L
#error "kith needs C++20: compile with -std=c++20 or newer; in CMake link kith's targets, or set CMAKE_CXX_STANDARD 20"
#include <kith_needs_-std=c++20>
#endif

// Functions that are no templates and not time-critical, such as the texts of errors, are compiled once if a program
// links kith::compiled_schemes: their headers define them KITH_IN_LIBRARY, and only #ifdef KITH_HAS_BODIES.
#ifdef KITH_COMPILED_SCHEMES
#define KITH_IN_LIBRARY
#else
#define KITH_IN_LIBRARY inline
#define KITH_HAS_BODIES
#endif
