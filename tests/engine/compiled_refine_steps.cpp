// SPDX-License-Identifier: BSD-3-Clause
#define KITH_COMPILE_SCHEMES
#include "compiled_refine.hpp"
