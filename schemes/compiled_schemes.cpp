// SPDX-License-Identifier: BSD-3-Clause
#define KITH_COMPILE_SCHEMES
#include <kith/compiled_schemes.hpp>
