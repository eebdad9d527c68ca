// SPDX-License-Identifier: BSD-3-Clause
#include <kith/tri_quad.hpp>

#define KITH_COMPILE_HERE
#define KITH_SCHEME detail::centroid_split
#include <kith/schemes/compiled/in_library.hpp>
#define KITH_SCHEME detail::diagonal_split
#include <kith/schemes/compiled/in_library.hpp>
