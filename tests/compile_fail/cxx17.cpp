// SPDX-License-Identifier: BSD-3-Clause
#include <kith/kith.hpp>
